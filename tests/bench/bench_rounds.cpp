// The lazy rounds of the tour solver without terrain: the costs of a GTSPLIB file stand for terrain segments, made-up dearer
// ones for the safe segments, and rounds go on until the tour has only those ([1] Algorithm 4). One line for each file and
// seed, as JSON for packaging/bench.
//   bench_rounds [--fresh] [--effort E] [--whole E] [--seeds N] [FILE...]      --fresh: a new solver for every round
// Without files: the Dubins instances of the data folder.

#include "core/tour/gtsp_lib.h"
#include "core/tour/gtsp_solver.h"
#include "tests/bench/bench_support.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace vp::tour;
/// Processor time of this one thread, which other programs do not lengthen.
double milliseconds() {
  return 1e3 * static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

/// Uniform in [0, 1) from up to three numbers (splitmix64).
double hashed(std::uint64_t a, std::uint64_t b, std::uint64_t c) {
  std::uint64_t z = (a * 0x9E3779B97F4A7C15ULL) ^ (b * 0xC2B2AE3D27D4EB4FULL) ^ (c * 0x165667B19E3779F9ULL);
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
}

/// Half of the arcs stay as they are; the others cost up to 60 % more, partly because of where they begin and end.
double safeCost(const GtspProblem& problem, int from, int to, std::uint64_t seed) {
  const auto tail = static_cast<std::uint64_t>(from);
  const auto head = static_cast<std::uint64_t>(to);
  const double places = 0.5 * (hashed(tail, 1, seed) + hashed(head, 2, seed));
  const double own = hashed(tail * 100'003U + head, 3, seed);
  return problem.at(from, to) * (1.0 + 1.2 * std::max(0.0, 0.5 * (places + own) - 0.5));
}

struct Way {
  bool fresh = false;
  double effort = 0.15;
  double whole = 1.0;
};

struct Outcome {
  std::vector<double> rounds_ms;
  int shortSearches = 0;
  int wholeSearches = 0;
  int arcs = 0;
  double cost = 0.0;
  double total_ms = 0.0;
};

Outcome runLazy(const GtspProblem& problem, std::uint64_t seed, const Way& way) {
  Outcome outcome;
  GtspSolver solver(problem);
  std::vector<int> tour;
  std::vector<char> isSafe(problem.cost.size(), 0);
  const double begin = milliseconds();
  // rounds around what changed; when they replace nothing a short whole search, then a long one, which alone ends it
  int stage = 0;
  for (std::uint64_t round = 0;; ++round) {
    GtspOptions options;
    options.seed = seed + round;
    options.wantBound = false;
    options.effort = stage == 2 ? way.whole : way.effort;
    options.aroundChanges = stage == 0 && !way.fresh;
    if (way.fresh && !tour.empty()) {
      options.warmStart = tour;
    }
    const double start = milliseconds();
    const auto solution = way.fresh ? solveGtsp(solver.problem(), options, vp::Job()) : solver.solve(options, vp::Job());
    if (stage > 0) {
      ++(stage == 1 ? outcome.shortSearches : outcome.wholeSearches);
    } else {
      outcome.rounds_ms.push_back(milliseconds() - start);
    }
    tour = solution->tour;
    int replaced = 0;
    for (std::size_t i = 0; i < tour.size(); ++i) {
      const int from = tour[i];
      const int to = tour[(i + 1) % tour.size()];
      const std::size_t at = static_cast<std::size_t>(from) * static_cast<std::size_t>(problem.nodes) + static_cast<std::size_t>(to);
      if (isSafe[at] == 0) {
        isSafe[at] = 1;
        solver.raise(from, to, safeCost(problem, from, to, seed));
        ++replaced;
      }
    }
    outcome.arcs += replaced;
    if (replaced == 0 && stage == 2) {
      outcome.cost = solution->cost;
      outcome.total_ms = milliseconds() - begin;
      return outcome;
    }
    stage = replaced > 0 ? 0 : way.fresh ? 2 : stage + 1;
  }
}

/// The same with all safe costs known from the start (BASE).
double costOfBase(const GtspProblem& problem, std::uint64_t seed) {
  GtspProblem safe = problem;
  for (int from = 0; from < problem.nodes; ++from) {
    for (int to = 0; to < problem.nodes; ++to) {
      safe.cost[static_cast<std::size_t>(from) * static_cast<std::size_t>(problem.nodes) + static_cast<std::size_t>(to)] =
          safeCost(problem, from, to, seed);
    }
  }
  GtspOptions options;
  options.wantBound = false;
  options.effort = problem.sets.size() > 60 ? 0.3 : 3.0;
  const auto solution = solveGtsp(safe, options, vp::Job());
  return solution->cost;
}

void report(const std::string& name, std::uint64_t seed, Outcome outcome, double base) {
  std::sort(outcome.rounds_ms.begin(), outcome.rounds_ms.end());
  const auto quantile = [&](double q) { return outcome.rounds_ms[static_cast<std::size_t>(q * static_cast<double>(outcome.rounds_ms.size() - 1))]; };
  const auto print = [&](const char* metric, double value, const char* unit) {
    fmt::print(R"({{"bench": "lazy rounds {} seed {}", "metric": "{}", "value": {:.6g}, "unit": "{}"}})"
               "\n",
               name, seed, metric, value, unit);
  };
  print("rounds", static_cast<double>(outcome.rounds_ms.size()), "");
  print("short whole searches", outcome.shortSearches, "");
  print("whole searches", outcome.wholeSearches, "");
  print("arcs looked at", outcome.arcs, "");
  print("median of a round", quantile(0.5), "ms");
  print("ninth decile of a round", quantile(0.9), "ms");
  print("all", outcome.total_ms, "ms");
  print("cost over BASE", 100.0 * (outcome.cost / base - 1.0), "%");
  std::fflush(stdout);
}

/// The Dubins instances of the data folder, in the order of their names.
std::vector<std::string> dubinsInstances() {
  const std::string folder = vp::bench::dataFolder();
  std::vector<std::string> files;
  if (folder.empty()) {
    fmt::print(stderr, "bench_rounds: no folder with instances; set VOLPLANE_DATA to the folder that holds gtsp/\n");
    return files;
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder + "/gtsp")) {
    if (entry.path().filename().string().starts_with("dubins_")) {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

int main(int argc, char** argv) {
  Way way;
  std::uint64_t seeds = 1;
  std::vector<std::string> files;
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--fresh") {
      way.fresh = true;
    } else if (words[i] == "--effort" && i + 1 < words.size()) {
      way.effort = std::stod(words[++i]);
    } else if (words[i] == "--whole" && i + 1 < words.size()) {
      way.whole = std::stod(words[++i]);
    } else if (words[i] == "--seeds" && i + 1 < words.size()) {
      seeds = std::stoull(words[++i]);
    } else {
      files.push_back(words[i]);
    }
  }
  if (files.empty()) {
    files = dubinsInstances();
  }
  for (const std::string& file : files) {
    const auto instance = loadGtspLib(file);
    if (!instance) {
      fmt::print(stderr, "{}\n", instance.error().message());
      return 2;
    }
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      report(instance->name, seed, runLazy(instance->problem, seed, way), costOfBase(instance->problem, seed));
    }
  }
  return 0;
}
