// Tables 2 and 3 of the source paper [1] on the bundled mountain: time and counts of every step, BASE and LAZY, one thread.
#include "core/landing/rrt_star.h"
#include "core/tour/planner.h"
#include "tests/bench/bench_support.h"

#include <fmt/format.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace vp;
using bench::print;
using bench::secondsSince;

/// One row of Tables 2 and 3 of [1]: seconds and counts. The mountain of the paper is not published; ours has its measures.
struct PaperRow {
  const char* name;
  const char* mission;
  int headings;
  mission::Method method;
  double safeSeconds;
  double solverSeconds;
  double totalSeconds;
  double queries;
  double tourSolutions;
  double step = 50.0;  ///< m
};

constexpr PaperRow kRows[] = {
    {"BASE n=5 k=4", "mountain-n5.vpm", 4, mission::Method::Base, 279, 0.012, 309, 20800, 1},
    {"LAZY n=5 k=4", "mountain-n5.vpm", 4, mission::Method::Lazy, 111, 0.514, 142, 8100, 33},
    {"BASE n=5 k=8", "mountain-n5.vpm", 8, mission::Method::Base, 1477, 1, 1507, 83300, 1},
    {"LAZY n=5 k=8", "mountain-n5.vpm", 8, mission::Method::Lazy, 497, 6, 533, 34900, 134},
    {"BASE n=20 k=8", "mountain-n20.vpm", 8, mission::Method::Base, 15013, 1, 15044, 1200000, 1},
    {"LAZY n=20 k=8", "mountain-n20.vpm", 8, mission::Method::Lazy, 268, 87, 385, 21100, 145},
    {"LAZY n=100 k=8 d_step=30", "mountain-n100.vpm", 8, mission::Method::Lazy, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, 30.0},
};

constexpr double kNone = INFINITY;

void benchRow(const std::string& folder, const PaperRow& row) {
  Result<tour::PlanInput> input = bench::load(folder + "/" + row.mission);
  if (!input) {
    bench::countFailure(row.name, input.error());
    return;
  }
  input->mission.planner.headings = row.headings;
  input->mission.planner.refine = mission::Refine::None;  // what the paper did
  input->mission.planner.method = row.method;
  input->mission.planner.step = Length::fromSi(row.step);
  tour::PlanTimes times;
  const auto start = bench::Clock::now();
  const double cpuStart = bench::cpuSeconds();
  const Result<mission::Plan> plan = tour::planTour(*input, Job{}, &times);
  const double total = secondsSince(start);
  const double cpu = bench::cpuSeconds() - cpuStart;
  if (!plan) {
    bench::countFailure(row.name, plan.error());
    return;
  }
  bench::verify(row.name, *input, *plan);
  const mission::PlanMetrics& m = plan->metrics;
  print(row.name, "roadmap", times.roadmap, "s", "[1] Table 2", 30);
  print(row.name, "bounds", times.terrainSegments, "s", "altitude floor, ends and bounds of legs; part of safe trajectories in [1]", kNone);
  print(row.name, "safe segments", times.safeSegments, "s", "[1] Table 2", row.safeSeconds);
  print(row.name, "tour solver", times.tourSolver, "s", "[1] Table 2", row.solverSeconds);
  print(row.name, "total", total, "s", "[1] Table 2", row.totalSeconds);
  print(row.name, "total, processor time", cpu, "s");
  print(row.name, "without roadmap", total - times.roadmap, "s", "[1] Table 2", row.totalSeconds - 30);
  print(row.name, "roadmap expansions", static_cast<double>(m.roadmapExpansions), "", "[1] Table 3", 7500);
  print(row.name, "safe-altitude queries", static_cast<double>(m.safeQueries), "", "[1] Table 3", row.queries);
  print(row.name, "tour solutions", static_cast<double>(m.tourSolutions), "", "[1] Table 3", row.tourSolutions);
  print(row.name, "safe segments evaluated", static_cast<double>(m.safeSegments), "", "", kNone);
  print(row.name, "lower bound", m.lowerBound, "m", "over these headings and this roadmap", kNone);
  print(row.name, "cost", m.cost, "m", "length + penalty", kNone);
  print(row.name, "length", m.length, "m", "", kNone);
}

/// Speed and quality of the RRT* roadmap: expansions per second, and the mean safe altitude over fixed queries.
void benchRoadmap(const std::string& folder) {
  const Result<tour::PlanInput> input = bench::load(folder + "/mountain-n20.vpm");
  if (!input) {
    fmt::print(stderr, "{}\n", input.error().message());
    return;
  }
  landing::World world;
  world.terrain = terrain::TerrainPyramid(input->terrain);
  world.glide = aircraft::GlideModel(input->mission.aircraft);
  world.sites = input->sites;
  landing::RrtStarOptions options;
  options.area = input->terrain->extent();
  for (const int samples : {0, 1000, 7500, 30000}) {
    options.samples = samples;
    landing::RrtStarStatistics statistics;
    auto start = bench::Clock::now();
    const Result<landing::TreeRoadmap> roadmap = landing::buildRrtStarRoadmap(world, options, Job{}, &statistics);
    const double seconds = secondsSince(start);
    const std::string name = fmt::format("roadmap {} samples", samples);
    if (samples > 0) {
      print(name, "expansions per second", static_cast<double>(statistics.expansions) / seconds, "1/s", "[1]: 7500 in 30 s", 250);
    }
    std::mt19937_64 engine(5000);
    const auto unit = [&engine] { return static_cast<double>(engine() >> 11) * 0x1.0p-53; };
    landing::QueryScratch scratch;
    double sum = 0.0;
    int answered = 0;
    start = bench::Clock::now();
    for (int i = 0; i < 5000; ++i) {
      const geo::Pose pose{4600.0 * (unit() - 0.5), 4600.0 * (unit() - 0.5), 6.283185307 * unit()};
      if (const auto answer = roadmap->query(world, pose, scratch)) {
        sum += answer->altitude;
        ++answered;
      }
    }
    print(name, "query", secondsSince(start) / 5000 * 1e6, "us", "5000 fixed poses", kNone);
    print(name, "mean safe altitude", sum / answered, "m", "5000 fixed poses", kNone);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string folder = argc > 1 ? argv[1] : VOLPLANE_SOURCE_DIR "/maps";
  const std::string only = argc > 2 ? argv[2] : "";  // rows whose name contains this
  if (only.empty()) {
    benchRoadmap(folder);
  }
  for (const PaperRow& row : kRows) {
    if (std::string(row.name).find(only) != std::string::npos) {
      benchRow(folder, row);
    }
  }
  print("all of bench_elasp", "peak memory", bench::peakMemory(), "MiB");
  return bench::verdict("bench_elasp");
}
