#include "core/flight/dubins_airplane.h"

#include <algorithm>

namespace vp::flight {

DubinsAirplanePath dubinsAirplane(const geo::Pose& from, double fromAltitude, const geo::Pose& to, double toAltitude, double radius, double maxClimb,
                                  double maxDescent) {
  const DubinsPath path = shortestDubins(from, to, radius);
  const double length = path.length();
  return {path, std::max(fromAltitude, toAltitude - maxClimb * length), std::max(toAltitude, fromAltitude - maxDescent * length)};
}

}  // namespace vp::flight
