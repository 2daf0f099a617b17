#include "core/aircraft/climb.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::aircraft {
namespace {

constexpr double kAtServiceCeiling = 100.0 * 0.3048 / 60.0;  // m/s: 100 ft/min, by definition (14 CFR 1.2 and handbooks)

}  // namespace

double climbRate(const AircraftProfile& profile, geo::HeightMsl densityAltitude) {
  if (!profile.climbRate || !profile.serviceCeiling) {
    return std::numeric_limits<double>::infinity();
  }
  const double atSeaLevel = profile.climbRate->si();
  return atSeaLevel - (atSeaLevel - kAtServiceCeiling) * densityAltitude.metres() / profile.serviceCeiling->metres();
}

double climbSlope(const AircraftProfile& profile, const GlideConditions& conditions, geo::HeightMsl altitude) {
  const double limit = tan(profile.maxClimb);
  const geo::HeightMsl felt = conditions.air ? air::densityAltitude(conditions.air->atmosphere, altitude) : altitude;
  const double sine = climbRate(profile, felt) / tourAirspeed(profile, conditions, altitude);
  if (!(sine < 1.0)) {
    return limit;
  }
  return std::min(limit, sine / std::sqrt(1.0 - std::max(0.0, sine) * sine));
}

double climbSlopeOverGround(const AircraftProfile& profile, const GlideConditions& conditions, const GlideModel& glide, geo::HeightMsl altitude) {
  return glide.slopeOf(Angle::radians(std::atan(climbSlope(profile, conditions, altitude))));
}

}  // namespace vp::aircraft
