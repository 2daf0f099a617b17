#include "core/safety/climb_left.h"

#include "core/safety/limits.h"
#include "core/safety/plan_conditions.h"
#include "core/safety/standard_air.h"

#include <cmath>

namespace vp::safety {

Angle steepestClimb(const mission::Mission& mission, double altitude) {
  const aircraft::AircraftProfile& profile = mission.aircraft;
  if (!profile.climbRate || !profile.serviceCeiling) {
    return profile.maxClimb;
  }
  const double felt = mission.atmosphere ? densityAltitudeOf(*mission.atmosphere, altitude) : altitude;
  const double share = felt / profile.serviceCeiling->metres();
  const double rate = (1.0 - share) * profile.climbRate->si() + share * kClimbAtServiceCeiling;
  const double sine = rate / tourAirspeedAt(mission, altitude);
  if (!(sine < std::sin(profile.maxClimb.radians()))) {
    return profile.maxClimb;
  }
  return Angle::radians(std::asin(std::max(-1.0, sine)));
}

}  // namespace vp::safety
