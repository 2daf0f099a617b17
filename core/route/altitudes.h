#pragma once

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

/** Altitudes of waypoints on a closed path, in whole feet [m MSL]: linear in distance between them the path is nowhere below what
 *  is required and nowhere steeper than the limits.
 *  @param knots   m along the path of each waypoint, ascending from 0 to `length`, which is that of the whole path
 *  @param required  in any order, distances in [0, length] */
std::vector<double> waypointAltitudes(const std::vector<double>& knots, double length, const std::vector<Required>& required, Pitch pitch);

/** Altitude between waypoints, linear in distance around the closed path. */
double altitudeBetween(const std::vector<double>& knots, const std::vector<double>& altitudes, double length, double distance);

}  // namespace vp::route
