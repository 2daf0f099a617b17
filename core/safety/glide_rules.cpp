// The glide that each decision point brings as its proof.

#include "core/safety/cell_walk.h"
#include "core/safety/check_context.h"
#include "core/safety/limits.h"
#include "core/safety/rules.h"
#include "core/safety/witness_check.h"

#include <fmt/core.h>

#include <cmath>

namespace vp::safety {
namespace {

/// @return true if every turn is one that a glide of this aircraft may use
bool checkRadii(CheckContext& context, std::size_t index) {
  const double smallest = context.rates.leastGlideRadius();
  for (const flight::Piece& piece : context.track.points[index].witness.pieces) {
    if (piece.turn != flight::Turn::Straight && !(piece.radius >= smallest * (1.0 - kRadiusTolerance))) {
      context.findings.violated(
          rule::kGlideRadius,
          fmt::format("{}: its glide turns with a radius of {:.2f} m, the aircraft needs {:.2f} m", context.nameOf(index), piece.radius, smallest),
          context.at(index), piece.radius - smallest);
      return false;
    }
  }
  return true;
}

void checkArrivalPose(CheckContext& context, std::size_t index, const geo::Pose& end, const mission::SiteInFrame& site) {
  const double offset = geo::distance(end.point(), site.pose.point());
  if (!(offset <= kArrivalPlaceTolerance)) {
    context.findings.violated(rule::kGlideSite,
                              fmt::format("{}: its glide ends {:.2f} m from the touchdown point of {}", context.nameOf(index), offset, site.site.id),
                              context.atPlace(index, end.point()), -offset);
  }
  const double turned = std::abs(wrapPi(end.heading - site.pose.heading));
  if (!(turned <= kArrivalHeadingTolerance)) {
    context.findings.violated(rule::kGlideHeading,
                              fmt::format("{}: its glide arrives {:.2f} degrees off the landing course of {}", context.nameOf(index),
                                          Angle::radians(turned).degrees(), site.site.id),
                              context.atPlace(index, end.point()), -Angle::radians(turned).degrees());
  }
}

/// The last part of the glide is what the mission's approach asks for. @return nothing if it is not
std::optional<SplitGlide> checkLastPart(CheckContext& context, std::size_t index, const mission::SiteInFrame& site) {
  const mission::ApproachSettings& approach = context.plan.mission.approach;
  std::optional<SplitGlide> glide = splitAtGate(context.track.points[index].witness.pieces, approach);
  if (!glide && approach.kind == mission::ApproachKind::Straight) {
    context.findings.violated(
        rule::kApproachStraight,
        fmt::format("{}: the last {:.0f} m of its glide to {} are not straight", context.nameOf(index), approach.finalLength.si(), site.site.id),
        context.at(index));
  } else if (!glide) {
    context.findings.violated(
        rule::kApproachCircle,
        fmt::format("{}: its glide to {} does not end in one full circle from above the touchdown point", context.nameOf(index), site.site.id),
        context.at(index));
  }
  return glide;
}

/// Height at the high key, where one is asked for.
void checkKey(CheckContext& context, std::size_t index, const GlideExamination& glide, const mission::SiteInFrame& site,
              std::optional<double> asked) {
  if (!asked) {
    return;
  }
  const double key = *asked;
  const double reached = glide.atGate;
  if (!(reached >= key - kAltitudeTolerance)) {
    context.findings.violated(rule::kApproachKey,
                              fmt::format("{}: its glide is at {:.1f} m MSL at the high key of {}, {:.1f} m below the {:.1f} m required",
                                          context.nameOf(index), reached, site.site.id, key - reached, key),
                              context.at(index), reached - key);
  }
}

/// The glide stays above the ground in spite of what rolling may cost, where costs are given. @return whether it does
bool checkRolling(CheckContext& context, std::size_t index, const GlideExamination& glide, const GlideQuery& query,
                  const mission::SiteInFrame& site) {
  if (query.rollCosts.empty()) {
    return true;
  }
  context.margins.note(MarginKind::GlideDynamics, glide.afterRolling, glide.afterRollingAt);
  context.mostRolling = std::max(context.mostRolling, query.rollCosts.back());
  const bool isLeft = glide.afterRolling >= -kAltitudeTolerance;
  if (!isLeft && glide.clearanceLeft >= -kAltitudeTolerance) {  // else the clearance is missing, which says more
    context.findings.violated(
        rule::kGlideDynamics,
        fmt::format("{}: on its glide from {:.1f} m MSL to {} rolling into turns and out of them may cost {:.1f} m up to a place where it is "
                    "{:.1f} m above the ground: fly {:.1f} m higher, or glide with fewer turns",
                    context.nameOf(index), *query.altitude, site.site.id, glide.rollCostThere, glide.rollCostThere + glide.afterRolling,
                    -glide.afterRolling),
        context.atPlace(index, glide.afterRollingAt), glide.afterRolling);
  }
  return isLeft;
}

/// Heights of the glide flown from the tour's altitude, and the plan's claim about them.
void checkHeights(CheckContext& context, std::size_t index, const GlideExamination& glide, const GlideQuery& query,
                  const mission::SiteInFrame& site) {
  const mission::DecisionPoint& point = context.track.points[index];
  const double started = *query.altitude;
  const double arrival = glide.arrival - query.arrival;
  const double clearance = glide.clearanceLeft;
  checkKey(context, index, glide, site, query.key);
  const double required = glide.requiredStart() + context.reactionLoss;
  context.track.required[index] = required;
  context.margins.note(MarginKind::GlideArrival, arrival, point.pose.point());
  context.margins.note(MarginKind::GlideClearance, clearance, glide.clearanceAt);
  context.margins.note(MarginKind::TourGlide, point.altitude - required, point.pose.point());
  bool isHighEnough = started >= glide.keyStart - kAltitudeTolerance;
  if (!(arrival >= -kAltitudeTolerance)) {
    isHighEnough = false;
    context.findings.violated(rule::kGlideArrival,
                              fmt::format("{}: the glide from {:.1f} m MSL loses {:.1f} m and arrives at {} at {:.1f} m, {:.1f} m below the {:.1f} m "
                                          "required (runway at {:.1f} m)",
                                          context.nameOf(index), started, started - glide.arrival, site.site.id, glide.arrival, -arrival,
                                          query.arrival, site.site.elevation.metres()),
                              context.at(index), arrival);
  }
  if (!(clearance >= -kAltitudeTolerance)) {
    isHighEnough = false;
    context.findings.violated(rule::kGlideClearance,
                              fmt::format("{}: the glide from {:.1f} m MSL to {} is at {:.1f} m over ground of {:.1f} m, {:.1f} m too low for the "
                                          "clearance of {:.0f} m",
                                          context.nameOf(index), started, site.site.id, glide.clearanceGround + glide.clearanceAsked + clearance,
                                          glide.clearanceGround, -clearance, glide.clearanceAsked),
                              context.atPlace(index, glide.clearanceAt), clearance);
  }
  isHighEnough = checkRolling(context, index, glide, query, site) && isHighEnough;
  context.track.tooLow[index] = !isHighEnough;
  if (!(point.safeAltitude >= required - kClaimTolerance)) {
    if (isHighEnough) {
      context.findings.violated(rule::kGlideSafeAltitude,
                                fmt::format("{}: the plan gives {:.1f} m MSL as safe altitude, but its glide needs {:.1f} m", context.nameOf(index),
                                            point.safeAltitude, required),
                                context.at(index), point.safeAltitude - required);
    }
  } else if (isHighEnough && !(point.altitude >= point.safeAltitude - kAltitudeTolerance)) {
    context.findings.violated(rule::kTourSafeAltitude,
                              fmt::format("{}: the tour is at {:.1f} m MSL, below the safe altitude of {:.1f} m that the plan gives",
                                          context.nameOf(index), point.altitude, point.safeAltitude),
                              context.at(index), point.altitude - point.safeAltitude);
  }
}

/// What rolling may cost along the glide of a point, begun in the bank that the tour comes to the point in.
std::vector<double> rollCostsOf(const CheckContext& context, std::size_t index) {
  if (!context.rollCost) {
    return {};
  }
  const Track& track = context.track;
  const std::size_t count = track.points.size();
  std::optional<flight::Piece> tour;
  if (index > 0 || track.isClosed) {
    tour = track.points[index > 0 ? index - 1 : count - 1].onward;
  }
  return context.rollCost->along(tour, track.points[index].witness.pieces);
}

void checkGlide(CheckContext& context, std::size_t index, CellWalk& walk, const Job& job) {
  const mission::DecisionPoint& point = context.track.points[index];
  const auto siteIndex = static_cast<std::size_t>(point.witness.site);
  if (point.witness.site < 0 || siteIndex >= context.plan.sites.size() || !checkRadii(context, index) || !checkReaction(context, index)) {
    return;  // found before, or just now: nothing to fly
  }
  context.siteUsed[siteIndex] = true;
  const mission::SiteInFrame& site = context.plan.sites[siteIndex];
  const std::optional<SplitGlide> pieces = checkLastPart(context, index, site);
  if (!pieces) {
    return;
  }
  GlideQuery query = queryOf(point.pose, point.altitude - context.reactionLoss, site.site, context.plan.mission);
  query.rollCosts = rollCostsOf(context, index);
  const GlideExamination glide = examineGlide(query, *pieces, context.rates, walk, job);
  if (job.stopRequested()) {
    return;
  }
  checkArrivalPose(context, index, glide.end, site);
  if (glide.unknownAt) {
    context.findings.unknown(rule::kTerrainUnknown,
                             fmt::format("{}: its glide to {} crosses ground of unknown height", context.nameOf(index), site.site.id),
                             context.atPlace(index, *glide.unknownAt));
    return;
  }
  context.gateLowest[siteIndex] = std::max(context.gateLowest[siteIndex], glide.gateLowest);
  checkHeights(context, index, glide, query, site);
}

}  // namespace

void checkGlides(CheckContext& context, const Job& job) {
  const std::size_t count = context.track.points.size();
  context.track.required.assign(count, kNoHeight);
  context.track.tooLow.assign(count, false);
  context.siteUsed.assign(context.plan.sites.size(), false);
  context.gateLowest.resize(context.plan.sites.size(), -kNoHeight);
  if (context.plan.mission.aircraft.rollRate_dps && !context.rollCost) {
    context.rollCost.emplace(conditionsOf(context.plan), context.plan.mission.aircraft, context.rates);
  }
  CellWalk walk(context.terrain);
  for (std::size_t i = 0; i < count && !job.stopRequested(); ++i) {
    if (i % 64 == 0) {
      job.progress(static_cast<double>(i) / static_cast<double>(count), fmt::format("{} glide {} of {}", context.track.name, i, count));
    }
    checkGlide(context, i, walk, job);
  }
}

}  // namespace vp::safety
