// The any-time planner after an engine failure: how soon there is a path that the checker accepts, how soon it is within 2 % of what is found in the
// end, and how often a runway is found where the roadmap knows one. Random poses over the missions' terrain: "high" 200 to 1200 m above the ground,
// "tight" 2 to 50 m above the lowest height from which the roadmap knows a glide.
//   bench_landing [--cases N] [--seconds S] MISSION...
#include "core/emergency/anytime_planner.h"
#include "core/emergency/landing_judge.h"
#include "core/emergency/verified_answer.h"
#include "core/landing/build_roadmap.h"
#include "tests/bench/bench_support.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace vp;

struct Options {
  int cases = 30;
  double seconds = 2.0;
};

/// One better answer of a run.
struct Step {
  double seconds = 0.0;
  double cost = 0.0;
};

struct Figures {
  std::vector<double> first;     ///< s, until a path was found
  std::vector<double> verified;  ///< s, until one was found and judged
  std::vector<double> near;      ///< s, until within 2 % of the final cost
  std::vector<double> gain;      ///< m of height, the last answer against the first
  int unverified = 0;
  int solved = 0;
  int known = 0;        ///< that the roadmap has a glide for
  int knownSolved = 0;  ///< of those, solved
  int higher = 0;       ///< of those, with no less height in hand than the roadmap's, within a metre
};

double share(std::vector<double> values, double part) {
  if (values.empty()) {
    return 0.0;
  }
  const auto at = static_cast<std::size_t>(part * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

void runCase(emergency::LandingRequest request, const landing::Roadmap& roadmap, Figures& figures) {
  std::vector<Step> steps;
  double judged = -1.0;
  request.better = [&](const emergency::LandingAnswer& answer) {
    steps.push_back({answer.seconds, answer.cost()});
    if (judged < 0.0) {
      const auto start = bench::Clock::now();
      judged = emergency::verifiedAnswer(request, answer).verified ? answer.seconds + bench::secondsSince(start) : judged;
    }
  };
  const emergency::LandingAnswer answer = emergency::AnytimePlanner().plan(request);
  landing::QueryScratch scratch;
  const std::optional<landing::SafeAltitude> safe = roadmap.queryTurning(*request.world, request.pose, scratch);
  const bool isKnown = safe && safe->altitude <= request.altitude;
  figures.known += isKnown ? 1 : 0;
  if (!answer.reachesRunway()) {
    return;
  }
  ++figures.solved;
  figures.knownSolved += isKnown ? 1 : 0;
  figures.higher += isKnown && answer.heightInHand >= request.altitude - safe->altitude - 1.0 ? 1 : 0;
  figures.unverified += emergency::verifiedAnswer(request, answer).verified ? 0 : 1;
  figures.first.push_back(steps.front().seconds);
  if (judged >= 0.0) {
    figures.verified.push_back(judged);
  }
  const double final = answer.cost();
  const auto near = std::find_if(steps.begin(), steps.end(), [final](const Step& step) { return step.cost <= 1.02 * final; });
  figures.near.push_back(near->seconds);
  figures.gain.push_back(steps.front().cost - final);
}

bool measureCases(const std::string& where, bool tight, const Options& options, emergency::LandingRequest request, const landing::Roadmap& roadmap) {
  const terrain::ElevationGrid& grid = request.world->terrain.grid();
  const geo::Box box = grid.extent();
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  landing::QueryScratch scratch;
  Figures figures;
  for (int i = 0; i < options.cases;) {
    request.pose = {box.minX + (box.maxX - box.minX) * unit(random), box.minY + (box.maxY - box.minY) * unit(random),
                    2.0 * Angle::kPi * unit(random)};
    request.altitude = grid.upperAt(request.pose.point()) + 200.0 + 1000.0 * unit(random);
    if (tight) {
      const std::optional<landing::SafeAltitude> safe = roadmap.queryTurning(*request.world, request.pose, scratch);
      if (!safe) {
        continue;
      }
      request.altitude = safe->altitude + 2.0 + 48.0 * unit(random);
    }
    request.seed = static_cast<std::uint64_t>(++i);
    runCase(request, roadmap, figures);
  }
  const std::string name = "landing any-time, " + where;
  bench::print(name, "solved", figures.solved, "", fmt::format("of {} cases", options.cases));
  bench::print(name, "solved where the roadmap has a glide", figures.knownSolved, "", "cases with a glide", figures.known);
  bench::print(name, "no lower than the roadmap's, within 1 m", figures.higher, "", "cases with a glide", figures.known);
  bench::print(name, "refused by the checker", figures.unverified, "", "to reach", 0.0);
  bench::print(name, "first path, median", 1e3 * share(figures.first, 0.5), "ms");
  bench::print(name, "first path, slowest", 1e3 * share(figures.first, 1.0), "ms");
  bench::print(name, "first verified path, median", 1e3 * share(figures.verified, 0.5), "ms", "to reach", 5.0);
  bench::print(name, "first verified path, slowest tenth", 1e3 * share(figures.verified, 0.9), "ms", "to reach", 5.0);
  bench::print(name, "first verified path, slowest", 1e3 * share(figures.verified, 1.0), "ms", "to reach", 5.0);
  bench::print(name, "within 2 % of the final cost, median", 1e3 * share(figures.near, 0.5), "ms", "to reach", 200.0);
  bench::print(name, "within 2 % of the final cost, slowest tenth", 1e3 * share(figures.near, 0.9), "ms", "to reach", 200.0);
  bench::print(name, "within 2 % of the final cost, slowest", 1e3 * share(figures.near, 1.0), "ms", "to reach", 200.0);
  double gained = 0.0;
  for (const double gain : figures.gain) {
    gained += gain;
  }
  bench::print(name, "gained after the first path, mean", figures.gain.empty() ? 0.0 : gained / static_cast<double>(figures.gain.size()), "m");
  return figures.unverified == 0;
}

bool measure(const std::string& file, const Options& options) {
  const Result<tour::PlanInput> input = bench::load(file);
  if (!input) {
    fmt::print(stderr, "{}\n", input.error().message());
    return false;
  }
  emergency::LandingRequest request;
  request.world = std::make_shared<const landing::World>(tour::makeWorld(*input));
  request.mission = std::make_shared<const mission::Mission>(input->mission);
  request.frameOrigin = input->frame.origin();
  request.deadline = options.seconds;
  request.judge = std::make_shared<const emergency::LandingJudge>(request);  // as a window keeps it while the mission stays
  const terrain::ElevationGrid& grid = request.world->terrain.grid();
  landing::RoadmapRequest wanted;
  wanted.area = grid.extent();
  const auto roadmap = landing::buildRoadmap(*request.world, input->mission.planner, wanted, Job{});
  if (!roadmap) {
    fmt::print(stderr, "{}\n", roadmap.error().message());
    return false;
  }
  bool good = true;
  for (const bool tight : {false, true}) {
    good = measureCases(std::filesystem::path(file).stem().string() + (tight ? ", tight" : ", high"), tight, options, request, **roadmap) && good;
  }
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  bool good = true;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--cases" && i + 1 < argc) {
      options.cases = std::stoi(argv[++i]);
    } else if (argument == "--seconds" && i + 1 < argc) {
      options.seconds = std::stod(argv[++i]);
    } else {
      good = measure(argument, options) && good;
    }
  }
  return good ? 0 : 1;
}
