#include "core/safety/wind_set.h"

#include "core/base/quantity.h"

#include <algorithm>
#include <cmath>

namespace vp::safety {
namespace {

constexpr double kTwoPi = 2.0 * Angle::kPi;

/// A chord belongs to the hull if no wind lies further out than this. More than rounding; a chord inside the hull does no harm.
constexpr double kSide = 1e-9;  // m/s

double wrappedDistance(double angle) {
  return std::abs(angle - kTwoPi * std::round(angle / kTwoPi));
}

WindSet::Velocity velocity(double speed, double towards) {
  return {speed * std::cos(towards), speed * std::sin(towards)};
}

}  // namespace

AngleRange folded(AngleRange range) {
  const double a = wrappedDistance(range.from);
  const double b = wrappedDistance(range.to);
  const auto contains = [&](double angle) { return angle + kTwoPi * std::ceil((range.from - angle) / kTwoPi) <= range.to; };
  return {contains(0.0) ? 0.0 : std::min(a, b), contains(Angle::kPi) ? Angle::kPi : std::max(a, b)};
}

WindSet::WindSet(const std::vector<air::WindLayer>& layers) {
  for (const air::WindLayer& layer : layers) {
    const air::WindSector& wind = layer.wind;
    const double middle = wind.towards();
    sectors_.push_back({{middle - wind.spread(), middle + wind.spread()}, wind.leastSpeed, wind.mostSpeed});
    strongest_ = std::max(strongest_, wind.mostSpeed);
  }
  for (const Sector& sector : sectors_) {
    const auto [from, to] = sector.towards;
    const bool isWhole = to - from >= kTwoPi;
    extremes_.push_back({sector.most, sector.towards});
    if (!isWhole && sector.least < sector.most) {
      extremes_.push_back({sector.least, {from, from}});
      if (from < to) {
        extremes_.push_back({sector.least, {to, to}});
      }
    }
    if (sectors_.size() == 1) {
      arcs_ = {{sector.most, sector.towards}};
      if (sector.least < sector.most) {
        arcs_.push_back({sector.least, sector.towards});
        addSides(sector);
      }
    }
  }
  if (sectors_.size() > 1) {
    arcs_ = extremes_;
    addHullSegments();
  }
}

/// Where a sector is no whole circle, from its least speed to its greatest.
void WindSet::addSides(const Sector& sector) {
  const auto [from, to] = sector.towards;
  if (to - from >= kTwoPi) {
    return;
  }
  segments_.push_back({velocity(sector.least, from), velocity(sector.most, from)});
  if (from < to) {
    segments_.push_back({velocity(sector.least, to), velocity(sector.most, to)});
  }
}

/// Chords of the hull end at ends of arcs, or touch an arc on the way from a corner further out.
void WindSet::addHullSegments() {
  std::vector<Velocity> corners;
  const auto add = [&](Velocity corner) {
    const bool isKnown =
        std::any_of(corners.begin(), corners.end(), [&](const Velocity& one) { return one.east == corner.east && one.north == corner.north; });
    if (!isKnown) {
      corners.push_back(corner);
    }
  };
  for (const Sector& sector : sectors_) {
    for (const double towards : {sector.towards.from, sector.towards.to}) {
      add(velocity(sector.least, towards));
      add(velocity(sector.most, towards));
    }
  }
  const std::size_t ends = corners.size();
  for (std::size_t i = 0; i < ends; ++i) {
    const double far = std::hypot(corners[i].east, corners[i].north);
    const double direction = std::atan2(corners[i].north, corners[i].east);
    for (const Sector& sector : sectors_) {
      if (!(sector.most < far)) {
        continue;
      }
      const double apart = std::acos(sector.most / far);
      for (const double touch : {direction - apart, direction + apart}) {
        if (folded({sector.towards.from - touch, sector.towards.to - touch}).from <= kSide) {
          add(velocity(sector.most, touch));
        }
      }
    }
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t k = i + 1; k < corners.size(); ++k) {
      const Velocity a = corners[i];
      const Velocity b = corners[k];
      if (std::hypot(b.east - a.east, b.north - a.north) <= 1e-15) {
        continue;  // no chord
      }
      const double along = std::atan2(b.north - a.north, b.east - a.east);
      for (const double normal : {along - Angle::kPi / 2.0, along + Angle::kPi / 2.0}) {
        if (mostAlong({normal, normal}) <= a.east * std::cos(normal) + a.north * std::sin(normal) + kSide) {
          segments_.push_back({a, b});
          break;
        }
      }
    }
  }
}

double WindSet::mostAlong(AngleRange courses) const {
  double most = sectors_.empty() ? 0.0 : -strongest_;
  for (const Sector& sector : sectors_) {
    const double cosine = std::cos(folded({sector.towards.from - courses.to, sector.towards.to - courses.from}).from);
    most = std::max(most, cosine > 0.0 ? sector.most * cosine : sector.least * cosine);
  }
  return most;
}

}  // namespace vp::safety
