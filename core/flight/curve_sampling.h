#pragma once

#include "core/flight/curve.h"

namespace vp::flight {

/** Pose after `length` metres of a piece flown from `start` in calm air: exact closed form.
 *  Curvature is 0 or +-1/radius, so no series and no step. @accuracy rounding only (tst_curve) */
geo::Pose poseAfter(const geo::Pose& start, const Piece& piece, double length);

/** The same for the whole piece. */
inline geo::Pose endOf(const geo::Pose& start, const Piece& piece) {
  return poseAfter(start, piece, piece.length);
}

/** Pose at the end of a curve over the ground. `airspeed` [m/s] turns the wind into drift and matters only with wind. */
geo::Pose endOf(const Curve& curve, double airspeed);

/** Pose over the ground after `length` metres of air path along the curve, clamped to its ends. */
geo::Pose poseAlong(const Curve& curve, double length, double airspeed);

/** Total length of the air path [m]. */
double lengthOf(const Curve& curve);

/** Smallest closed box that holds the part [from, to] of a piece flown from `start` in calm air: exact for arcs too. */
geo::Box boxOf(const geo::Pose& start, const Piece& piece, double from, double to);

/** Samples along a curve at most `step` metres apart, ends and joints included. For drawing and export, never for proofs. */
std::vector<geo::Pose> sample(const Curve& curve, double step, double airspeed);

}  // namespace vp::flight
