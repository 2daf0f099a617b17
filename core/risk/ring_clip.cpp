#include "core/risk/ring_clip.h"

#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::risk {
namespace {

constexpr double kOnSide = 1e-6;    // m: nearer than this a place is on a side
constexpr double kShortest = 1e-9;  // m: parts of a leg shorter than this are rounding
constexpr double kSlack = 1e-9;     // of a side or leg: an end that rounding moved; a place too many does no harm, one too few would

double squareOfDistance(geo::Point p, geo::Point a, geo::Point b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double t = square > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  const double ex = a.x + t * dx - p.x;
  const double ey = a.y + t * dy - p.y;
  return ex * ex + ey * ey;
}

/// A straight leg, to be met by sides.
class StraightLeg {
public:
  StraightLeg(const geo::Pose& from, double length)
      : from_(from.point()), ux_(std::cos(from.heading)), uy_(std::sin(from.heading)), length_(length) {}

  void meet(geo::Point a, geo::Point b, std::vector<double>& out) const {
    // both ends of the side in the frame of the leg: to its left, and along it
    const double leftA = leftOf(a);
    const double leftB = leftOf(b);
    if (leftA * leftB > 0.0 && std::min(std::abs(leftA), std::abs(leftB)) > kOnSide) {
      return;
    }
    const double alongA = alongOf(a);
    const double alongB = alongOf(b);
    if (std::abs(leftA) <= kOnSide && std::abs(leftB) <= kOnSide) {  // along the side: it begins and ends to be on it
      add(alongA, out);
      add(alongB, out);
    } else if (leftA != leftB) {
      add(alongA + std::clamp(leftA / (leftA - leftB), 0.0, 1.0) * (alongB - alongA), out);
    }
  }

private:
  [[nodiscard]] double leftOf(geo::Point p) const { return -(p.x - from_.x) * uy_ + (p.y - from_.y) * ux_; }
  [[nodiscard]] double alongOf(geo::Point p) const { return (p.x - from_.x) * ux_ + (p.y - from_.y) * uy_; }
  void add(double s, std::vector<double>& out) const {
    if (s > 0.0 && s < length_) {
      out.push_back(s);
    }
  }

  geo::Point from_;
  double ux_;
  double uy_;
  double length_;
};

/// A turn: a side meets its circle in up to two places.
class ArcLeg {
public:
  ArcLeg(const geo::Pose& from, const flight::Piece& piece)
      : sign_(piece.turn == flight::Turn::Left ? 1.0 : -1.0),
        centre_{from.x - sign_ * piece.radius * std::sin(from.heading), from.y + sign_ * piece.radius * std::cos(from.heading)},
        start_(std::atan2(from.y - centre_.y, from.x - centre_.x)),
        radius_(piece.radius),
        length_(piece.length) {}

  void meet(geo::Point a, geo::Point b, std::vector<double>& out) const {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double px = a.x - centre_.x;
    const double py = a.y - centre_.y;
    const double square = dx * dx + dy * dy;
    const double middle = px * dx + py * dy;
    const double root = middle * middle - square * (px * px + py * py - radius_ * radius_);
    if (!(square > 0.0) || root < 0.0) {
      return;
    }
    for (const double side : {-1.0, 1.0}) {
      const double t = (-middle + side * std::sqrt(root)) / square;
      if (t < -kSlack || t > 1.0 + kSlack) {
        continue;
      }
      const double angle = std::atan2(py + t * dy, px + t * dx);
      const double once = wrapTwoPi(sign_ * (angle - start_)) * radius_;
      for (double s = once; s < length_; s += 2.0 * Angle::kPi * radius_) {
        if (s > 0.0) {
          out.push_back(s);
        }
      }
    }
  }

private:
  double sign_;
  geo::Point centre_;
  double start_;
  double radius_;
  double length_;
};

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
  const std::size_t first = first_[slabOf(near.minY)];
  const std::size_t last = first_[slabOf(near.maxY) + 1];
  const auto meetNear = [&](const auto& leg) {
    for (std::size_t i = first; i < last; ++i) {
      const geo::Point a = sides_[i].a;
      const geo::Point b = sides_[i].b;
      if (std::max(a.x, b.x) >= near.minX && std::min(a.x, b.x) <= near.maxX && std::max(a.y, b.y) >= near.minY && std::min(a.y, b.y) <= near.maxY) {
        leg.meet(a, b, out);
      }
    }
  };
  if (piece.turn == flight::Turn::Straight) {
    meetNear(StraightLeg(from, piece.length));
  } else {
    meetNear(ArcLeg(from, piece));
  }
}

void PolygonSides::insideAlong(const geo::Pose& from, const flight::Piece& piece, const geo::Box& within, std::vector<Inside>& out) const {
  thread_local std::vector<double> places;
  out.clear();
  places.assign(1, 0.0);
  crossings(from, piece, within, places);
  places.push_back(piece.length);
  std::sort(places.begin(), places.end());
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    if (places[k + 1] - places[k] < kShortest) {
      continue;
    }
    const double share = shareAt(flight::poseAfter(from, piece, 0.5 * (places[k] + places[k + 1])).point());
    if (share > 0.0) {
      out.push_back({places[k], places[k + 1], share});
    }
  }
}

}  // namespace vp::risk
