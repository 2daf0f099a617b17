#include "core/aircraft/glide_conditions.h"

#include <algorithm>
#include <cmath>

namespace vp::aircraft {

SpeedRange glideSpeeds(const AircraftProfile& profile, const std::optional<AirRange>& range) {
  const double speed = profile.bestGlideSpeed.si();
  SpeedRange speeds{speed * std::sqrt(std::min(1.0, profile.leastMass_kg.value_or(profile.mass_kg) / profile.mass_kg)),
                    speed * std::sqrt(std::max(1.0, profile.mostMass_kg.value_or(profile.mass_kg) / profile.mass_kg))};
  if (range) {
    speeds.least *= std::sqrt(profile.airDensity_kgm3 / air::density(range->atmosphere, range->lowest));
    speeds.most *= std::sqrt(profile.airDensity_kgm3 / air::density(range->atmosphere, range->highest));
  }
  return speeds;
}

double tourAirspeed(const AircraftProfile& profile, const GlideConditions& conditions, geo::HeightMsl altitude) {
  if (conditions.tourSpeed) {
    return conditions.tourSpeed->si();
  }
  return profile.bestGlideSpeed.si() *
         (conditions.air ? std::sqrt(profile.airDensity_kgm3 / air::density(conditions.air->atmosphere, altitude)) : 1.0);
}

double zeroLiftDragOf(const AircraftProfile& profile, Propeller propeller) {
  switch (propeller) {
    case Propeller::AsInPolar:
      break;
    case Propeller::Windmilling:
      return profile.windmillingDrag.value_or(profile.zeroLiftDrag);
    case Propeller::Stopped:
      return profile.stoppedDrag.value_or(profile.zeroLiftDrag);
  }
  return profile.zeroLiftDrag;
}

}  // namespace vp::aircraft
