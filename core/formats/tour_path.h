#pragma once

#include "core/flight/curve.h"
#include "core/geo/pose.h"
#include "core/mission/plan.h"

#include <vector>

namespace vp::formats {

/** A point of a drawn path: where, how high, and which target is visited here (-1: none). */
struct PathPoint {
  geo::Point point;
  double altitude = 0.0;  ///< m MSL
  int target = -1;
};

/** Points along a piece after its start, its end included, with chords at most `error` metres off the arc (straight
 *  pieces: the end alone). Never more than 10,000, whatever a plan says. */
std::vector<geo::Point> chordPoints(const geo::Pose& start, const flight::Piece& piece, double error);

/** The closed tour from decision point `first` back to it: every decision point and the chord points between, altitude
 *  linear along each piece. The last point repeats the first. @pre the tour is not empty */
std::vector<PathPoint> tourPath(const mission::Plan& plan, std::size_t first, double error);

}  // namespace vp::formats
