#include "core/safety/wind_glide.h"

#include "core/safety/wind_shear.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vp::safety {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What mostInTurn may be above the greatest loss, relative.
constexpr double kGap = 2e-6;

/// Halvings before the bound of a part is taken for its greatest value. The smallest part is then 1e-14 of the whole.
constexpr int kDeepest = 46;

/** The greatest value of a function on intervals: parts whose bound cannot beat what was found by more than kGap are dropped. */
class Search {
public:
  /** @param bound  bound(a, b) is an upper bound on [a, b], the value itself where a == b */
  template <typename Bound>
  void over(double from, double to, const Bound& bound) {
    best_ = std::max({best_, bound(from, from), bound(to, to)});
    split(from, to, bound, 0);
  }
  [[nodiscard]] double bound() const { return best_ * (1.0 + kGap); }

private:
  template <typename Bound>
  void split(double from, double to, const Bound& bound, int depth) {
    const double most = bound(from, to);
    if (most <= best_ * (1.0 + kGap)) {
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

}  // namespace

WindGlide::WindGlide(const aircraft::AircraftProfile& profile) : WindGlide(profile, conditionsOf(profile, {}), profile.bestGlideSpeed.si()) {}

/// The angle of attack is the same at every mass and density, so q/W is, and with it sin(gamma): WHY.md section 9.
WindGlide::WindGlide(const aircraft::AircraftProfile& profile, const PlanConditions& conditions, double airspeed)
    : WindGlide(profile, conditions, airspeed, ShearCost()) {}

WindGlide::WindGlide(const aircraft::AircraftProfile& profile, const PlanConditions& conditions, double airspeed, const ShearCost& shear)
    : airspeed_(airspeed) {
  const double speed = profile.bestGlideSpeed.si();
  const double dynamic = 0.5 * profile.airDensity_kgm3 * speed * speed * profile.wingArea_m2;  // q S [N]
  const double weight = profile.mass_kg * kGravity.si();
  const double induced = profile.inducedDrag * weight / dynamic;
  const double level = conditions.dragFactor * (dynamic * conditions.zeroLiftDrag / weight + induced);
  inducedSine_ = shear.turn * (conditions.dragFactor * induced);
  turnSine_ = shear.turn * level;
  straightSine_ = shear.straight * level;
  leastSine_ = shear.least * (dynamic * std::min(conditions.zeroLiftDrag, profile.zeroLiftDrag) / weight + induced);
}

double WindGlide::bankTangent(double along, double across) const {
  const double ahead = std::sqrt(airspeed_ * airspeed_ - across * across);  // v cos(crab)
  const double ground = ahead + along;
  return ground * ground * airspeed_ / (kGravity.si() * ahead);
}

double WindGlide::sinkSine(double along, double across, double radius) const {
  const double tangent = bankTangent(along, across) / radius;
  return turnSine_ + inducedSine_ * tangent * tangent;
}

double WindGlide::lossAt(double sine, double along, double across) const {
  const double square = airspeed_ * airspeed_ * (1.0 - sine * sine) - across * across;
  if (!(square >= 0.0)) {
    return kInfinity;
  }
  const double ground = std::sqrt(square) + along;
  return ground > 0.0 ? airspeed_ * sine / ground : kInfinity;
}

double WindGlide::mostStraight(const WindSet& winds, double course) const {
  double most = 0.0;
  for (const WindSet::Arc& arc : winds.extremes()) {
    const double off = folded({arc.towards.from - course, arc.towards.to - course}).to;
    most = std::max(most, lossAt(straightSine_, arc.speed * std::cos(off), arc.speed * std::sin(off)));
  }
  return most;
}

double WindGlide::mostInTurn(const WindSet& winds, double radius, AngleRange courses) const {
  Search search;
  const auto overArc = [&](double speed, AngleRange towards) {
    const AngleRange off = folded({towards.from - courses.to, towards.to - courses.from});
    search.over(off.from, off.to, [&](double a, double b) {
      const double sine = sinkSine(speed * std::cos(a), speed * std::sin(a), radius);
      const bool getsOn = speed * speed < airspeed_ * airspeed_ * (1.0 - sine * sine);  // on every course; else the bound is none
      return getsOn ? lossAt(sine, speed * std::cos(b), speed * std::sin(b)) : kInfinity;
    });
  };
  for (const WindSet::Arc& arc : winds.arcs()) {
    overArc(arc.speed, arc.towards);
  }
  for (const WindSet::Segment& segment : winds.segments()) {
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
        return lossAt(sinkSine(mostAlong, leastAcross, radius), leastAlong, std::max(std::abs(one), std::abs(other)));
      });
    }
    // Turning, a segment sweeps a circle with the point of it that is nearest to the middle.
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

double WindGlide::leastLoss(const WindSet& winds, AngleRange courses) const {
  return airspeed_ * leastSine_ / (airspeed_ * std::sqrt(1.0 - leastSine_ * leastSine_) + winds.mostAlong(courses));
}

double WindGlide::horizontalSpeed(double bankTangent) const {
  const double sine = std::max(straightSine_, turnSine_ + inducedSine_ * bankTangent * bankTangent);
  return sine < 1.0 ? airspeed_ * std::sqrt(1.0 - sine * sine) : 0.0;
}

}  // namespace vp::safety
