#include "core/safety/airspace_crossing.h"

#include "core/base/quantity.h"
#include "core/safety/ground_path.h"

#include <algorithm>
#include <cmath>

namespace vp::safety {
namespace {

constexpr double kTouchOnly = 1e-3;  // m

}  // namespace

Outline::Outline(std::vector<geo::Point> corners) : corners_(std::move(corners)) {
  for (const geo::Point& corner : corners_) {
    box_.add(corner);
  }
}

bool Outline::contains(geo::Point point) const {
  bool isInside = false;
  for (std::size_t i = 0, k = corners_.size() - 1; i < corners_.size(); k = i++) {
    const geo::Point a = corners_[i];
    const geo::Point b = corners_[k];
    if ((a.y > point.y) != (b.y > point.y) && point.x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x) {
      isInside = !isInside;
    }
  }
  return isInside;
}

/// Where the line of the piece meets each side: a + t (b - a) = start + s (cos, sin).
void Outline::addLineCrossings(const geo::Pose& start, const flight::Piece& piece, std::vector<double>& at) const {
  const double c = std::cos(start.heading);
  const double s = std::sin(start.heading);
  for (std::size_t i = 0, k = corners_.size() - 1; i < corners_.size(); k = i++) {
    // distance of both ends of the side from the line, and their places along it
    const double sideA = c * (corners_[i].y - start.y) - s * (corners_[i].x - start.x);
    const double sideB = c * (corners_[k].y - start.y) - s * (corners_[k].x - start.x);
    if ((sideA > 0.0) == (sideB > 0.0)) {
      continue;
    }
    const double alongA = c * (corners_[i].x - start.x) + s * (corners_[i].y - start.y);
    const double alongB = c * (corners_[k].x - start.x) + s * (corners_[k].y - start.y);
    const double distance = alongA + (alongB - alongA) * sideA / (sideA - sideB);
    if (distance > 0.0 && distance < piece.length) {
      at.push_back(distance);
    }
  }
}

/// Where the circle of the piece meets each side: |a + t (b - a) - centre| = radius, on every lap.
void Outline::addArcCrossings(const geo::Pose& start, const flight::Piece& piece, std::vector<double>& at) const {
  const Circle circle = circleOf(start, piece);
  const double lap = 2.0 * Angle::kPi * circle.radius;
  for (std::size_t i = 0, k = corners_.size() - 1; i < corners_.size(); k = i++) {
    const double ax = corners_[i].x - circle.centre.x;
    const double ay = corners_[i].y - circle.centre.y;
    const double dx = corners_[k].x - corners_[i].x;
    const double dy = corners_[k].y - corners_[i].y;
    const double length = std::hypot(dx, dy);
    if (length == 0.0) {
      continue;
    }
    const double nearest = -(ax * dx + ay * dy) / length;  // along the side, of the point next to the centre
    const double offset = (ax * dy - ay * dx) / length;    // of the side's line from the centre
    const double half = circle.radius * circle.radius - offset * offset;
    if (half < 0.0) {
      continue;
    }
    for (const double along : {nearest - std::sqrt(half), nearest + std::sqrt(half)}) {
      if (along < 0.0 || along > length) {
        continue;
      }
      const double angle = std::atan2(ay + dy * along / length, ax + dx * along / length);
      double distance = std::fmod(circle.side * (angle - circle.firstAngle), 2.0 * Angle::kPi) * circle.radius;
      distance = distance < 0.0 ? distance + lap : distance;
      const int laps = static_cast<int>(std::ceil((piece.length - distance) / lap));
      for (int n = 0; n < laps; ++n) {
        at.push_back(distance + n * lap);
      }
    }
  }
}

std::vector<InsideStretch> Outline::stretchesInside(const geo::Pose& start, const flight::Piece& piece) const {
  std::vector<InsideStretch> inside;
  const double reach = piece.turn == flight::Turn::Straight ? piece.length : std::min(piece.length, 2.0 * piece.radius);
  if (corners_.size() < 3 || !box_.grown(reach).contains(start.point())) {
    return inside;
  }
  std::vector<double> at{0.0, piece.length};
  if (piece.turn == flight::Turn::Straight) {
    addLineCrossings(start, piece, at);
  } else {
    addArcCrossings(start, piece, at);
  }
  std::sort(at.begin(), at.end());
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const double from = at[i];
    const double to = at[i + 1];
    if (to - from < kTouchOnly || !contains(poseOn(start, piece, 0.5 * (from + to)).point())) {
      continue;
    }
    if (!inside.empty() && from - inside.back().to < kTouchOnly) {
      inside.back().to = to;
    } else {
      inside.push_back({from, to});
    }
  }
  return inside;
}

}  // namespace vp::safety
