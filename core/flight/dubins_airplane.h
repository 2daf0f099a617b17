#pragma once

#include "core/flight/dubins.h"

namespace vp::flight {

/** A Dubins airplane path: the horizontal curve and how altitude may run along it. */
struct DubinsAirplanePath {
  DubinsPath path;
  double startAltitude = 0.0;  ///< m MSL, at least the one asked for
  double endAltitude = 0.0;    ///< m MSL, at least the one asked for
};

/** The Dubins airplane connection of the tour: shortest horizontal path; where the height difference is steeper than the
 *  pitch limits allow, the lower end is raised (a target may be passed above, never below).
 *  Chitsaz and LaValle 2007 lengthen the path by circles instead; [1] section 3 and (4) allow the higher visit at a cost,
 *  which is what the tour uses.
 *  @param maxClimb, maxDescent  tangents of the pitch limits, both > 0
 *  @source Chitsaz, LaValle 2007, CDC, Time-optimal paths for a Dubins airplane; [1] (1), (2) */
DubinsAirplanePath dubinsAirplane(const geo::Pose& from, double fromAltitude, const geo::Pose& to, double toAltitude, double radius, double maxClimb,
                                  double maxDescent);

}  // namespace vp::flight
