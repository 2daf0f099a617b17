// The planners of [4] on 616 problems made as its section 3.1 says: mean probability of coming through the weather to each runway, 0 where none is
// reached, and time. Every path is judged by the checker outside the timed part; one that it refuses ends the program with 1.
//   bench_weather [--every N] [--deadline S] [--planner NAME] [--plain] [--paper]
//     --every N   one problem in N      --plain  roadmaps alone, no local search ("PP")
//     --paper     the sizes of [4]: 2000 samples joined to 200 each, once, no local search
#include "core/emergency/landing_outcome.h"
#include "core/emergency/planners.h"
#include "core/emergency/verified_answer.h"
#include "core/emergency/weather/weather_planner.h"
#include "tests/bench/bench_support.h"
#include "tests/support/emergency_cases.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <vector>

using namespace vp;

namespace {

struct Options {
  std::size_t every = 1;
  double deadline = 0.2;
  std::string planner;
  bool isPlain = false;
  bool isPaper = false;
};

/// Mean probability and seconds of [4] Table 1: roadmap alone, and with ELS and DLS.
struct Published {
  double plain = NAN;
  double searched = NAN;
};
const std::map<std::string, Published> kPublished{{"straight", {0.28, 0.28}}, {"hrm", {0.35, 0.38}},  {"lvg", {0.35, 0.37}},
                                                  {"dlvg", {0.37, 0.36}},     {"prm", {0.37, 0.41}},  {"dprm", {0.41, 0.39}},
                                                  {"vprm", {0.37, 0.40}},     {"dvprm", {0.42, 0.41}}};

struct Figures {
  double success = 0.0;
  int problems = 0;
  int failed = 0;
  int refused = 0;
  std::vector<double> seconds;
  std::vector<double> cpu;  ///< processor time
};

Options optionsFrom(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const auto next = [&] { return i + 1 < argc ? argv[++i] : ""; };
    if (std::strcmp(argv[i], "--every") == 0) {
      options.every = static_cast<std::size_t>(std::max(1, std::atoi(next())));
    } else if (std::strcmp(argv[i], "--deadline") == 0) {
      options.deadline = std::atof(next());
    } else if (std::strcmp(argv[i], "--planner") == 0) {
      options.planner = next();
    } else if (std::strcmp(argv[i], "--plain") == 0) {
      options.isPlain = true;
    } else if (std::strcmp(argv[i], "--paper") == 0) {
      options.isPaper = true;
    }
  }
  return options;
}

emergency::WeatherPlannerOptions plannerOptions(const std::string& name, const Options& options) {
  emergency::WeatherPlannerOptions made = *emergency::weatherPlannerOptions(name);
  if (options.isPlain || options.isPaper) {
    made.searchesLines = false;
    made.searchesCurves = false;
    made.polish = 0;
    made.rounds = 1;
    made.ways = 1;
    made.samples = options.isPaper ? 2000 : 400;
    made.nearest = options.isPaper ? 200 : 40;
  }
  return made;
}

Figures measure(const std::string& name, const Options& options, const std::vector<emergency::LandingRequest>& requests) {
  const emergency::WeatherPlanner planner(name, plannerOptions(name, options));
  Figures figures;
  std::size_t number = 0;
  for (emergency::LandingRequest request : requests) {
    for (std::size_t site = 0; site < request.world->sites.size(); ++site) {
      if (number++ % options.every != 0) {
        continue;
      }
      request.onlySite = static_cast<int>(site);
      request.deadline = options.deadline;
      const double before = bench::cpuSeconds();
      emergency::LandingAnswer answer = planner.plan(request);
      figures.cpu.push_back(bench::cpuSeconds() - before);
      ++figures.problems;
      figures.seconds.push_back(answer.seconds);
      if (!answer.reachesRunway()) {
        ++figures.failed;
        continue;
      }
      const double success = std::exp(-emergency::weatherOf(request, *answer.path));
      answer = emergency::verifiedAnswer(request, std::move(answer));
      if (!answer.verified) {
        fmt::print(stderr, "{} to {}: {}\n", name, request.world->sites[site].site.id, answer.whyNot);
        ++figures.refused;
        continue;
      }
      figures.success += success;
    }
  }
  return figures;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = optionsFrom(argc, argv);
  const std::vector<test::Emergency> emergencies = test::emergencies();
  std::vector<emergency::LandingRequest> requests;
  for (const test::EmergencyVersion& version : test::emergencyVersions()) {
    requests.push_back(test::emergencyRequest(emergencies[version.emergency], version));
  }
  const bool isSearched = !options.isPlain && !options.isPaper;
  const std::string table = options.isPaper ? "[4] sizes of the paper" : options.isPlain ? "[4] roadmap alone" : "[4] planner";
  int refused = 0;
  double best = 0.0;
  double bestSeconds = 0.0;
  std::string bestName;
  for (const std::string_view view : emergency::weatherPlannerNames()) {
    const std::string name(view);
    if (!options.planner.empty() && options.planner != name) {
      continue;
    }
    Figures figures = measure(name, options, requests);
    refused += figures.refused;
    const double mean = figures.success / figures.problems;
    const auto known = kPublished.find(name);
    std::sort(figures.seconds.begin(), figures.seconds.end());
    const double median = figures.seconds[figures.seconds.size() / 2];
    const std::string bench = table + ", " + name;
    bench::print(bench, "mean success probability", mean, "", fmt::format("{} problems; Table 1", figures.problems),
                 known == kPublished.end() ? NAN
                 : isSearched              ? known->second.searched
                                           : known->second.plain);
    bench::print(bench, "not reached", figures.failed, "", fmt::format("of {}", figures.problems));
    bench::print(bench, "median time", 1e3 * median, "ms");
    bench::print(bench, "longest time", 1e3 * figures.seconds.back(), "ms");
    bench::print(bench, "longest processor time", 1e3 * *std::max_element(figures.cpu.begin(), figures.cpu.end()), "ms");
    if (mean > best) {
      best = mean;
      bestSeconds = figures.seconds.back();
      bestName = name;
    }
  }
  bench::print(table, "best: mean success probability", best, "", bestName);
  bench::print(table, "best: longest time", bestSeconds, "s", "[4] Table 1, DVPRM, mean", 8.6);
  bench::print(table, "paths that the checker refused", refused, "", "to reach", 0);
  return refused == 0 ? 0 : 1;
}
