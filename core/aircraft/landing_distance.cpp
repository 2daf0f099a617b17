#include "core/aircraft/landing_distance.h"

#include <algorithm>
#include <cmath>

namespace vp::aircraft {
namespace {

constexpr double kOfStall = 1.3;      // approach speed per stall speed, 14 CFR 23.75 (a)
constexpr double kOfTailwind = 1.5;   // AC 23-8
constexpr double kOfHeadwind = 0.5;   // AC 23-8
constexpr double kPerPercent = 0.05;  // longer per percent downhill

double windFactor(const AircraftProfile& profile, const LandingConditions& conditions, double density) {
  const double reference = profile.stallSpeed ? kOfStall * profile.stallSpeed->si() : profile.bestGlideSpeed.si();
  const double airspeed = reference * std::sqrt(profile.airDensity_kgm3 / density);
  const double counted = conditions.wind.tailwind * (conditions.wind.tailwind > 0.0 ? kOfTailwind : kOfHeadwind);
  const double ratio = std::max(0.0, (airspeed + counted) / airspeed);
  return ratio * ratio;
}

}  // namespace

std::optional<Length> landingDistance(const AircraftProfile& profile, const LandingConditions& conditions) {
  if (!profile.landingDistance) {
    return std::nullopt;
  }
  const double density = air::density(conditions.air, conditions.elevation);
  const double slopeFactor = 1.0 + kPerPercent * std::max(0.0, conditions.downhillPercent);
  return *profile.landingDistance * (air::kSeaLevelDensity / density) * windFactor(profile, conditions, density) * slopeFactor *
         conditions.surfaceFactor;
}

}  // namespace vp::aircraft
