#pragma once

#include "core/geo/local_frame.h"
#include "core/mission/plan.h"

#include <string>
#include <vector>

namespace vp::mission {

/** A place that a navigator flies to. Its turn is a fly-by turn: begun before the place and ended on the next leg. */
struct RouteWaypoint {
  std::string name;  ///< a target's, or a number; unique in the route
  geo::LatLon place;
  double altitude = 0.0;    ///< m MSL, whole feet
  int target = -1;          ///< index into Plan::targets if a target is visited on the way past this waypoint
  double turnRadius = 0.0;  ///< m, of the fly-by turn
  double turn_deg = 0.0;    ///< heading change of it, left positive
  double distance = 0.0;    ///< m flown from the first waypoint to this one
  int site = -1;            ///< index into Plan::sites if this is the threshold of a home runway, on the ground
  std::string note;         ///< what a pilot is to know of this place, in ASCII; mostly empty
};

/** A point of the path that fly-by turns give. */
struct RoutePoint {
  geo::LatLon place;
  double altitude = 0.0;  ///< m MSL
};

/** A continuous tour as waypoints, and how far flying them leads from it. Either closed, the last waypoint going on to the first, or
 *  from the threshold of a home runway over the tour to that of a home runway. The flight is flown and judged to a point above the last one. */
struct Route {
  bool isClosed = true;
  std::string guarantee;  ///< a sentence on where the gliding guarantee begins and ends, in ASCII; empty for a closed route, guaranteed everywhere
  std::vector<RouteWaypoint> waypoints;
  std::vector<RoutePoint> flown;    ///< the path with its arcs as chords, from the first waypoint on; closed: the last point repeats the first
  double length = 0.0;              ///< m, of the flown path over the ground
  double lateral = 0.0;             ///< m, largest distance between the flown path and the tour, ways from and to home included
  double above = 0.0;               ///< m, most that the flown path is above the tour
  double visit = 0.0;               ///< m, largest distance at which a target is passed
  double besideWaypoint = 0.0;      ///< m, largest distance of a target's waypoint from the target
  double stepsPerDegree = 1000000;  ///< places are whole multiples of 1 / so many degrees
  std::string mark;                 ///< what a file is to say before all else, in ASCII; empty for a verified route
};

}  // namespace vp::mission
