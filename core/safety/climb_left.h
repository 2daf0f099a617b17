#pragma once

#include "core/mission/mission.h"

namespace vp::safety {

/** Steepest climb of the tour through the air at an altitude [m MSL]: the profile's limit, or what its rate of climb leaves at the airspeed of the
 *  tour there, whichever is less; below zero where not even its height is kept. Falls with altitude: WHY.md section 13.
 *  @pre the settings and the profile are sound   @threads pure */
Angle steepestClimb(const mission::Mission& mission, double altitude);

}  // namespace vp::safety
