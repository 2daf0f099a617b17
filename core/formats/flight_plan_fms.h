#pragma once

#include "core/base/result.h"
#include "core/mission/plan.h"

#include <string>

namespace vp::formats {

/** The tour as an X-Plane 1100 flight plan: closed, from the first target that the tour visits back to it.
 *  Waypoints: every target visit and as many points between as straight legs need to stay within 10 m of the tour;
 *  altitudes in whole feet, never below the plan's altitude anywhere along the tour. Spirals at low targets and glides
 *  are not part of the file.
 *  @errors OutOfRange - the plan has no tour
 *  @source developer.x-plane.com, flight plan files v11 (FMS 1100) */
Result<std::string> toFms1100(const mission::Plan& plan);

}  // namespace vp::formats
