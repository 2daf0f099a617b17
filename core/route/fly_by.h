#pragma once

#include "core/base/result.h"
#include "core/flight/curve.h"
#include "core/route/corners.h"

#include <vector>

namespace vp::route {

/** The path that fly-by turns around corners give, closed or open. */
struct FlownPath {
  geo::Pose start;  ///< closed: in the middle of the straight part of a leg
  std::vector<flight::Piece> pieces;
  std::vector<double> passed;  ///< m flown from the start to the middle of the turn at each corner, by corner
  std::vector<double> turned;  ///< rad of heading change at each corner, left positive
  std::size_t first = 0;       ///< the corner that is passed first
  double length = 0.0;
};

/** Flies around the corners: straight along a leg until the turn of the corner's radius ends on the next leg. Where a leg is too
 *  short for the turns at its ends the second is begun at once and ends beside the next leg; two turns lead back
 *  onto it, or the turn after it where it is too short. So every turn has the radius of its corner.
 *  @errors OutOfRange - fewer than two places, or legs too short to come back to where the path began */
Result<FlownPath> flyAround(const std::vector<Corner>& corners);

/** The same for an open way from a pose around corners to the last of them: turns onto the leg to the first corner at once. The last
 *  corner's `passed` is the length of the path. `first` is 0. @pre there is a corner */
FlownPath flyOpen(const geo::Pose& start, const std::vector<Corner>& corners);

/** The same from a pose beside the leg from corner 0 to corner 1, on the heading of that leg; corner 0 is passed already. */
FlownPath flyOn(const geo::Pose& start, const std::vector<Corner>& corners);

/** The path from `from` to `to`, in metres from its start, as a path of its own. */
FlownPath partOf(const FlownPath& path, double from, double to);

/** Where the path is after so many metres. */
geo::Pose poseOn(const FlownPath& path, double distance);

}  // namespace vp::route
