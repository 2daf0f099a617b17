#pragma once

#include "core/air/wind_layer.h"
#include "core/aircraft/aircraft_profile.h"
#include "core/safety/plan_conditions.h"

namespace vp::safety {

/** Greatest |a - b| [m/s] of a wind a of the one sector and b of the other: exact but for rounding. */
double greatestDifference(const air::WindSector& a, const air::WindSector& b);

/** Greatest change of the wind with height between two neighbouring layers [1/s]: of all winds of both, each evenly from the one to the other.
 *  @pre the layers lie at different altitudes */
double shearBetween(const air::WindLayer& a, const air::WindLayer& b);

/** What sinking through a wind that changes with height costs an aircraft that holds its airspeed: factors of its rate of sink. */
struct ShearCost {
  double straight = 1.0;  ///< straight on, at most; infinity where there is no glide
  double turn = 1.0;      ///< in turns, at most: the same, or more where a strong wind from the side leaves no room for it (WHY.md section 12)
  double least = 1.0;     ///< at least, where the change helps

  /** The worst of both. */
  [[nodiscard]] ShearCost with(const ShearCost& other) const;
  /** True if some glide is left. */
  [[nodiscard]] bool isGlide() const;
};

/** @param speeds     airspeeds of the glide there
 *  @param strongest  wind there [m/s]
 *  @param shear      greatest change of the wind with height [1/s]; 0: it costs nothing, to the last bit
 *  @pre the profile is sound */
ShearCost shearCost(const aircraft::AircraftProfile& profile, const PlanConditions& conditions, const Airspeeds& speeds, double strongest,
                    double shear);

}  // namespace vp::safety
