#include "core/safety/wind_glide.h"

#include "core/safety/wind_chord.h"
#include "core/safety/wind_shear.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::safety {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What mostInTurn is above the greatest loss that it finds, relative: more than rounding, and than what a chord may hide (kHidden).
constexpr double kGap = 2e-6;

/// A part of a chord whose bound is this little above the greatest loss found is not looked at further.
constexpr double kHidden = 1e-10;

/// Halvings before the bound of a part is taken for its greatest value. The smallest part is then 1e-14 of the whole.
constexpr int kDeepest = 46;

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

bool WindGlide::getsOn(double strongest, double radius) const {
  const double sine = sinkSine(strongest, 0.0, radius);
  return strongest * strongest < airspeed_ * airspeed_ * (1.0 - sine * sine);
}

double WindGlide::mostStraight(const WindSet& winds, double course) const {
  double most = 0.0;
  for (const WindSet::Arc& arc : winds.extremes()) {
    const double off = folded({arc.towards.from - course, arc.towards.to - course}).to;
    most = std::max(most, lossAt(straightSine_, arc.speed * std::cos(off), arc.speed * std::sin(off)));
  }
  return most;
}

/// On winds of one speed the loss is greatest at an end of their directions off the tail; where the bank there leaves no glide, no bound is left.
double WindGlide::mostOnArc(double speed, AngleRange off, double radius) const {
  const double along = speed * std::cos(off.from);
  const double across = speed * std::sin(off.from);
  const double sine = sinkSine(along, across, radius);
  if (!(speed * speed < airspeed_ * airspeed_ * (1.0 - sine * sine))) {
    return kInfinity;
  }
  return std::max(lossAt(sine, along, across), lossInTurn(speed * std::cos(off.to), speed * std::sin(off.to), radius));
}

double WindGlide::mostInTurn(const WindSet& winds, double radius, AngleRange courses) const {
  double most = 0.0;
  const auto overArc = [&](double speed, AngleRange towards) {
    most = std::max(most, mostOnArc(speed, folded({towards.from - courses.to, towards.to - courses.from}), radius));
  };
  for (const WindSet::Arc& arc : winds.arcs()) {
    overArc(arc.speed, arc.towards);
  }
  // Turning, a segment sweeps a circle with the point of it that is nearest to the middle.
  for (const WindSet::Segment& segment : winds.segments()) {
    const double east = segment.b.east - segment.a.east;
    const double north = segment.b.north - segment.a.north;
    const double square = east * east + north * north;
    const double nearest = square > 0.0 ? -(segment.a.east * east + segment.a.north * north) / square : 0.0;
    if (nearest > 0.0 && nearest < 1.0) {
      const double x = segment.a.east + nearest * east;
      const double y = segment.a.north + nearest * north;
      const double direction = std::atan2(y, x);
      overArc(std::hypot(x, y), {direction, direction});
    }
  }
  for (const double course : {courses.from, courses.to}) {
    const double cosine = std::cos(course);
    const double sine = std::sin(course);
    for (const WindSet::Segment& segment : winds.segments()) {
      const double east = segment.b.east - segment.a.east;
      const double north = segment.b.north - segment.a.north;
      const Chord chord{segment.a.east * cosine + segment.a.north * sine, segment.a.north * cosine - segment.a.east * sine,
                        east * cosine + north * sine, north * cosine - east * sine};
      most = std::max(most, lossInTurn(chord.along, chord.across, radius));
      most = std::max(most, lossInTurn(chord.along + chord.alongBy, chord.across + chord.acrossBy, radius));
      most = mostOnChord(chord, radius, {0.0, 1.0}, most, 0);
    }
  }
  return most * (1.0 + kGap);
}

/// Parts are left out where their bound is no more than what was found, or where the loss only rises or only falls: its ends were looked at.
double WindGlide::mostOnChord(const Chord& chord, double radius, ChordPart part, double found, int depth) const {
  const Between alongs = Between::of(chord.along + part.from * chord.alongBy, chord.along + part.to * chord.alongBy);
  const Between across = Between::of(chord.across + part.from * chord.acrossBy, chord.across + part.to * chord.acrossBy);
  const double nearest = across.least <= 0.0 && across.most >= 0.0 ? 0.0 : std::min(std::abs(across.least), std::abs(across.most));
  const double farthest = std::max(std::abs(across.least), std::abs(across.most));
  const double mostSine = sinkSine(alongs.most, nearest, radius);
  const double bound = lossAt(mostSine, alongs.least, farthest);
  if (bound <= found * (1.0 + kHidden)) {
    return found;
  }
  const double middle = 0.5 * (part.from + part.to);
  if (depth == kDeepest || !(part.from < middle && middle < part.to)) {
    return bound;
  }
  if (bound < kInfinity) {
    const Between sines{sinkSine(alongs.least, farthest, radius), mostSine};
    const double square = airspeed_ * airspeed_;
    const Between ahead{std::sqrt(square - farthest * farthest), std::sqrt(square - nearest * nearest)};
    const Between glided{std::sqrt(square * (1.0 - sines.most * sines.most) - farthest * farthest),
                         std::sqrt(square * (1.0 - sines.least * sines.least) - nearest * nearest)};
    if (isOneWay(chord, {alongs, across, ahead, glided, {1.0 - turnSine_ / sines.least, 1.0 - turnSine_ / sines.most}}, square)) {
      return found;
    }
  }
  found = std::max(found, lossInTurn(chord.along + middle * chord.alongBy, chord.across + middle * chord.acrossBy, radius));
  found = mostOnChord(chord, radius, {part.from, middle}, found, depth + 1);
  return mostOnChord(chord, radius, {middle, part.to}, found, depth + 1);
}

double WindGlide::leastLoss(const WindSet& winds, AngleRange courses) const {
  return airspeed_ * leastSine_ / (airspeed_ * std::sqrt(1.0 - leastSine_ * leastSine_) + winds.mostAlong(courses));
}

double WindGlide::horizontalSpeed(double bankTangent) const {
  const double sine = std::max(straightSine_, turnSine_ + inducedSine_ * bankTangent * bankTangent);
  return sine < 1.0 ? airspeed_ * std::sqrt(1.0 - sine * sine) : 0.0;
}

}  // namespace vp::safety
