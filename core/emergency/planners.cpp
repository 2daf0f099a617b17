#include "core/emergency/planners.h"

#include "core/emergency/anytime_planner.h"
#include "core/emergency/combined_planner.h"
#include "core/emergency/fmt_planner.h"
#include "core/emergency/gradient_planner.h"
#include "core/emergency/roadmap_planner.h"

#include <algorithm>
#include <array>

namespace vp::emergency {
namespace {

struct Entry {
  std::string_view name;
  std::unique_ptr<LandingPlanner> (*make)();
};

template <typename Planner>
std::unique_ptr<LandingPlanner> made() {
  return std::make_unique<Planner>();
}

std::unique_ptr<LandingPlanner> plainFmt() {
  return std::make_unique<FmtPlanner>(FmtPlanner::plain());
}

std::unique_ptr<LandingPlanner> octreeFmt() {
  return std::make_unique<FmtPlanner>(FmtOptions{});
}

/// All planners but "combined", in the order in which it begins them: the quickest first.
constexpr std::array kPlanners{
    Entry{"roadmap", made<RoadmapPlanner>}, Entry{"dubins", made<DubinsPlanner>}, Entry{"gradient", made<GradientPlanner>},
    Entry{"anytime", made<AnytimePlanner>}, Entry{"fmt-octree", octreeFmt},       Entry{"fmt", plainFmt},
};

constexpr std::string_view kCombined = "combined";

}  // namespace

std::vector<std::string> plannerNames() {
  std::vector<std::string> names;
  for (const Entry& entry : kPlanners) {
    names.emplace_back(entry.name);
  }
  names.emplace_back(kCombined);
  return names;
}

std::unique_ptr<LandingPlanner> makePlanner(std::string_view name) {
  if (name == kCombined) {
    std::vector<std::unique_ptr<const LandingPlanner>> all;
    for (const Entry& entry : kPlanners) {
      all.push_back(entry.make());
    }
    return std::make_unique<CombinedPlanner>(std::move(all));
  }
  const auto found = std::find_if(kPlanners.begin(), kPlanners.end(), [name](const Entry& entry) { return entry.name == name; });
  return found == kPlanners.end() ? nullptr : found->make();
}

}  // namespace vp::emergency
