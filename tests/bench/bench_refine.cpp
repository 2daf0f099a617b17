// What refinement makes of the tours over sampled headings: cost, length, work; and planning again after a target has moved.
//   bench_refine [--real] [--replan MISSION] MISSION...      --real: the missions over real terrain too
// Beside each gain stands the most that any planner could gain: down to a bound that holds for every safe tour (core/tour/free_bound).
#include "core/formats/plan_file.h"
#include "core/tour/free_bound.h"
#include "core/tour/replan.h"
#include "tests/bench/bench_support.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace vp;
using bench::print;
using bench::secondsSince;

struct Gains {
  std::vector<double> cost;    // %
  std::vector<double> length;  // %
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double percentBelow(double value, double before) {
  return 100.0 * (1.0 - value / before);
}

/// Bounds of cost and of length of every safe tour over the targets.
void printBounds(const std::string& name, const tour::PlanInput& input, const tour::PlanBasis& basis, const mission::PlanMetrics& before) {
  if (!basis.floor) {
    return;
  }
  std::vector<tour::VisitPose> visits;
  for (const mission::TargetInFrame& target : input.targets) {
    tour::VisitPose visit;
    visit.target = static_cast<int>(visits.size());
    visit.pose = {target.point.x, target.point.y, 0.0};
    visit.altitude = target.altitude;
    visits.push_back(visit);
  }
  const Result<double> cost = tour::freeLowerBound(*basis.floor, visits, input.mission.planner.beta, Job{});
  const Result<double> length = tour::freeLowerBound(*basis.floor, visits, 0.0, Job{});
  if (cost && length) {
    print(name, "cost, most that can be saved", percentBelow(*cost, before.cost), "%", "proved, core/tour/free_bound");
    print(name, "length, most that can be saved", percentBelow(*length, before.length), "%", "proved, straight lines between targets");
  }
}

void refine(const std::string& name, Result<tour::PlanInput> input, Gains& gains) {
  if (!input) {
    bench::countFailure(name, input.error());
    return;
  }
  input->mission.planner.refine = mission::Refine::None;
  tour::PlanBasis basis;
  const Result<mission::Plan> sampled = tour::planTour(*input, Job{}, nullptr, {}, nullptr, &basis);
  input->mission.planner.refine = mission::Refine::Full;
  tour::PlanTimes times;
  const Result<mission::Plan> refined = sampled ? tour::planTour(*input, Job{}, &times) : sampled;
  if (!sampled || !refined) {
    bench::countFailure(name, (sampled ? refined : sampled).error());
    return;
  }
  const mission::PlanMetrics& before = sampled->metrics;
  const mission::PlanMetrics& after = refined->metrics;
  print(name, "cost over sampled headings", before.cost, "m");
  print(name, "cost, refined", after.cost, "m");
  print(name, "cost saved", percentBelow(after.cost, before.cost), "%");
  print(name, "length over sampled headings", before.length, "m");
  print(name, "length, refined", after.length, "m");
  print(name, "length saved", percentBelow(after.length, before.length), "%");
  printBounds(name, *input, basis, before);
  print(name, "changes tried", static_cast<double>(after.movesTried));
  print(name, "changes accepted", static_cast<double>(after.movesAccepted));
  print(name, "queries", static_cast<double>(after.safeQueries - before.safeQueries));
  print(name, "time", times.refinement, "s");
  gains.cost.push_back(percentBelow(after.cost, before.cost));
  gains.length.push_back(percentBelow(after.length, before.length));
  bench::verify(name, *input, *refined);
  input->mission.planner.refine = mission::Refine::None;
  bench::verify(name + ", not refined", *input, *sampled);
}

void benchReplan(const std::string& file) {
  const std::string name = "replan " + std::filesystem::path(file).stem().string();
  Result<tour::PlanInput> input = bench::load(file);
  if (!input) {
    bench::countFailure(name, input.error());
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
    auto start = bench::Clock::now();
    const Result<mission::Plan> again = planner.plan(*input, Job{});
    plan += secondsSince(start);
    if (!again || !planner.reused().tour) {
      fmt::print(stderr, "{}: {}\n", name, again ? "began afresh" : again.error().message());
      return;
    }
    start = bench::Clock::now();
    const bool certified = bench::verify(name, *input, *again);
    check += secondsSince(start);
    start = bench::Clock::now();
    const std::string text = formats::planToJson(*again);
    write += secondsSince(start);
    const Result<mission::Plan> fresh = tour::planTour(*input, Job{});
    ratio += fresh && certified && !text.empty() ? again->metrics.cost / fresh->metrics.cost : 1e9;
    queries += static_cast<double>(again->metrics.safeQueries);
  }
  print(name, "plan and check", 1e3 * (plan + check) / kMoves, "ms", "mean of five moves");
  print(name, "plan", 1e3 * plan / kMoves, "ms");
  print(name, "check", 1e3 * check / kMoves, "ms");
  print(name, "JSON", 1e3 * write / kMoves, "ms");
  print(name, "queries", queries / kMoves, "");
  print(name, "cost of a fresh plan", 100.0 * ratio / kMoves, "%");
}

}  // namespace

int main(int argc, char** argv) {
  Gains gains;
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--replan" && i + 1 < words.size()) {
      benchReplan(words[++i]);
    } else if (words[i] == "--real") {
      for (const auto& [name, mission] : bench::realMissions()) {
        refine("refine " + name, bench::load(mission), gains);
      }
    } else {
      refine("refine " + std::filesystem::path(words[i]).stem().string(), bench::load(words[i]), gains);
    }
  }
  if (!gains.cost.empty()) {
    print("refine", "missions", static_cast<double>(gains.cost.size()));
    print("refine", "median cost saved", median(gains.cost), "%");
    print("refine", "median length saved", median(gains.length), "%");
  }
  return bench::verdict("bench_refine");
}
