#pragma once

#include "core/mission/plan.h"

#include <optional>
#include <vector>

namespace vp::route {

/** A height that the path must not be below. */
struct Required {
  double distance = 0.0;  ///< m along the path
  double altitude = 0.0;  ///< m MSL
};

struct Pitch {
  double climb = 0.0;    ///< tangent of the steepest climb, > 0
  double descent = 0.0;  ///< tangent of the steepest descent, > 0
};

/** Limits over ground that hold up to some way above the plan's highest point. */
Pitch pitchOf(const mission::Plan& plan);

/** Altitudes of waypoints on a closed path, in whole feet [m MSL]: linear in distance between them the path is nowhere below what
 *  is required and nowhere steeper than the limits.
 *  @param knots   m along the path of each waypoint, ascending from 0 to `length`, which is that of the whole path
 *  @param required  in any order, distances in [0, length] */
std::vector<double> waypointAltitudes(const std::vector<double>& knots, double length, const std::vector<Required>& required, Pitch pitch);

/** Altitude between waypoints, linear in distance around the closed path. */
double altitudeBetween(const std::vector<double>& knots, const std::vector<double>& altitudes, double length, double distance);

/** A waypoint of an open way. */
struct WayKnot {
  double distance = 0.0;           ///< m along the way
  std::optional<double> altitude;  ///< m MSL where it is given; else it is to be found
};

/** The same for an open way: as high as wanted where the limits of pitch allow that between the given altitudes, in whole feet where none is
 *  given. What they do not allow is left to the caller to find.
 *  @param knots  ascending; the first and the last are the ends */
std::vector<double> wayAltitudes(const std::vector<WayKnot>& knots, const std::vector<Required>& wanted, Pitch pitch);

/** Altitude between waypoints of an open way, linear in distance. */
double altitudeBetween(const std::vector<WayKnot>& knots, const std::vector<double>& altitudes, double distance);

}  // namespace vp::route
