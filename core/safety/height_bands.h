#pragma once

#include "core/safety/plan_conditions.h"

#include <vector>

namespace vp::safety {

/** Altitudes at which the same winds and airspeeds count. */
struct HeightBand {
  std::vector<air::WindLayer> winds;  ///< those next to it: every wind between theirs
  double shear = 0.0;                 ///< greatest change of the wind with height [1/s]
  Airspeeds glide;                    ///< over all masses and the densities between its edges
};

/** A plan's altitudes cut into bands: WHY.md section 12. */
struct HeightBands {
  std::vector<double> edges;      ///< m MSL, ascending, between neighbouring bands
  std::vector<HeightBand> bands;  ///< from the lowest, one more than edges
};

/** Edges at all layers where there are several, and in an atmosphere every kBandHeight between the lowest and the highest altitude of the
 *  conditions. One band without either.   @pre as conditionsOf */
HeightBands heightBands(const PlanConditions& conditions, const aircraft::AircraftProfile& profile);

}  // namespace vp::safety
