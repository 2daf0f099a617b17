// The slow way and the fast one: the same missions planned over the lattice and over RRT*, without refinement. Either tour is
// proved to be no more than its gap above the best over its own roadmap, so the dearer one may not be dearer by more than that.
#include "tests/bench/bench_support.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace {

using namespace vp;
using bench::print;

std::optional<mission::PlanMetrics> planOver(const std::string& name, tour::PlanInput input, mission::RoadmapKind kind) {
  input.mission.planner.refine = mission::Refine::None;
  input.mission.planner.roadmap = kind;
  const Result<mission::Plan> plan = tour::planTour(input, Job{});
  if (!plan) {
    bench::countFailure(name, plan.error());
    return std::nullopt;
  }
  bench::verify(name, input, *plan);
  return plan->metrics;
}

/// @return whether the two agree
bool compare(const std::string& file) {
  const std::string name = "lattice against RRT* " + std::filesystem::path(file).stem().string();
  const Result<tour::PlanInput> input = bench::load(file);
  if (!input) {
    bench::countFailure(name, input.error());
    return false;
  }
  const auto lattice = planOver(name, *input, mission::RoadmapKind::Lattice);
  const auto tree = planOver(name, *input, mission::RoadmapKind::RrtStar);
  if (!lattice || !tree) {
    return false;
  }
  const mission::PlanMetrics& dearer = lattice->cost > tree->cost ? *lattice : *tree;
  const double apart = dearer.cost - std::min(lattice->cost, tree->cost);
  const double gap = dearer.cost - dearer.lowerBound;
  print(name, "cost", lattice->cost, "m", "reference: over RRT*", tree->cost);
  print(name, "gap", lattice->cost - lattice->lowerBound, "m", "reference: over RRT*", tree->cost - tree->lowerBound);
  print(name, "costs apart", apart, "m", "reference: gap of the dearer tour", gap);
  print(name, "agree", apart <= gap ? 1.0 : 0.0);
  return apart <= gap;
}

}  // namespace

int main(int argc, char** argv) {
  int agreeing = 0;
  for (int i = 1; i < argc; ++i) {
    agreeing += compare(argv[i]) ? 1 : 0;
  }
  print("lattice against RRT*", "missions that agree", agreeing, "", "within the stated gaps", argc - 1);
  return bench::verdict("bench_agreement");
}
