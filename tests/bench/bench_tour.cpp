// Solves GTSPLIB files and prints one line each: name, cost, seconds to the end of the run, lower bound.
//   bench_tour FILE... [--seconds S] [--seed N]
//   bench_tour --json [--seconds S] [--seed N]   all instances of the folder gtsp beside the checkout's data (or of
//              VOLPLANE_DATA) against best_known.csv there, as lines for packaging/bench; one second up to 20 sets

#include "core/tour/gtsp.h"
#include "core/tour/gtsp_lib.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
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

std::filesystem::path instanceFolder() {
  const char* data = std::getenv("VOLPLANE_DATA");
  for (const std::filesystem::path& folder :
       {std::filesystem::path(data != nullptr ? data : "") / "gtsp", std::filesystem::path(VOLPLANE_SOURCE_DIR "/../shared/data/gtsp")}) {
    if (std::filesystem::is_directory(folder)) {
      return folder;
    }
  }
  return {};
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

int solveAllAsJson(vp::tour::GtspOptions options) {
  const std::filesystem::path folder = instanceFolder();
  if (folder.empty()) {
    fmt::print(stderr, "bench_tour: no folder with instances; set VOLPLANE_DATA to the folder that holds gtsp/\n");
    return 0;
  }
  const std::map<std::string, double> known = bestKnown(folder);
  const std::optional<double> patience = options.seconds;
  for (const auto& [name, best] : known) {
    const bool plain = std::filesystem::exists(folder / (name + ".gtsp"));
    const auto instance = vp::tour::loadGtspLib((folder / (name + (plain ? ".gtsp" : ".gtsp.gz"))).string());
    if (!instance) {
      fmt::print(stderr, "{}\n", instance.error().message());
      return 2;
    }
    const std::size_t sets = instance->problem.sets.size();
    options.seconds = sets <= 20 ? 1.0 : patience;
    const auto start = std::chrono::steady_clock::now();
    const auto solution = vp::tour::solveGtsp(instance->problem, options, vp::Job());
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    if (!solution) {
      fmt::print(stderr, "{}: {}\n", name, solution.error().message());
      return 2;
    }
    const std::string bench = fmt::format("tour {} ({} sets)", name, sets);
    fmt::print(R"({{"bench": "{}", "metric": "cost", "value": {:.10g}, "reference": {:.10g}, "note": "{:+.2f} % against best known{}"}})"
               "\n",
               bench, solution->cost, best, 100.0 * (solution->cost / best - 1.0), solution->optimal ? ", proved optimal" : "");
    fmt::print(R"({{"bench": "{}", "metric": "seconds", "value": {:.3f}, "unit": "s"}})"
               "\n",
               bench, seconds.count());
    fmt::print(R"({{"bench": "{}", "metric": "lower bound", "value": {:.10g}, "reference": {:.10g}}})"
               "\n",
               bench, solution->lowerBound, best);
    std::fflush(stdout);
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
