// What refinement makes of the tours over sampled headings: cost, length, work. Every plan is judged by the checker.
#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/formats/plan_file.h"
#include "core/safety/checker.h"
#include "core/tour/replan.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace vp;

void print(const std::string& bench, const char* metric, double value, const char* unit) {
  fmt::print("{{\"bench\": \"{}\", \"metric\": \"{}\", \"value\": {}, \"unit\": \"{}\"}}\n", bench, metric, value, unit);
  std::fflush(stdout);
}

Result<tour::PlanInput> load(const std::string& file) {
  const Result<mission::Mission> mission = formats::readMission(file);
  if (!mission) {
    return forward(mission);
  }
  const Result<formats::LoadedMission> loaded = formats::loadMission(*mission, std::filesystem::path(file).parent_path().string(), Job{});
  if (!loaded) {
    return forward(loaded);
  }
  return tour::PlanInput{loaded->mission, loaded->frame, loaded->terrain, loaded->terrainFiles, loaded->sites, loaded->targets, "bench", "LKH", 1};
}

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool isCertified(const tour::PlanInput& input, const mission::Plan& plan) {
  std::vector<std::string> checksums;
  for (const mission::TerrainReference& file : plan.terrain) {
    checksums.push_back(file.sha256);
  }
  const Result<safety::SafetyReport> report = safety::check({plan, *input.terrain, checksums}, Job{});
  return report && report->isSafe();
}

void bench(const std::string& file) {
  const std::string name = "refine " + std::filesystem::path(file).stem().string();
  Result<tour::PlanInput> input = load(file);
  if (!input) {
    fmt::print(stderr, "{}\n", input.error().message());
    return;
  }
  input->mission.planner.refine = mission::Refine::None;
  const Result<mission::Plan> sampled = tour::planTour(*input, Job{});
  input->mission.planner.refine = mission::Refine::Full;
  tour::PlanTimes times;
  const Result<mission::Plan> refined = tour::planTour(*input, Job{}, &times);
  if (!sampled || !refined) {
    fmt::print(stderr, "{}: {}\n", name, (sampled ? refined : sampled).error().message());
    return;
  }
  const mission::PlanMetrics& before = sampled->metrics;
  const mission::PlanMetrics& after = refined->metrics;
  print(name, "cost over sampled headings", before.cost, "m");
  print(name, "cost, refined", after.cost, "m");
  print(name, "cost saved", 100.0 * (1.0 - after.cost / before.cost), "%");
  print(name, "length over sampled headings", before.length, "m");
  print(name, "length, refined", after.length, "m");
  print(name, "length saved", 100.0 * (1.0 - after.length / before.length), "%");
  print(name, "changes tried", static_cast<double>(after.movesTried), "");
  print(name, "changes accepted", static_cast<double>(after.movesAccepted), "");
  print(name, "queries", static_cast<double>(after.safeQueries - before.safeQueries), "");
  print(name, "time", times.refinement, "s");
  print(name, "certified", isCertified(*input, *sampled) && isCertified(*input, *refined) ? 1.0 : 0.0, "");
}

/// Moves one target after another by 100 m and plans again, over what the plan before left.
void benchReplan(const std::string& file) {
  const std::string name = "replan " + std::filesystem::path(file).stem().string();
  Result<tour::PlanInput> input = load(file);
  if (!input) {
    return;
  }
  input->mission.planner.refine = mission::Refine::Full;
  tour::Planner planner;
  if (!planner.plan(*input, Job{})) {
    return;
  }
  constexpr int kMoves = 5;
  double plan = 0.0;
  double check = 0.0;
  double write = 0.0;
  double ratio = 0.0;
  double queries = 0.0;
  for (int move = 0; move < kMoves; ++move) {
    mission::TargetInFrame& target = input->targets[static_cast<std::size_t>(move)];
    const double heightAbove = target.altitude - input->terrain->upperAt(target.point);
    target.target.position = input->frame.toLatLon({target.point.x + 100.0, target.point.y - 50.0});
    target.point = input->frame.toPoint(target.target.position);
    target.altitude = input->terrain->upperAt(target.point) + heightAbove;
    input->mission.targets[static_cast<std::size_t>(move)] = target.target;
    auto start = std::chrono::steady_clock::now();
    const Result<mission::Plan> again = planner.plan(*input, Job{});
    plan += secondsSince(start);
    if (!again || !planner.reused().tour) {
      fmt::print(stderr, "{}: {}\n", name, again ? "began afresh" : again.error().message());
      return;
    }
    start = std::chrono::steady_clock::now();
    const bool certified = isCertified(*input, *again);
    check += secondsSince(start);
    start = std::chrono::steady_clock::now();
    const std::string text = formats::planToJson(*again);
    write += secondsSince(start);
    const Result<mission::Plan> fresh = tour::planTour(*input, Job{});
    ratio += fresh && certified && !text.empty() ? again->metrics.cost / fresh->metrics.cost : 1e9;
    queries += static_cast<double>(again->metrics.safeQueries);
  }
  print(name, "plan", 1e3 * plan / kMoves, "ms");
  print(name, "check", 1e3 * check / kMoves, "ms");
  print(name, "JSON", 1e3 * write / kMoves, "ms");
  print(name, "queries", queries / kMoves, "");
  print(name, "cost of a fresh plan", 100.0 * ratio / kMoves, "%");
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    bench(argv[i]);
    benchReplan(argv[i]);
  }
}
