// Solves GTSPLIB files and prints one line each: name, cost, seconds to the end of the run, lower bound.
//   bench_tour FILE... [--seconds S] [--seed N]
//   bench_tour --json [--seconds S] [--seed N]   all instances of the folder gtsp beside the checkout's data (or of
//              VOLPLANE_DATA) against best_known.csv there, as lines for packaging/bench; without --seconds each in the time
//              that is asked for it: 50 ms up to 20 sets, Dubins instances 0.5 s (n=40) and 3 s (n=100), the others 5 s

#include "core/tour/gtsp.h"
#include "core/tour/gtsp_lib.h"
#include "tests/bench/bench_support.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace {

template <typename T>
bool readNumber(std::string_view text, T& value) {
  const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), value);
  return ec == std::errc() && end == text.data() + text.size();
}

bool solve(const std::string& file, const vp::tour::GtspOptions& options) {
  const auto instance = vp::tour::loadGtspLib(file);
  if (!instance) {
    fmt::print(stderr, "{}\n", instance.error().message());
    return false;
  }
  const auto start = std::chrono::steady_clock::now();
  const auto solution = vp::tour::solveGtsp(instance->problem, options, vp::Job());
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (!solution) {
    fmt::print(stderr, "{}: {}\n", file, solution.error().message());
    return false;
  }
  fmt::print("{} {:.10g} {:.3f} {:.10g}\n", instance->name, solution->cost, seconds.count(), solution->lowerBound);
  std::fflush(stdout);
  return true;
}

/// Instance name to best known cost, from the first, fourth and fifth column of best_known.csv.
std::map<std::string, double> bestKnown(const std::filesystem::path& folder) {
  std::map<std::string, double> costs;
  std::ifstream file(folder / "best_known.csv");
  for (std::string line; std::getline(file, line);) {
    std::vector<std::string> fields(1);
    for (const char c : line) {
      if (c == ',') {
        fields.emplace_back();
      } else {
        fields.back() += c;
      }
    }
    double cost = 0.0;
    if (fields.size() > 4 && readNumber(fields[4], cost)) {
      costs[fields[0]] = cost;
    }
  }
  return costs;
}

/// What the time of an instance depends on, and how far the worst of each kind is above the best known cost.
struct Kind {
  const char* name;
  double seconds;
  double worst = -INFINITY;    // %
  double slowest = -INFINITY;  // s
  int instances = 0;
};

Kind& kindOf(const std::string& name, std::size_t sets, std::vector<Kind>& kinds) {
  const bool isDubins = name.starts_with("dubins");
  return kinds[sets <= 20 ? 0 : !isDubins ? 1 : sets <= 40 ? 2 : 3];
}

bool solveAsJson(const std::filesystem::path& folder, const std::string& name, double best, vp::tour::GtspOptions options, std::vector<Kind>& kinds) {
  const bool isPlain = std::filesystem::exists(folder / (name + ".gtsp"));
  const auto instance = vp::tour::loadGtspLib((folder / (name + (isPlain ? ".gtsp" : ".gtsp.gz"))).string());
  if (!instance) {
    fmt::print(stderr, "{}\n", instance.error().message());
    return false;
  }
  const std::size_t sets = instance->problem.sets.size();
  Kind& kind = kindOf(name, sets, kinds);
  options.seconds = options.seconds.value_or(kind.seconds);
  const auto start = vp::bench::Clock::now();
  const auto solution = vp::tour::solveGtsp(instance->problem, options, vp::Job());
  const double seconds = vp::bench::secondsSince(start);
  if (!solution) {
    fmt::print(stderr, "{}: {}\n", name, solution.error().message());
    return false;
  }
  const double above = 100.0 * (solution->cost / best - 1.0);
  kind.worst = std::max(kind.worst, above);
  kind.slowest = std::max(kind.slowest, seconds);
  ++kind.instances;
  const std::string bench = fmt::format("tour {} ({} sets)", name, sets);
  vp::bench::print(bench, "cost", solution->cost, "",
                   fmt::format("{:+.2f} % against best known{}", above, solution->optimal ? ", proved optimal" : ""), best);
  vp::bench::print(bench, "seconds", seconds, "s");
  vp::bench::print(bench, "lower bound", solution->lowerBound, "", "", best);
  return true;
}

int solveAllAsJson(const vp::tour::GtspOptions& options) {
  if (vp::bench::dataFolder().empty()) {
    fmt::print(stderr, "bench_tour: no folder with instances; set VOLPLANE_DATA to the folder that holds gtsp/\n");
    return 0;
  }
  const std::filesystem::path folder = vp::bench::dataFolder() + "/gtsp";
  std::vector<Kind> kinds{{"up to 20 sets", 0.05}, {"more than 20 sets", 5.0}, {"dubins n=40", 0.5}, {"dubins n=100", 3.0}};
  for (const auto& [name, best] : bestKnown(folder)) {
    if (!solveAsJson(folder, name, best, options, kinds)) {
      return 2;
    }
  }
  for (const Kind& kind : kinds) {
    const std::string bench = fmt::format("tour solver, {}", kind.name);
    vp::bench::print(bench, "instances", kind.instances);
    vp::bench::print(bench, "worst above best known", kind.worst, "%");
    vp::bench::print(bench, "longest time", kind.slowest, "s");
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  vp::tour::GtspOptions options;
  std::vector<std::string> files;
  bool json = false;
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool hasValue = i + 1 < words.size();
    double seconds = 0.0;
    if (words[i] == "--seconds" && hasValue && readNumber(words[i + 1], seconds)) {
      options.seconds = seconds;
      ++i;
    } else if (words[i] == "--seed" && hasValue && readNumber(words[i + 1], options.seed)) {
      ++i;
    } else if (words[i] == "--json") {
      json = true;
    } else if (words[i].starts_with("--")) {
      fmt::print(stderr, "usage: bench_tour FILE... [--seconds S] [--seed N]; {} is not understood\n", words[i]);
      return 2;
    } else {
      files.push_back(words[i]);
    }
  }
  if (json) {
    return solveAllAsJson(options);
  }
  fmt::print(stderr, "name cost seconds bound\n");
  bool good = !files.empty();
  for (const std::string& file : files) {
    good = solve(file, options) && good;
  }
  return good ? 0 : 2;
}
