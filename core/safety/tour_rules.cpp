// The tour itself, interval by interval, and what happens when the engine fails between two decision points.

#include "core/safety/cell_walk.h"
#include "core/safety/check_context.h"
#include "core/safety/climb_left.h"
#include "core/safety/failures.h"
#include "core/safety/ground_path.h"
#include "core/safety/limits.h"
#include "core/safety/rules.h"

#include <fmt/core.h>

#include <cmath>

namespace vp::safety {
namespace {

constexpr int kSpansPerPoll = 4096;  // about 0.5 ms

/** From decision point `from` along `piece` to decision point `to`; altitude is linear in distance. */
struct Interval {
  std::size_t from = 0;
  std::size_t to = 0;
  const mission::DecisionPoint& start;
  const mission::DecisionPoint& end;
  double length = 0.0;
  Descent descent;     // heights when gliding along it
  double share = 1.0;  // of a slope in the air that is left over ground
  Angle climb;         // steepest in the air, at its upper end

  /// Tour altitude at a distance. Exact at both ends.
  [[nodiscard]] double altitudeAt(double distance) const {
    if (distance >= length) {
      return end.altitude;
    }
    return start.altitude + (end.altitude - start.altitude) * (distance / length);
  }
  [[nodiscard]] Failures failures(double reactionLoss) { return {start.altitude, end.altitude, length, descent, reactionLoss}; }
};

/** A pitch limit over a closed loop: the rise (or fall) of no stretch may exceed what its intervals' slopes allow on their lengths by more than the
 *  altitude tolerance, so the tolerance cannot be used again on every short interval (WHY.md section 6). */
class PitchLimit {
public:
  /** @return how far the worst stretch that ends here exceeds the limit [m], if it does */
  std::optional<double> add(double rise, double slope, double length) {
    excess_ = std::max(0.0, excess_) + rise - slope * length;
    if (excess_ <= kAltitudeTolerance) {
      return {};
    }
    const double found = excess_;
    excess_ = 0.0;
    return found;
  }

private:
  double excess_ = 0.0;
};

struct PitchLimits {
  PitchLimit climb;
  PitchLimit descent;
};

/// @return true if the interval is a turn or straight that the aircraft can fly on the tour
bool checkRadius(CheckContext& context, const Interval& interval) {
  const flight::Piece& piece = interval.start.onward;
  const double smallest = context.rates.leastTourRadius();
  if (piece.turn == flight::Turn::Straight || piece.radius >= smallest * (1.0 - kRadiusTolerance)) {
    return isIntegrable(piece);
  }
  context.findings.violated(rule::kTourRadius,
                            fmt::format("{}: the tour turns with a radius of {:.2f} m, the aircraft needs {:.2f} m at its tour bank",
                                        context.nameOf(interval.from), piece.radius, smallest),
                            context.at(interval.from), piece.radius - smallest);
  return false;
}

/// An engine failure in a turn of the tour is followed by a glide along the rest of it, so a glide must be able to fly it.
void checkGlideAlong(CheckContext& context, const Interval& interval) {
  const flight::Piece& piece = interval.start.onward;
  const double smallest = context.rates.leastGlideRadius();
  if (piece.turn != flight::Turn::Straight && !(piece.radius >= smallest * (1.0 - kRadiusTolerance))) {
    context.findings.violated(rule::kBetweenRadius,
                              fmt::format("{}: the tour turns with a radius of {:.2f} m, but a glide of this aircraft needs {:.2f} m, so it could "
                                          "not follow the turn after an engine failure in it",
                                          context.nameOf(interval.from), piece.radius, smallest),
                              context.at(interval.from), piece.radius - smallest);
  }
}

void checkContinuity(CheckContext& context, const Interval& interval) {
  const double step = context.plan.mission.planner.step.si();
  if (!(interval.length <= step + kSpacingTolerance)) {
    context.findings.violated(
        rule::kTourSpacing,
        fmt::format("{}: the next decision point is {:.3f} m on, the mission allows {:.3f} m", context.nameOf(interval.from), interval.length, step),
        context.at(interval.from), step - interval.length);
  }
  const geo::Pose end = endOfPiece(interval.start.pose, interval.start.onward);
  const double gap = geo::distance(end.point(), interval.end.pose.point());
  const double turned = std::abs(wrapPi(end.heading - interval.end.pose.heading));
  if (!(gap <= kGapTolerance) || !(turned <= kGapHeadingTolerance)) {
    context.findings.violated(rule::kTourGap,
                              fmt::format("{}: the way on ends {:.3f} m and {:.5f} degrees from {}", context.nameOf(interval.from), gap,
                                          Angle::radians(turned).degrees(), context.nameOf(interval.to)),
                              context.at(interval.from), -gap);
  }
}

void checkPitch(CheckContext& context, const Interval& interval, PitchLimits& limits) {
  const aircraft::AircraftProfile& profile = context.plan.mission.aircraft;
  const double rise = interval.end.altitude - interval.start.altitude;
  const double through = interval.share * interval.length;  // the air, with the wind from behind
  const double pitch = Angle::radians(std::atan2(rise, through)).degrees();
  const std::optional<double> tooMuchClimb = limits.climb.add(rise, tan(interval.climb), through);
  const std::optional<double> tooMuchDescent = limits.descent.add(-rise, tan(profile.maxDescent), through);
  const geo::Point where = interval.start.pose.point();
  const double climbLeft = interval.climb.degrees() - pitch;
  const double descentLeft = profile.maxDescent.degrees() + pitch;
  // Within the tolerance in height a very short piece may still be steep: nothing is left then, but nothing is missing.
  context.margins.note(MarginKind::TourClimb, tooMuchClimb ? climbLeft : std::max(0.0, climbLeft), where);
  context.margins.note(MarginKind::TourDescent, tooMuchDescent ? descentLeft : std::max(0.0, descentLeft), where);
  if (tooMuchClimb) {
    context.findings.violated(rule::kTourClimb,
                              fmt::format("{}: the tour climbs at {:.2f} degrees to {}, the aircraft can climb at {:.2f}",
                                          context.nameOf(interval.from), pitch, context.nameOf(interval.to), interval.climb.degrees()),
                              context.at(interval.from), std::min(0.0, climbLeft));
  }
  if (tooMuchDescent) {
    context.findings.violated(rule::kTourDescent,
                              fmt::format("{}: the tour descends at {:.2f} degrees to {}, the aircraft may descend at {:.2f}",
                                          context.nameOf(interval.from), -pitch, context.nameOf(interval.to), profile.maxDescent.degrees()),
                              context.at(interval.from), std::min(0.0, descentLeft));
  }
}

void checkCeiling(CheckContext& context, std::size_t index) {
  const mission::Mission& mission = context.plan.mission;
  std::optional<geo::HeightMsl> ceiling = mission.ceiling;
  if (mission.aircraft.ceiling && (!ceiling || *mission.aircraft.ceiling < *ceiling)) {
    ceiling = mission.aircraft.ceiling;
  }
  if (!ceiling) {
    return;
  }
  const mission::DecisionPoint& point = context.track.points[index];
  const double below = ceiling->metres() - point.altitude;
  context.margins.note(MarginKind::TourCeiling, below, point.pose.point());
  if (!(below >= -kAltitudeTolerance)) {
    context.findings.violated(
        rule::kTourCeiling,
        fmt::format("{}: {:.1f} m MSL is above the ceiling of {:.1f} m", context.nameOf(index), point.altitude, ceiling->metres()), context.at(index),
        below);
  }
}

/** Least margin found on an interval, and over what. */
struct Worst {
  double margin = std::numeric_limits<double>::infinity();
  double at = 0.0;
  double ground = 0.0;

  void note(double value, double distance, double groundThere) {
    if (!(value >= margin)) {
      margin = value;
      at = distance;
      ground = groundThere;
    }
  }
};

/// Engine failure anywhere on the interval, then the glide of the next point: WHY.md section 4, condition (a). Where one of the
/// two decision points is too low for its own glide, that has been found there already and is not said again.
void checkHeightAtNextPoint(CheckContext& context, Interval& interval) {
  const double required = context.track.required[interval.to];
  if (!(required < kNoHeight)) {
    return;  // the next point has no usable glide, which has been found there
  }
  const double reached = interval.failures(context.reactionLoss).lowestAt(interval.length);
  const double margin = reached - required;
  context.margins.note(MarginKind::TourGlide, margin, interval.start.pose.point());
  const bool foundAtAPoint = context.track.tooLow[interval.from] || context.track.tooLow[interval.to];
  if (!(margin >= -kAltitudeTolerance) && !foundAtAPoint) {
    context.findings.violated(rule::kBetweenHeight,
                              fmt::format("{}: after an engine failure behind it the aircraft reaches {} at {:.1f} m MSL, {:.1f} m "
                                          "below the {:.1f} m that the glide from there needs",
                                          context.nameOf(interval.from), context.nameOf(interval.to), reached - context.reactionLoss, -margin,
                                          required - context.reactionLoss),
                              context.at(interval.from), margin);
  }
}

void reportGround(CheckContext& context, const Interval& interval, const Worst& powered, const Worst& gliding) {
  const geo::Pose start = interval.start.pose;
  if (powered.margin < -kAltitudeTolerance) {
    context.findings.violated(
        rule::kTourClearance,
        fmt::format("{}: {:.1f} m after it the tour is at {:.1f} m MSL over ground of {:.1f} m, {:.1f} m too low for the clearance of "
                    "{:.0f} m",
                    context.nameOf(interval.from), powered.at, powered.ground + context.clearance + powered.margin, powered.ground, -powered.margin,
                    context.clearance),
        context.atPlace(interval.from, poseOn(start, interval.start.onward, powered.at).point()), powered.margin);
  }
  if (gliding.margin < -kAltitudeTolerance) {
    context.findings.violated(
        rule::kBetweenClearance,
        fmt::format("{}: a glide along the tour from here is at {:.1f} m MSL over ground of {:.1f} m, {:.1f} m on, {:.1f} m too low "
                    "for the clearance of {:.0f} m",
                    context.nameOf(interval.from), gliding.ground + context.clearance + gliding.margin, gliding.ground, gliding.at, -gliding.margin,
                    context.clearance),
        context.atPlace(interval.from, poseOn(start, interval.start.onward, gliding.at).point()), gliding.margin);
  }
}

/// Clearance of the tour with the engine running, and of every glide along it to the next point: WHY.md section 4, (b).
void checkGround(CheckContext& context, Interval& interval, CellWalk& walk, const Job& job) {
  Worst powered;
  Worst gliding;
  const geo::Pose start = interval.start.pose;
  walk.start(start, interval.start.onward);
  Failures failures = interval.failures(context.reactionLoss);
  Span span;
  for (int count = 0; walk.next(span); ++count) {
    if (count % kSpansPerPoll == kSpansPerPoll - 1 && job.stopRequested()) {
      return;
    }
    if (!span.isKnown()) {
      const geo::Point where = poseOn(start, interval.start.onward, span.from).point();
      context.findings.unknown(
          rule::kTerrainUnknown,
          fmt::format("{}: {:.1f} m after it the tour crosses ground of unknown height", context.nameOf(interval.from), span.from),
          context.atPlace(interval.from, where));
      return;
    }
    const double floor = span.ground + context.clearance;
    const double atFrom = interval.altitudeAt(span.from);
    const double atTo = interval.altitudeAt(span.to);
    const double flown = std::min(atFrom, atTo) - floor;
    powered.note(flown, atFrom <= atTo ? span.from : span.to, span.ground);
    double glided = failures.lowestAt(span.to) - floor;
    if (context.reactionLoss > 0.0) {  // lost at once, so a failure over this very ground counts too
      glided = std::min(glided, flown) - context.reactionLoss;
    }
    context.margins.note(MarginKind::TourGlide, glided, start.point());
    if (flown >= -kAltitudeTolerance) {  // else the same ground is already in the way of the tour
      gliding.note(glided, span.to, span.ground);
    }
  }
  if (powered.margin < context.closest.margin) {
    context.closest = {powered.margin, powered.ground + context.clearance + powered.margin};
  }
  context.margins.note(MarginKind::TourClearance, powered.margin, poseOn(start, interval.start.onward, powered.at).point());
  reportGround(context, interval, powered, gliding);
}

Interval intervalFrom(CheckContext& context, std::size_t index) {
  const std::size_t next = context.next(index);
  const mission::DecisionPoint& start = context.track.points[index];
  const flight::Piece& piece = start.onward;
  const mission::DecisionPoint& end = context.track.points[next];
  const double course = start.pose.heading;
  return {index,
          next,
          start,
          end,
          piece.length,
          Descent(context.rates, course, piece),
          context.rates.slopeShare(course, piece),
          steepestClimb(context.plan.mission, std::max(start.altitude, end.altitude))};
}

}  // namespace

void checkTour(CheckContext& context, const Job& job) {
  const Track& track = context.track;
  const std::size_t count = track.isClosed ? track.points.size() : track.points.size() - 1;
  PitchLimits limits;
  for (std::size_t i = 0; track.isClosed && i < count; ++i) {  // a first round, so that a stretch over the closing point counts too
    const Interval interval = intervalFrom(context, i);
    const double rise = interval.end.altitude - interval.start.altitude;
    const double through = interval.share * interval.length;
    limits.climb.add(rise, tan(interval.climb), through);
    limits.descent.add(-rise, tan(context.plan.mission.aircraft.maxDescent), through);
  }
  CellWalk walk(context.terrain);
  for (std::size_t i = 0; i < count && !job.stopRequested(); ++i) {
    if (i % 64 == 0) {
      job.progress(static_cast<double>(i) / static_cast<double>(count), fmt::format("{} point {} of {}", track.name, i, count));
    }
    Interval interval = intervalFrom(context, i);
    checkCeiling(context, i);
    checkPitch(context, interval, limits);
    if (checkRadius(context, interval)) {
      checkGlideAlong(context, interval);
      checkContinuity(context, interval);
      checkHeightAtNextPoint(context, interval);
      checkGround(context, interval, walk, job);
    }
  }
}

void checkPoweredTrack(CheckContext& context) {
  PitchLimits limits;
  for (std::size_t i = 0; i + 1 < context.track.points.size(); ++i) {
    const Interval interval = intervalFrom(context, i);
    checkCeiling(context, i);
    checkPitch(context, interval, limits);
    if (checkRadius(context, interval)) {
      checkContinuity(context, interval);
    }
  }
}

}  // namespace vp::safety
