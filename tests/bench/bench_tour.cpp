// Solves GTSPLIB files and prints one line each: name, cost, seconds to the end of the run, lower bound.
//   bench_tour FILE... [--seconds S] [--seed N]

#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "core/tour/gtsp.h"
#include "core/tour/gtsp_lib.h"

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

}  // namespace

int main(int argc, char** argv) {
  vp::tour::GtspOptions options;
  std::vector<std::string> files;
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool hasValue = i + 1 < words.size();
    double seconds = 0.0;
    if (words[i] == "--seconds" && hasValue && readNumber(words[i + 1], seconds)) {
      options.seconds = seconds;
      ++i;
    } else if (words[i] == "--seed" && hasValue && readNumber(words[i + 1], options.seed)) {
      ++i;
    } else if (words[i].starts_with("--")) {
      fmt::print(stderr, "usage: bench_tour FILE... [--seconds S] [--seed N]; {} is not understood\n", words[i]);
      return 2;
    } else {
      files.push_back(words[i]);
    }
  }
  fmt::print(stderr, "name cost seconds bound\n");
  bool good = !files.empty();
  for (const std::string& file : files) {
    good = solve(file, options) && good;
  }
  return good ? 0 : 2;
}
