# Shared by the scripts of this folder: where the project is, what is said, what runs quietly. To be sourced.
set -euo pipefail

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
jobs="$(nproc 2>/dev/null || echo 2)"
# So a clone in another folder finds in the compiler cache what this one has built.
export CCACHE_BASEDIR="${CCACHE_BASEDIR:-$root}" CCACHE_NOHASHDIR="${CCACHE_NOHASHDIR:-1}"

say() { printf '==> %s\n' "$*"; }

fail() {
  printf 'error: %s\n' "$*" >&2
  exit 1
}

# quiet LOG SENTENCE COMMAND...: runs a command with its output in LOG; shows the end of it and the sentence if it fails.
quiet() {
  local log="$1" sentence="$2"
  shift 2
  mkdir -p "$(dirname "$log")"
  if ! "$@" >"$log" 2>&1; then
    tail -n 60 "$log" >&2
    fail "$sentence The whole output is in $log."
  fi
}

# build PRESET TARGET...: configures a preset of CMakePresets.json and builds targets (all of it without any).
build() {
  local preset="$1"
  shift
  say "Configuring (build/$preset)"
  (cd "$root" && quiet "$root/build/$preset/configure.log" "The configuration of the build failed." cmake --preset "$preset")
  say "Building $([ $# -gt 0 ] && echo "$*" || echo "everything") with $jobs jobs; the first time takes minutes, then only what changed"
  quiet "$root/build/$preset/build.log" "The build failed." cmake --build "$root/build/$preset" --parallel "$jobs" ${1:+--target "$@"}
}
