#pragma once

// The greatest loss in a turn as it was found before the ends of arcs were known to be enough: by halving every arc and every chord of a set of winds
// until no part can hold more, by 2e-6, than what was found. Asks nothing about how the loss runs along them but that more bank, less wind from
// behind and more from the side cost more.

#include "core/safety/wind_glide.h"
#include "core/safety/wind_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::test {

inline constexpr double kSearchGap = 2e-6;

class LossSearch {
public:
  template <typename Bound>
  void over(double from, double to, const Bound& bound) {
    best_ = std::max({best_, bound(from, from), bound(to, to)});
    split(from, to, bound, 0);
  }
  [[nodiscard]] double bound() const { return best_ * (1.0 + kSearchGap); }

private:
  template <typename Bound>
  void split(double from, double to, const Bound& bound, int depth) {
    constexpr int kDeepest = 46;
    const double most = bound(from, to);
    if (most <= best_ * (1.0 + kSearchGap)) {
      return;
    }
    const double middle = 0.5 * (from + to);
    if (depth == kDeepest || !(from < middle && middle < to)) {
      best_ = std::max(best_, most);
      return;
    }
    best_ = std::max(best_, bound(middle, middle));
    split(from, middle, bound, depth + 1);
    split(middle, to, bound, depth + 1);
  }

  double best_ = 0.0;
};

inline double searchedInTurn(const safety::WindGlide& glide, double airspeed, const safety::WindSet& winds, double radius,
                             safety::AngleRange courses) {
  LossSearch search;
  const auto overArc = [&](double speed, safety::AngleRange towards) {
    const safety::AngleRange off = safety::folded({towards.from - courses.to, towards.to - courses.from});
    search.over(off.from, off.to, [&](double a, double b) {
      const double sine = glide.sinkSine(speed * std::cos(a), speed * std::sin(a), radius);
      const bool getsOn = speed * speed < airspeed * airspeed * (1.0 - sine * sine);
      return getsOn ? glide.lossAt(sine, speed * std::cos(b), speed * std::sin(b)) : std::numeric_limits<double>::infinity();
    });
  };
  for (const safety::WindSet::Arc& arc : winds.arcs()) {
    overArc(arc.speed, arc.towards);
  }
  for (const safety::WindSet::Segment& segment : winds.segments()) {
    const double east = segment.b.east - segment.a.east;
    const double north = segment.b.north - segment.a.north;
    for (const double course : {courses.from, courses.to}) {
      const double along = segment.a.east * std::cos(course) + segment.a.north * std::sin(course);
      const double across = segment.a.north * std::cos(course) - segment.a.east * std::sin(course);
      const double alongBy = east * std::cos(course) + north * std::sin(course);
      const double acrossBy = north * std::cos(course) - east * std::sin(course);
      search.over(0.0, 1.0, [&](double a, double b) {
        const auto [leastAlong, mostAlong] = std::minmax({along + a * alongBy, along + b * alongBy});
        const double one = across + a * acrossBy;
        const double other = across + b * acrossBy;
        const double leastAcross = one * other <= 0.0 ? 0.0 : std::min(std::abs(one), std::abs(other));
        return glide.lossAt(glide.sinkSine(mostAlong, leastAcross, radius), leastAlong, std::max(std::abs(one), std::abs(other)));
      });
    }
    const double square = east * east + north * north;
    const double nearest = square > 0.0 ? -(segment.a.east * east + segment.a.north * north) / square : 0.0;
    if (nearest > 0.0 && nearest < 1.0) {
      const double x = segment.a.east + nearest * east;
      const double y = segment.a.north + nearest * north;
      const double direction = std::atan2(y, x);
      overArc(std::hypot(x, y), {direction, direction});
    }
  }
  return search.bound();
}

}  // namespace vp::test
