#pragma once

#include "core/base/result.h"
#include "core/flight/curve.h"
#include "core/route/corners.h"

#include <vector>

namespace vp::route {

/** The closed path that fly-by turns around corners give. */
struct FlownPath {
  geo::Pose start;  ///< in the middle of the straight part of a leg
  std::vector<flight::Piece> pieces;
  std::vector<double> passed;  ///< m flown from the start to the middle of the turn at each corner, by corner
  std::vector<double> turned;  ///< rad of heading change at each corner, left positive
  std::size_t first = 0;       ///< the corner that is passed first
  double length = 0.0;
};

/** Flies around the corners: straight along a leg until the turn of the corner's radius ends on the next leg. Where a leg is too
 *  short for the turns at its ends the second is begun at once and ends beside the next leg, which the turn after it makes up for.
 *  So every turn has the radius of its corner.
 *  @errors OutOfRange - fewer than two places, or legs too short to come back to where the path began */
Result<FlownPath> flyAround(const std::vector<Corner>& corners);

}  // namespace vp::route
