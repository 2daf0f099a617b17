#include "core/safety/cell_walk.h"

#include "core/base/quantity.h"
#include "core/safety/limits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::safety {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Half width of the strip around a grid line inside which both sides count; larger than kTouch so that a stretch outside
/// the strips touches one column only.
constexpr double kStrip = 2.0 * kTouch;

/// Calls visit(edge) for both edges of the strip around every grid line of one axis that [low, high] may meet. Lines beyond
/// the map do not exist: all of the outside is one unknown.
template <typename Visit>
void forEachStripEdge(double origin, double cell, int count, double low, double high, Visit visit) {
  const double first = std::clamp(std::floor((low - origin) / cell), 0.0, static_cast<double>(count));
  const double last = std::clamp(std::ceil((high - origin) / cell), 0.0, static_cast<double>(count));
  for (int k = static_cast<int>(first); k <= static_cast<int>(last); ++k) {
    const double line = origin + k * cell;
    visit(line - kStrip);
    visit(line + kStrip);
  }
}

}  // namespace

bool Span::isKnown() const {
  return ground < kInfinity;
}

CellWalk::CellWalk(const terrain::ElevationGrid& terrain) : terrain_(terrain) {}

void CellWalk::start(const geo::Pose& start, const flight::Piece& piece) {
  start_ = start;
  length_ = piece.length;
  isArc_ = piece.turn != flight::Turn::Straight;
  breaks_.clear();
  index_ = 0;
  lapStart_ = 0.0;
  at_ = 0.0;
  done_ = false;
  if (isArc_) {
    circle_ = circleOf(start, piece);
    lap_ = 2.0 * Angle::kPi * circle_.radius;
    collectArc();
  } else {
    cosHeading_ = std::cos(start.heading);
    sinHeading_ = std::sin(start.heading);
    lap_ = kInfinity;
    collectLine();
  }
  std::sort(breaks_.begin(), breaks_.end());
  if (length_ > lap_) {
    breaks_.push_back(lap_);  // the start may itself be a turning point, which the laps after the first must stop at as well
  }
  pointAt_ = pointAt(0.0);
}

geo::Point CellWalk::pointAt(double distance) const {
  if (isArc_) {
    return circle_.at(distance);
  }
  return {start_.x + distance * cosHeading_, start_.y + distance * sinHeading_};
}

void CellWalk::collectLine() {
  const geo::Point end = pointAt(length_);
  const auto collect = [this](double origin, int count, double from, double to, double slope) {
    forEachStripEdge(origin, terrain_.cellSize(), count, std::min(from, to), std::max(from, to), [&](double edge) {
      const double distance = (edge - from) / slope;  // slope 0 gives an infinity or NaN, neither of which is inside
      if (distance > 0.0 && distance < length_) {
        breaks_.push_back(distance);
      }
    });
  };
  collect(terrain_.originX(), terrain_.columns(), start_.x, end.x, cosHeading_);
  collect(terrain_.originY(), terrain_.rows(), start_.y, end.y, sinHeading_);
}

void CellWalk::collectArc() {
  const double reach = std::min(length_, lap_);
  const auto add = [this, reach](double angle) {
    const double distance = circle_.radius * wrapTwoPi(circle_.side * (angle - circle_.firstAngle));
    if (distance > 0.0 && distance < reach) {
      breaks_.push_back(distance);
    }
  };
  const double r = circle_.radius;
  const geo::Point c = circle_.centre;
  forEachStripEdge(terrain_.originX(), terrain_.cellSize(), terrain_.columns(), c.x - r, c.x + r, [&](double edge) {
    const double ratio = (edge - c.x) / r;
    if (std::abs(ratio) < 1.0) {
      const double angle = std::acos(ratio);
      add(angle);
      add(-angle);
    }
  });
  forEachStripEdge(terrain_.originY(), terrain_.cellSize(), terrain_.rows(), c.y - r, c.y + r, [&](double edge) {
    const double ratio = (edge - c.y) / r;
    if (std::abs(ratio) < 1.0) {
      const double angle = std::asin(ratio);
      add(angle);
      add(Angle::kPi - angle);
    }
  });
  // The turning points of x and y: between two breaks both are monotone, so the ends of a stretch span its box.
  for (int quarter = 0; quarter < 4; ++quarter) {
    add(quarter * Angle::kPi / 2.0);
  }
}

bool CellWalk::next(Span& span) {
  if (done_) {
    return false;
  }
  if (index_ == breaks_.size() && lapStart_ + lap_ < length_) {
    index_ = 0;
    lapStart_ += lap_;
  }
  double to = length_;
  if (index_ < breaks_.size()) {
    to = std::clamp(lapStart_ + breaks_[index_++], at_, length_);
  }
  done_ = to >= length_;
  const geo::Point p = pointAt(to);
  span = {at_, to, groundIn(pointAt_, p)};
  at_ = to;
  pointAt_ = p;
  return true;
}

double CellWalk::groundIn(geo::Point a, geo::Point b) const {
  const double cell = terrain_.cellSize();
  const double firstColumn = std::floor((std::min(a.x, b.x) - kTouch - terrain_.originX()) / cell);
  const double lastColumn = std::floor((std::max(a.x, b.x) + kTouch - terrain_.originX()) / cell);
  const double firstRow = std::floor((std::min(a.y, b.y) - kTouch - terrain_.originY()) / cell);
  const double lastRow = std::floor((std::max(a.y, b.y) + kTouch - terrain_.originY()) / cell);
  if (!(firstColumn >= 0.0 && firstRow >= 0.0 && lastColumn < terrain_.columns() && lastRow < terrain_.rows())) {
    return kInfinity;
  }
  double highest = -kInfinity;
  for (int row = static_cast<int>(firstRow); row <= static_cast<int>(lastRow); ++row) {
    for (int column = static_cast<int>(firstColumn); column <= static_cast<int>(lastColumn); ++column) {
      const double ground = static_cast<double>(terrain_.upperInCell(column, row));
      if (!(ground >= kLowestGround && ground < kInfinity)) {
        return kInfinity;
      }
      highest = std::max(highest, ground);
    }
  }
  return highest;
}

}  // namespace vp::safety
