#include "core/safety/ground_path.h"

#include "core/base/quantity.h"
#include "core/safety/limits.h"

#include <cmath>

namespace vp::safety {

bool isIntegrable(const flight::Piece& piece) {
  if (!(piece.length >= 0.0 && piece.length <= kLongestPath)) {
    return false;
  }
  switch (piece.turn) {
    case flight::Turn::Straight:
      return piece.radius == 0.0;
    case flight::Turn::Left:
    case flight::Turn::Right:
      return piece.radius >= kSmallestRadius && piece.radius <= kLargestRadius && piece.length <= kMostCircles * 2.0 * Angle::kPi * piece.radius;
  }
  return false;
}

geo::Point Circle::at(double distance) const {
  const double angle = firstAngle + side * distance / radius;
  return {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
}

Circle circleOf(const geo::Pose& start, const flight::Piece& piece) {
  Circle circle;
  circle.side = piece.turn == flight::Turn::Left ? 1.0 : -1.0;
  circle.radius = piece.radius;
  // The centre lies to the turning side, at a right angle to the heading.
  circle.centre = {start.x - circle.side * piece.radius * std::sin(start.heading), start.y + circle.side * piece.radius * std::cos(start.heading)};
  circle.firstAngle = start.heading - circle.side * Angle::kPi / 2.0;
  return circle;
}

bool isSelfConsistent(const flight::Piece& piece) {
  switch (piece.turn) {
    case flight::Turn::Straight:
      return piece.radius == 0.0;
    case flight::Turn::Left:
    case flight::Turn::Right:
      return piece.radius < kSmallestRadius || isIntegrable(piece);
  }
  return false;
}

geo::Pose poseOn(const geo::Pose& start, const flight::Piece& piece, double distance) {
  if (piece.turn == flight::Turn::Straight) {
    return {start.x + distance * std::cos(start.heading), start.y + distance * std::sin(start.heading), wrapTwoPi(start.heading)};
  }
  const Circle circle = circleOf(start, piece);
  const geo::Point p = circle.at(distance);
  return {p.x, p.y, wrapTwoPi(start.heading + circle.side * distance / piece.radius)};
}

}  // namespace vp::safety
