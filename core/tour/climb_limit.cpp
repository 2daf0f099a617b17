#include "core/tour/climb_limit.h"

#include "core/aircraft/climb.h"
#include "core/mission/glide_conditions.h"

#include <fmt/core.h>

#include <cmath>

namespace vp::tour {
namespace {

constexpr int kMostRounds = 6;
constexpr double kAnew = 50.0;         // m that the next round may get higher
constexpr double kLeastClimb = 0.005;  // 1 : 200; below it a tour over any hill would be tens of kilometres of climb

}  // namespace

Result<mission::Plan> planWithinClimb(const mission::Mission& mission, const landing::World& world, PitchLimits& pitch,
                                      const std::function<Result<mission::Plan>()>& once) {
  const aircraft::GlideConditions conditions = mission::glideConditionsOf(mission, world.sites);
  const auto left = [&](double altitude) {
    return aircraft::climbSlopeOverGround(mission.aircraft, conditions, world.glide, geo::HeightMsl::fromMetres(altitude));
  };
  double highest = 0.0;
  for (int round = 0; round < kMostRounds; ++round) {
    Result<mission::Plan> plan = once();
    if (!plan) {
      return plan;
    }
    highest = mission::highestAltitude(*plan);
    if (pitch.climb <= left(highest + mission::kClimbReserve)) {
      return plan;
    }
    pitch.climb = left(highest + mission::kClimbReserve + kAnew);
    if (!(pitch.climb >= kLeastClimb)) {
      break;
    }
  }
  return fail(Errc::NoSolution,
              fmt::format("the tour has to go up to {:.0f} m MSL ({:.0f} ft), where {} hardly climbs in this air; set a lower ceiling or leave out "
                          "the highest targets",
                          std::ceil(highest), std::ceil(highest / kMetresPerFoot), mission.aircraft.name));
}

}  // namespace vp::tour
