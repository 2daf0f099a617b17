#pragma once

#include "core/flight/curve.h"

namespace vp::safety {

/** True if a piece can be flown and integrated: a straight of radius 0, or a turn of kSmallestRadius..kLargestRadius and at
 *  most kMostCircles full circles; length 0..kLongestPath. Everything else in this folder expects such pieces. */
bool isIntegrable(const flight::Piece& piece);

/** False of a piece that contradicts itself and must not be guessed at. Turns below the smallest radius of the aircraft are findings of their own, so
 *  only those no aircraft could fly are found here. */
bool isSelfConsistent(const flight::Piece& piece);

/** The checker's own integration of a piece in calm air (air path = ground path), exact closed form.
 *  @pre isIntegrable(piece), |start| <= kFarthest   @accuracy < 1e-8 m, < 1e-12 rad per piece; heading wrapped to [0, 2 pi) */
geo::Pose poseOn(const geo::Pose& start, const flight::Piece& piece, double distance);

inline geo::Pose endOfPiece(const geo::Pose& start, const flight::Piece& piece) {
  return poseOn(start, piece, piece.length);
}

/** A turn as a part of a circle: point at path distance d is centre + radius * (cos a, sin a), a = firstAngle + side * d / radius. */
struct Circle {
  geo::Point centre;
  double radius = 0.0;
  double firstAngle = 0.0;  ///< rad, direction from the centre to the start
  double side = 1.0;        ///< +1 left (counter-clockwise), -1 right

  [[nodiscard]] geo::Point at(double distance) const;
};

/** @pre piece.turn is Left or Right, piece.radius > 0 */
Circle circleOf(const geo::Pose& start, const flight::Piece& piece);

}  // namespace vp::safety
