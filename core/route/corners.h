#pragma once

#include "core/mission/plan.h"

#include <vector>

namespace vp::route {

/** A corner of the polygon whose fly-by turns are the tour. */
struct Corner {
  geo::Point point;
  double radius = 0.0;        ///< m, of the turn at it
  double angle = 0.0;         ///< rad of heading change, left positive
  int target = -1;            ///< visited at or beside this corner
  double tourDistance = 0.0;  ///< m along the tour from the first visit to the middle of the turn
  geo::Pose entry;            ///< where the turn begins on the tour
};

/** How many corners may be saved at the price of leaving the tour. */
struct CornerLimits {
  double beside = 10.0;    ///< m that the corner of a target may lie beside it; the path still leads over the target
  double lateral = 2.0;    ///< m from the tour to the polygon without a corner that is left out
  double vertical = 15.0;  ///< m that the altitude between two corners may differ from the tour's before one is added
};

/** The tangent polygon of the tour, beginning at the first target that it visits: a fly-by turn at the meeting point of an arc's
 *  tangents is the arc. Arcs of more than 120 degrees are split. Targets lie on the polygon, or (CornerLimits::beside) on the
 *  turn at their corner, which stands for the arc to both sides of them. @pre the tour is not empty */
std::vector<Corner> tangentCorners(const mission::Plan& plan, const CornerLimits& limits);

/** The same for an open way, the last of whose points has no `onward`: the first and the last corner are its ends. */
std::vector<Corner> openCorners(const std::vector<mission::DecisionPoint>& way, const CornerLimits& limits);

/** Index of the first decision point that visits a target; 0 if none does. */
std::size_t firstVisit(const mission::Plan& plan);

}  // namespace vp::route
