// Roadmaps of landing glides: the lattice against RRT*, on the bundled mountain and on other missions.
//   bench_roadmap MISSION... [--rrt-seconds S] [--step M] [--lattice-only]
// For each mission: time to build, counts, mean safe altitude over 5,000 fixed queries, and the time of a query.
#include "core/landing/lattice_roadmap.h"
#include "core/landing/rrt_star.h"
#include "core/tour/planner.h"
#include "tests/bench/bench_support.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace vp;
using bench::Clock;
using bench::cpuSeconds;
using bench::print;
using bench::secondsSince;

constexpr int kQueries = 5000;

std::vector<geo::Pose> fixedPoses(const geo::Box& area) {
  std::mt19937_64 engine(5000);
  const auto unit = [&engine] { return static_cast<double>(engine() >> 11) * 0x1.0p-53; };
  const double marginX = 0.04 * (area.maxX - area.minX);
  const double marginY = 0.04 * (area.maxY - area.minY);
  std::vector<geo::Pose> poses;
  for (int i = 0; i < kQueries; ++i) {
    poses.push_back({area.minX + marginX + (area.maxX - area.minX - 2.0 * marginX) * unit(),
                     area.minY + marginY + (area.maxY - area.minY - 2.0 * marginY) * unit(), 2.0 * Angle::kPi * unit()});
  }
  return poses;
}

struct Answers {
  std::vector<double> altitude;  ///< infinity where there is no glide
  double mean = 0.0;             ///< us of processor time
  double median = 0.0;           ///< us of wall time
  int found = 0;
  double legs = 0.0;  ///< paths against the ground in a query
  double p99 = 0.0;

  [[nodiscard]] double meanAltitude() const {
    double sum = 0.0;
    for (const double answer : altitude) {
      sum += std::isfinite(answer) ? answer : 0.0;
    }
    return sum / found;
  }
};

Answers ask(const landing::World& world, const landing::Roadmap& roadmap, const std::vector<geo::Pose>& poses) {
  Answers answers;
  std::vector<double> times;
  landing::QueryScratch scratch;
  const double begin = cpuSeconds();
  for (const geo::Pose& pose : poses) {
    answers.found += roadmap.query(world, pose, scratch) ? 1 : 0;
  }
  answers.mean = 1e6 * (cpuSeconds() - begin) / static_cast<double>(poses.size());
  for (const geo::Pose& pose : poses) {
    const auto start = Clock::now();
    const auto answer = roadmap.query(world, pose, scratch);
    times.push_back(1e6 * secondsSince(start));
    answers.altitude.push_back(answer ? answer->altitude : INFINITY);
  }
  answers.legs = static_cast<double>(scratch.legs) / static_cast<double>(scratch.queries);
  std::sort(times.begin(), times.end());
  answers.median = times[times.size() / 2];
  answers.p99 = times[times.size() * 99 / 100];
  return answers;
}

void compare(const std::string& name, const char* other, const Answers& mine, const Answers& others) {
  double sumMine = 0.0;
  double sumOther = 0.0;
  double worst = 0.0;
  int both = 0;
  int onlyMine = 0;
  int onlyOther = 0;
  for (std::size_t i = 0; i < mine.altitude.size(); ++i) {
    const bool a = std::isfinite(mine.altitude[i]);
    const bool b = std::isfinite(others.altitude[i]);
    onlyMine += a && !b ? 1 : 0;
    onlyOther += b && !a ? 1 : 0;
    if (a && b) {
      sumMine += mine.altitude[i];
      sumOther += others.altitude[i];
      worst = std::max(worst, mine.altitude[i] - others.altitude[i]);
      ++both;
    }
  }
  print(name, "mean safe altitude", sumMine / both, "m", other, sumOther / both);
  print(name, "largest excess over it", worst, "m", other);
  print(name, "poses without glide", onlyOther, "", other, onlyMine);
}

void benchMission(const std::string& file, double rrtSeconds, std::optional<double> step, bool isLatticeOnly) {
  const std::filesystem::path path(file);
  const Result<tour::PlanInput> loaded = bench::load(file);
  if (!loaded) {
    fmt::print(stderr, "{}\n", loaded.error().message());
    return;
  }
  const tour::PlanInput& input = *loaded;
  const landing::World world = tour::makeWorld(input);
  landing::LatticeOptions options;
  options.area = input.terrain->extent();
  options.step = step;
  const std::string name = "lattice " + path.stem().string();
  landing::LatticeStatistics counts;
  double seconds = INFINITY;
  std::optional<landing::LatticeRoadmap> lattice;
  for (int run = 0; run < 3; ++run) {
    const double start = cpuSeconds();
    auto built = landing::buildLatticeRoadmap(world, options, Job{}, &counts);
    seconds = std::min(seconds, cpuSeconds() - start);
    if (!built) {
      fmt::print(stderr, "{}\n", built.error().message());
      return;
    }
    lattice = std::move(*built);
  }
  print(name, "roadmap", seconds, "s", "processor time, best of three");
  print(name, "step", counts.step, "m");
  print(name, "states", static_cast<double>(counts.states), "");
  print(name, "reached", static_cast<double>(counts.reached), "");
  std::size_t primitives = 0;
  for (const auto& arrivals : lattice->glides().primitives.arrivals) {
    primitives += arrivals.size();
  }
  print(name, "primitives", static_cast<double>(primitives), "");
  print(name, "settled", static_cast<double>(counts.settled), "");
  print(name, "ground tests", static_cast<double>(counts.groundTests), "");
  print(name, "legs", static_cast<double>(counts.legs), "");
  print(name, "connections", static_cast<double>(counts.connections), "");
  const std::vector<geo::Pose> poses = fixedPoses(options.area);
  const Answers mine = ask(world, *lattice, poses);
  print(name, "query, mean", mine.mean, "us", "processor time");
  print(name, "query, glides against the ground", mine.legs, "");
  print(name, "query, median", mine.median, "us");
  print(name, "query, 99 %", mine.p99, "us");
  print(name, "poses with a glide", mine.found, "");
  print(name, "mean of their safe altitudes", mine.meanAltitude(), "m");
  if (isLatticeOnly) {
    return;
  }

  landing::RrtStarOptions rrt;
  rrt.area = options.area;
  rrt.samples = landing::defaultSamples(rrt.area);
  const auto start = Clock::now();
  const auto tree = landing::buildRrtStarRoadmap(world, rrt, Job{});
  if (tree) {
    print("RRT* " + path.stem().string(), "roadmap", secondsSince(start), "s", "default samples");
    compare(name, "against RRT* with default samples", mine, ask(world, *tree, poses));
  }
  if (rrtSeconds > 0.0) {
    rrt.samples = 100'000'000;
    rrt.seconds = rrtSeconds;
    landing::RrtStarStatistics grown;
    const auto longer = landing::buildRrtStarRoadmap(world, rrt, Job{}, &grown);
    print("RRT* " + path.stem().string(), "samples in the time given", static_cast<double>(grown.expansions), "");
    compare(name + fmt::format(", {:g} s of RRT*", rrtSeconds), "against RRT* after the time given", mine, ask(world, *longer, poses));
  }
}

}  // namespace

int main(int argc, char** argv) {
  double rrtSeconds = 0.0;
  std::optional<double> step;
  bool isLatticeOnly = false;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--rrt-seconds" && i + 1 < argc) {
      rrtSeconds = std::atof(argv[++i]);
    } else if (word == "--step" && i + 1 < argc) {
      step = std::atof(argv[++i]);
    } else if (word == "--lattice-only") {
      isLatticeOnly = true;
    } else {
      files.push_back(word);
    }
  }
  for (const std::string& file : files) {
    benchMission(file, rrtSeconds, step, isLatticeOnly);
  }
}
