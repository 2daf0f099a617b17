#include "core/emergency/planners.h"

#include "core/emergency/anytime_planner.h"
#include "core/emergency/combined_planner.h"
#include "core/emergency/fmt_planner.h"
#include "core/emergency/gradient_planner.h"
#include "core/emergency/roadmap_planner.h"
#include "core/emergency/weather/weather_planner.h"

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

/// What "combined" runs, in the order in which it begins them: the quickest first.
constexpr std::array kPlanners{
    Entry{"roadmap", made<RoadmapPlanner>}, Entry{"dubins", made<DubinsPlanner>}, Entry{"gradient", made<GradientPlanner>},
    Entry{"anytime", made<AnytimePlanner>}, Entry{"fmt-octree", octreeFmt},       Entry{"fmt", plainFmt},
};

/// Of the planners of [4] those that "combined" asks first where there is weather: the one that answers at once, and the best.
constexpr std::array<std::string_view, 2> kInWeather{"dlvg", "dvprm"};

constexpr std::string_view kCombined = "combined";

std::unique_ptr<LandingPlanner> madeForWeather(std::string_view name) {
  for (const std::string_view known : weatherPlannerNames()) {
    if (known == name) {
      return std::make_unique<WeatherPlanner>(known, *weatherPlannerOptions(known));
    }
  }
  return nullptr;
}

}  // namespace

std::vector<std::string> plannerNames() {
  std::vector<std::string> names;
  names.reserve(kPlanners.size() + weatherPlannerNames().size() + 1);
  for (const Entry& entry : kPlanners) {
    names.emplace_back(entry.name);
  }
  for (const std::string_view name : weatherPlannerNames()) {
    names.emplace_back(name);
  }
  names.emplace_back(kCombined);
  return names;
}

std::vector<std::string> combinedNames(bool hasWeather) {
  std::vector<std::string> names;
  if (hasWeather) {
    names.assign(kInWeather.begin(), kInWeather.end());
  }
  names.reserve(names.size() + kPlanners.size());
  for (const Entry& entry : kPlanners) {
    names.emplace_back(entry.name);
  }
  return names;
}

std::unique_ptr<LandingPlanner> makePlanner(std::string_view name) {
  if (name == kCombined) {
    std::vector<std::unique_ptr<const LandingPlanner>> all;
    all.reserve(kPlanners.size());
    for (const Entry& entry : kPlanners) {
      all.push_back(entry.make());
    }
    std::vector<std::unique_ptr<const LandingPlanner>> inWeather;
    inWeather.reserve(kInWeather.size());
    for (const std::string_view one : kInWeather) {
      inWeather.push_back(madeForWeather(one));
    }
    return std::make_unique<CombinedPlanner>(std::move(all), std::move(inWeather));
  }
  const auto found = std::find_if(kPlanners.begin(), kPlanners.end(), [name](const Entry& entry) { return entry.name == name; });
  return found == kPlanners.end() ? madeForWeather(name) : found->make();
}

}  // namespace vp::emergency
