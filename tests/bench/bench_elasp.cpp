// Tables 2 and 3 of the source paper [1] on the bundled mountain: time and counts of every step, BASE and LAZY, one thread.
#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/landing/rrt_star.h"
#include "core/tour/planner.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <random>
#include <string>
#include <sys/resource.h>
#include <vector>

namespace {

using namespace vp;

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

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void print(const std::string& bench, const char* metric, double value, const char* unit, double reference, const char* note) {
  const std::string compared = std::isfinite(reference) ? fmt::format(R"(, "reference": {})", reference) : "";
  fmt::print("{{\"bench\": \"{}\", \"metric\": \"{}\", \"value\": {}, \"unit\": \"{}\"{}, \"note\": \"{}\"}}\n", bench, metric, value, unit, compared,
             note);
  std::fflush(stdout);
}

constexpr double kNone = INFINITY;

Result<tour::PlanInput> load(const std::string& folder, const char* name) {
  const Result<mission::Mission> mission = formats::readMission(folder + "/" + name);
  if (!mission) {
    return forward(mission);
  }
  const Result<formats::LoadedMission> loaded = formats::loadMission(*mission, folder, Job{});
  if (!loaded) {
    return forward(loaded);
  }
  return tour::PlanInput{loaded->mission, loaded->frame, loaded->terrain, loaded->terrainFiles, loaded->sites, loaded->targets, "bench", "LKH", 1};
}

void benchRow(const std::string& folder, const PaperRow& row) {
  Result<tour::PlanInput> input = load(folder, row.mission);
  if (!input) {
    fmt::print(stderr, "{}\n", input.error().message());
    return;
  }
  input->mission.planner.headings = row.headings;
  input->mission.planner.refine = mission::Refine::None;  // what the paper did
  input->mission.planner.method = row.method;
  input->mission.planner.step = Length::fromSi(row.step);
  tour::PlanTimes times;
  const auto start = std::chrono::steady_clock::now();
  const Result<mission::Plan> plan = tour::planTour(*input, Job{}, &times);
  const double total = secondsSince(start);
  if (!plan) {
    fmt::print(stderr, "{}: {}\n", row.name, plan.error().message());
    return;
  }
  const mission::PlanMetrics& m = plan->metrics;
  print(row.name, "roadmap", times.roadmap, "s", 30, "[1] Table 2");
  print(row.name, "bounds", times.terrainSegments, "s", kNone, "altitude floor, ends and bounds of legs; part of safe trajectories in [1]");
  print(row.name, "safe segments", times.safeSegments, "s", row.safeSeconds, "[1] Table 2");
  print(row.name, "tour solver", times.tourSolver, "s", row.solverSeconds, "[1] Table 2");
  print(row.name, "total", total, "s", row.totalSeconds, "[1] Table 2");
  print(row.name, "without roadmap", total - times.roadmap, "s", row.totalSeconds - 30, "[1] Table 2");
  print(row.name, "roadmap expansions", static_cast<double>(m.roadmapExpansions), "", 7500, "[1] Table 3");
  print(row.name, "safe-altitude queries", static_cast<double>(m.safeQueries), "", row.queries, "[1] Table 3");
  print(row.name, "tour solutions", static_cast<double>(m.tourSolutions), "", row.tourSolutions, "[1] Table 3");
  print(row.name, "safe segments evaluated", static_cast<double>(m.safeSegments), "", kNone, "");
  print(row.name, "lower bound", m.lowerBound, "m", kNone, "over these headings and this roadmap");
  print(row.name, "cost", m.cost, "m", kNone, "length + penalty");
  print(row.name, "length", m.length, "m", kNone, "");
}

/// Speed and quality of the RRT* roadmap: expansions per second, and the mean safe altitude over fixed queries.
void benchRoadmap(const std::string& folder) {
  const Result<tour::PlanInput> input = load(folder, "mountain-n20.vpm");
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
    auto start = std::chrono::steady_clock::now();
    const Result<landing::TreeRoadmap> roadmap = landing::buildRrtStarRoadmap(world, options, Job{}, &statistics);
    const double seconds = secondsSince(start);
    const std::string name = fmt::format("roadmap {} samples", samples);
    if (samples > 0) {
      print(name, "expansions per second", static_cast<double>(statistics.expansions) / seconds, "1/s", 250, "[1]: 7500 in 30 s");
    }
    std::mt19937_64 engine(5000);
    const auto unit = [&engine] { return static_cast<double>(engine() >> 11) * 0x1.0p-53; };
    landing::QueryScratch scratch;
    double sum = 0.0;
    int answered = 0;
    start = std::chrono::steady_clock::now();
    for (int i = 0; i < 5000; ++i) {
      const geo::Pose pose{4600.0 * (unit() - 0.5), 4600.0 * (unit() - 0.5), 6.283185307 * unit()};
      if (const auto answer = roadmap->query(world, pose, scratch)) {
        sum += answer->altitude;
        ++answered;
      }
    }
    print(name, "query", secondsSince(start) / 5000 * 1e6, "us", kNone, "5000 fixed poses");
    print(name, "mean safe altitude", sum / answered, "m", kNone, "5000 fixed poses");
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
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  print("all of this program", "peak memory", static_cast<double>(usage.ru_maxrss) / 1024.0, "MiB", kNone, "");
}
