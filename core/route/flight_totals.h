#pragma once

#include "core/mission/plan.h"

#include <optional>

namespace vp::route {

/** How far, how long and with how much fuel or charge. */
struct FlightTotals {
  double length = 0.0;           ///< m over ground
  double seconds = 0.0;          ///< in the middle of the forecast, at the tour's airspeed, climbs and descents at that airspeed too
  double climbed = 0.0;          ///< m, sum of all climbs
  std::optional<double> energy;  ///< in the unit of the mission's power setting; none without one
};

/** Of the tour once around, with its spirals.  @threads pure */
FlightTotals tourTotals(const mission::Plan& plan);

/** Of the whole flight: way to the tour, once around, way home. Of the tour alone where the mission has no home.  @threads pure */
FlightTotals flightTotals(const mission::Plan& plan);

/** Seconds from a decision point to the next [s], the track over ground kept. */
double secondsBetween(const mission::Plan& plan, const mission::DecisionPoint& from, const mission::DecisionPoint& to);

}  // namespace vp::route
