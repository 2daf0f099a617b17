#!/usr/bin/env bash
# Installs the Debian and Ubuntu packages that the project needs and that are not there yet.
#   dependencies.sh         what building, running and testing take
#   dependencies.sh lint    what packaging/lint takes on top
#   dependencies.sh fuzz    what packaging/fuzz takes on top
#   dependencies.sh package what packaging/package and packaging/try-package take on top
#   dependencies.sh pictures    what packaging/screenshots takes on top for the manual
# Works as root or with sudo, on Debian 12 and Ubuntu 24.04. Does nothing, and takes no time, when all is there.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# The one list of what is needed.
packages=(
  g++ cmake ninja-build ccache mold pkg-config
  qt6-base-dev libqt6opengl6-dev qt6-svg-dev qt6-charts-dev libopenscenegraph-dev libegl-dev libgl-dev libgl1-mesa-dri libegl-mesa0
  libqt6svg6 fonts-dejavu-core xvfb xauth
  libeigen3-dev libgdal-dev libproj-dev gdal-bin libxml2-utils gpsbabel libgeographiclib-dev
  nlohmann-json3-dev libcli11-dev libexpected-dev libfmt-dev libvalijson-dev
  libssl-dev zlib1g-dev libpugixml-dev libbenchmark-dev poppler-utils
  libboost-dev libnlopt-cxx-dev
  libmd4c-dev libmd4c-html0-dev
  qt6-l10n-tools qt6-translations-l10n locales
  mandoc shared-mime-info
)

is_installed() { [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null || true)" = installed ]; }

# No pipe into grep -q: it stops reading early, apt-cache then fails by SIGPIPE, and pipefail makes that a no.
is_offered() { [[ "$(apt-cache policy "$1" 2>/dev/null)" =~ Candidate:\ [^\(] ]]; }

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  else
    sudo "$@"
  fi
}

update_lists() {
  say "Fetching the package lists"
  # apt-get calls it a success when sources cannot be reached and old lists, or none, remain; so its words are read.
  if ! as_root apt-get -qq update >"$log" 2>&1 || grep -q 'Failed to fetch' "$log"; then
    lists_are_old=yes
  fi
}

# unavailable SENTENCE: says why packages are not there; a failed fetch of the lists is the likelier reason.
unavailable() {
  tail -n 6 "$log" >&2
  [ "$lists_are_old" = no ] || fail "$1 The package lists could not be fetched either; is this machine online?"
  fail "$1"
}

command -v dpkg-query >/dev/null || fail "This is neither Debian nor Ubuntu; install what corresponds to these packages: ${packages[*]}"

if [ "${1:-}" = lint ]; then
  # Version 14 is the one that the settings were made for; later Ubuntu releases have a newer one only.
  if is_installed clang-tidy-14 || is_offered clang-tidy-14; then
    packages+=(clang-tidy-14)
  else
    packages+=(clang-tidy)
  fi
fi

if [ "${1:-}" = pictures ]; then
  packages+=(pngquant)
fi

if [ "${1:-}" = fuzz ]; then
  # clang with libFuzzer and the sanitizers, which are in its compiler-rt
  if is_installed libclang-rt-14-dev || is_offered libclang-rt-14-dev; then
    packages+=(clang-14 libclang-rt-14-dev)
  else
    version="$(apt-cache depends clang 2>/dev/null | sed -n 's/.*Depends: clang-\([0-9]*\)$/\1/p')"
    packages+=(clang "libclang-rt-$version-dev")
  fi
fi

if [ "${1:-}" = package ]; then
  packages+=(dpkg-dev fakeroot lintian desktop-file-utils appstream mmdebstrap imagemagick)
fi

missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  exit 0
fi

command -v apt-get >/dev/null || fail "apt-get is not there, so these packages have to be installed by hand: ${missing[*]}"
[ "$(id -u)" -eq 0 ] || command -v sudo >/dev/null ||
  fail "Packages are missing (${missing[*]}) and this user may not install them; run this as root or install sudo."

log="$(mktemp)"
trap 'rm -f "$log"' EXIT
lists_are_old=no
for package in "${missing[@]}"; do
  if ! is_offered "$package"; then
    update_lists
    break
  fi
done
for package in "${missing[@]}"; do
  is_offered "$package" || unavailable "The package $package is not offered by this machine's package sources; on Ubuntu, 'universe' must be enabled."
done

say "Installing ${#missing[@]} packages: ${missing[*]}"
install() { as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"; }
if ! install >"$log" 2>&1; then
  update_lists # the lists may name versions that the servers no longer have
  install >"$log" 2>&1 || true
fi
for package in "${missing[@]}"; do
  is_installed "$package" || unavailable "The package $package could not be installed; see the lines above."
done
