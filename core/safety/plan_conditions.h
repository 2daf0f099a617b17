#pragma once

#include "core/air/atmosphere.h"
#include "core/air/wind_layer.h"
#include "core/aircraft/aircraft_profile.h"
#include "core/mission/plan.h"

#include <optional>
#include <vector>

namespace vp::safety {

/** True airspeeds that may be flown [m/s]. */
struct Airspeeds {
  double least = 0.0;
  double most = 0.0;
};

/** What the glides of a plan depend on beside its aircraft's profile: WHY.md section 9. */
struct PlanConditions {
  std::vector<air::WindLayer> winds;
  std::optional<air::Atmosphere> air;  ///< none: the profile's density at every altitude
  Airspeeds glide;                     ///< over all masses, and all densities between `lowest` and `highest`
  Airspeeds tour;                      ///< of the power setting; without one those of the glide, down to the lowest spiral
  double dragFactor = 1.0;             ///< of the whole polar
  double zeroLiftDrag = 0.0;           ///< C_D0 with the propeller as the mission has it
  double lowest = 0.0;                 ///< m MSL: the lowest site of the plan, where a glide ends at the lowest
  double highest = 0.0;                ///< m MSL: what its tour, ways and spirals reach

  /** True if glides are those of the profile as it is: one airspeed, its own polar. */
  [[nodiscard]] bool isAsInProfile(const aircraft::AircraftProfile& profile) const;
};

/** The profile as it is, its masses included, at its own density. */
PlanConditions conditionsOf(const aircraft::AircraftProfile& profile, const std::vector<air::WindLayer>& winds);

/** @pre the numbers, the profile and the settings of the plan are sound */
PlanConditions conditionsOf(const mission::Plan& plan);

/** Of the glide between two altitudes [m MSL], as far as they are ones of the plan: over all masses, and the densities there. */
Airspeeds glideAirspeeds(const PlanConditions& conditions, const aircraft::AircraftProfile& profile, double bottom, double top);

/** Of the tour at an altitude [m MSL]: the power setting's, or at best glide speed and the profile's own mass [m/s]. */
double tourAirspeedAt(const mission::Mission& mission, double altitude);

}  // namespace vp::safety
