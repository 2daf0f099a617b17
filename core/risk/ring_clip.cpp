#include "core/risk/ring_clip.h"

#include "core/base/quantity.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::risk {
namespace {

constexpr double kOnSide = 1e-6;  // m: nearer than this a place is on a side
constexpr double kSlack = 1e-9;   // of a side or leg: an end that rounding moved; a place too many does no harm, one too few would

double squareOfDistance(geo::Point p, geo::Point a, geo::Point b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double t = square > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  const double ex = a.x + t * dx - p.x;
  const double ey = a.y + t * dy - p.y;
  return ex * ex + ey * ey;
}

/// A straight leg and a side.
void crossStraight(const geo::Pose& from, double length, geo::Point a, geo::Point b, std::vector<double>& out) {
  const double ux = std::cos(from.heading);
  const double uy = std::sin(from.heading);
  // both ends of the side in the frame of the leg: along it, and to its left
  const double alongA = (a.x - from.x) * ux + (a.y - from.y) * uy;
  const double alongB = (b.x - from.x) * ux + (b.y - from.y) * uy;
  const double leftA = -(a.x - from.x) * uy + (a.y - from.y) * ux;
  const double leftB = -(b.x - from.x) * uy + (b.y - from.y) * ux;
  const auto add = [&](double s) {
    if (s > 0.0 && s < length) {
      out.push_back(s);
    }
  };
  if (std::abs(leftA) <= kOnSide && std::abs(leftB) <= kOnSide) {  // along the side: it begins and ends to be on it
    add(alongA);
    add(alongB);
    return;
  }
  if (leftA * leftB > 0.0 && std::min(std::abs(leftA), std::abs(leftB)) > kOnSide) {
    return;
  }
  if (leftA == leftB) {
    return;
  }
  const double t = std::clamp(leftA / (leftA - leftB), 0.0, 1.0);
  add(alongA + t * (alongB - alongA));
}

/// A turn and a side: the side meets the circle in up to two places.
void crossArc(const geo::Pose& from, const flight::Piece& piece, geo::Point a, geo::Point b, std::vector<double>& out) {
  const double sign = piece.turn == flight::Turn::Left ? 1.0 : -1.0;
  const double cx = from.x - sign * piece.radius * std::sin(from.heading);
  const double cy = from.y + sign * piece.radius * std::cos(from.heading);
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double px = a.x - cx;
  const double py = a.y - cy;
  const double square = dx * dx + dy * dy;
  const double middle = px * dx + py * dy;
  const double root = middle * middle - square * (px * px + py * py - piece.radius * piece.radius);
  if (!(square > 0.0) || root < 0.0) {
    return;
  }
  const double start = std::atan2(from.y - cy, from.x - cx);
  for (const double side : {-1.0, 1.0}) {
    const double t = (-middle + side * std::sqrt(root)) / square;
    if (t < -kSlack || t > 1.0 + kSlack) {
      continue;
    }
    const double angle = std::atan2(py + t * dy, px + t * dx);
    const double once = wrapTwoPi(sign * (angle - start)) * piece.radius;
    for (double s = once; s < piece.length; s += 2.0 * Angle::kPi * piece.radius) {
      if (s > 0.0) {
        out.push_back(s);
      }
    }
  }
}

}  // namespace

PolygonSides::PolygonSides(const std::vector<std::vector<geo::Point>>& rings) {
  std::vector<Side> sides;
  for (const std::vector<geo::Point>& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      box_.add(ring[i]);
      sides.push_back({ring[i], ring[(i + 1) % ring.size()]});
    }
  }
  if (sides.empty()) {
    return;
  }
  // about two sides a slab: a place then looks at some few
  const std::size_t slabs = std::max<std::size_t>(1, sides.size() / 2);
  const double height = box_.maxY - box_.minY;
  slabsPerMetre_ = height > 0.0 ? static_cast<double>(slabs) / height : 0.0;
  first_.assign(slabs + 1, 0);
  const auto rangeOf = [this](const Side& side) {
    return std::array{slabOf(std::min(side.a.y, side.b.y) - kOnSide), slabOf(std::max(side.a.y, side.b.y) + kOnSide)};
  };
  for (const Side& side : sides) {
    const auto range = rangeOf(side);
    for (std::size_t slab = range[0]; slab <= range[1]; ++slab) {
      ++first_[slab + 1];
    }
  }
  for (std::size_t slab = 0; slab < slabs; ++slab) {
    first_[slab + 1] += first_[slab];
  }
  sides_.resize(first_[slabs]);
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const Side& side : sides) {
    const auto range = rangeOf(side);
    for (std::size_t slab = range[0]; slab <= range[1]; ++slab) {
      sides_[next[slab]++] = side;
    }
  }
}

std::size_t PolygonSides::slabOf(double y) const {
  const double slab = std::clamp((y - box_.minY) * slabsPerMetre_, 0.0, static_cast<double>(first_.size() - 2));
  return static_cast<std::size_t>(slab);
}

double PolygonSides::shareAt(geo::Point place) const {
  if (sides_.empty() || !box_.grown(kOnSide).contains(place)) {
    return 0.0;
  }
  const std::size_t slab = slabOf(place.y);
  bool isInside = false;
  for (std::size_t i = first_[slab]; i < first_[slab + 1]; ++i) {
    const geo::Point a = sides_[i].a;
    const geo::Point b = sides_[i].b;
    const bool isNear = std::min(a.x, b.x) - kOnSide <= place.x && place.x <= std::max(a.x, b.x) + kOnSide;
    if (isNear && squareOfDistance(place, a, b) <= kOnSide * kOnSide) {
      return 0.5;
    }
    if ((a.y > place.y) != (b.y > place.y) && place.x < a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
      isInside = !isInside;
    }
  }
  return isInside ? 1.0 : 0.0;
}

void PolygonSides::crossings(const geo::Pose& from, const flight::Piece& piece, const geo::Box& within, std::vector<double>& out) const {
  const geo::Box near = within.grown(kOnSide);
  if (sides_.empty() || near.minY > box_.maxY || near.maxY < box_.minY) {
    return;
  }
  const std::size_t last = slabOf(near.maxY);
  for (std::size_t i = first_[slabOf(near.minY)]; i < first_[last + 1]; ++i) {
    const geo::Point a = sides_[i].a;
    const geo::Point b = sides_[i].b;
    if (std::max(a.x, b.x) < near.minX || std::min(a.x, b.x) > near.maxX || std::max(a.y, b.y) < near.minY || std::min(a.y, b.y) > near.maxY) {
      continue;
    }
    if (piece.turn == flight::Turn::Straight) {
      crossStraight(from, piece.length, a, b, out);
    } else {
      crossArc(from, piece, a, b, out);
    }
  }
}

}  // namespace vp::risk
