// Whether the tour visits what it should: targets, spirals, and the numbers a pilot reads about it.

#include "core/safety/cell_walk.h"
#include "core/safety/check_context.h"
#include "core/safety/climb_left.h"
#include "core/safety/ground_path.h"
#include "core/safety/limits.h"
#include "core/safety/rules.h"

#include <fmt/core.h>

#include <cmath>

namespace vp::safety {
namespace {

bool isTarget(const mission::Plan& plan, int target) {
  return target >= 0 && static_cast<std::size_t>(target) < plan.targets.size();
}

void checkVisit(CheckContext& context, std::size_t index, const mission::TargetInFrame& target) {
  const mission::DecisionPoint& point = context.plan.tour[index];
  const double offset = geo::distance(point.pose.point(), target.point);
  if (!(offset <= kVisitTolerance)) {
    context.findings.violated(
        rule::kTargetMissed, fmt::format("tour point {}: it should visit target {} but passes {:.2f} m beside it", index, target.target.name, offset),
        context.at(index), -offset);
    return;
  }
  const double above = point.altitude - target.altitude;
  context.margins.note(MarginKind::TargetHeight, above, target.point);
  if (!(above >= -kClaimTolerance)) {
    context.findings.violated(rule::kTargetLow,
                              fmt::format("tour point {}: it passes target {} at {:.1f} m MSL, below its {:.1f} m", index, target.target.name,
                                          point.altitude, target.altitude),
                              context.at(index), above);
  }
}

/** One spiral and the decision point that it starts and ends at. */
struct PlacedSpiral {
  const mission::SpiralVisit& spiral;
  const mission::TargetInFrame& target;
  const mission::DecisionPoint& point;
  std::size_t index = 0;
};

/// @return true if the spiral is one that can be flown on
bool checkSpiralShape(CheckContext& context, const PlacedSpiral& placed) {
  const mission::SpiralVisit& spiral = placed.spiral;
  const FindingPlace place = context.at(placed.index);
  const bool turns = spiral.turn == flight::Turn::Left || spiral.turn == flight::Turn::Right;
  const bool heights = std::abs(spiral.top - placed.point.altitude) <= kClaimTolerance && spiral.bottom >= placed.target.altitude - kClaimTolerance &&
                       spiral.top >= spiral.bottom;
  if (!turns || !heights || spiral.turnsDown < 1 || spiral.turnsUp < 1) {
    context.findings.violated(
        rule::kSpiralData,
        fmt::format("the spiral at target {} goes from {:.1f} m to {:.1f} m MSL in {} + {} circles; it must lead from the tour ({:.1f} m) "
                    "down, not below the target ({:.1f} m), and back in whole circles to one side",
                    placed.target.target.name, spiral.top, spiral.bottom, spiral.turnsDown, spiral.turnsUp, placed.point.altitude,
                    placed.target.altitude),
        place);
    return false;
  }
  const double smallest = context.rates.leastTourRadius();
  if (!(spiral.radius >= smallest * (1.0 - kRadiusTolerance))) {
    context.findings.violated(rule::kSpiralRadius,
                              fmt::format("the spiral at target {} turns with a radius of {:.2f} m, the aircraft needs {:.2f} m",
                                          placed.target.target.name, spiral.radius, smallest),
                              place, spiral.radius - smallest);
    return false;
  }
  return true;
}

void checkSpiralPitch(CheckContext& context, const PlacedSpiral& placed) {
  const mission::SpiralVisit& spiral = placed.spiral;
  const aircraft::AircraftProfile& profile = context.plan.mission.aircraft;
  const double circle = 2.0 * Angle::kPi * spiral.radius;
  const double height = spiral.top - spiral.bottom;
  const double share = context.rates.slopeShare(placed.point.pose.heading, {spiral.turn, spiral.radius, circle});
  const double down = share * tan(profile.maxDescent) * spiral.turnsDown * circle - height;
  const double up = share * tan(steepestClimb(context.plan.mission, spiral.top)) * spiral.turnsUp * circle - height;
  if (!(std::min(down, up) >= -kAltitudeTolerance)) {
    context.findings.violated(
        rule::kSpiralPitch,
        fmt::format("the spiral at target {} changes height by {:.1f} m in {} circles down and {} up, which is steeper than the aircraft "
                    "may fly",
                    placed.target.target.name, height, spiral.turnsDown, spiral.turnsUp),
        context.at(placed.index), std::min(down, up));
  }
}

/// Lowest over each place of the circle is the last circle on the way down or the first on the way up: WHY.md section 5.
void checkSpiralGround(CheckContext& context, const PlacedSpiral& placed) {
  const mission::SpiralVisit& spiral = placed.spiral;
  const double circle = 2.0 * Angle::kPi * spiral.radius;
  const double down = (spiral.top - spiral.bottom) / (circle * spiral.turnsDown);
  const double up = (spiral.top - spiral.bottom) / (circle * spiral.turnsUp);
  CellWalk walk(context.terrain);
  walk.start(placed.point.pose, {spiral.turn, spiral.radius, circle});
  double worst = std::numeric_limits<double>::infinity();
  double ground = 0.0;
  Span span;
  while (walk.next(span)) {
    if (!span.isKnown()) {
      context.findings.unknown(rule::kTerrainUnknown,
                               fmt::format("the spiral at target {} crosses ground of unknown height", placed.target.target.name),
                               context.at(placed.index));
      return;
    }
    const double lowest = spiral.bottom + std::min(down * std::max(0.0, circle - span.to), up * span.from);
    const double margin = lowest - span.ground - context.clearance;
    if (margin < worst) {
      worst = margin;
      ground = span.ground;
    }
  }
  context.margins.note(MarginKind::SpiralClearance, worst, placed.point.pose.point());
  if (!(worst >= -kAltitudeTolerance)) {
    context.findings.violated(rule::kSpiralClearance,
                              fmt::format("the spiral at target {} is {:.1f} m too low over ground of {:.1f} m for the clearance of {:.0f} m",
                                          placed.target.target.name, -worst, ground, context.clearance),
                              context.at(placed.index), worst);
  }
}

void checkSpiral(CheckContext& context, const mission::SpiralVisit& spiral, const std::vector<int>& pointOfTarget) {
  const mission::Plan& plan = context.plan;
  const auto target = static_cast<std::size_t>(spiral.target);
  if (plan.mission.planner.lowTargets != mission::LowTargets::Descend) {
    context.findings.violated(
        rule::kSpiralNotAllowed,
        fmt::format("the plan descends to target {}, but the mission asks to pass above low targets", plan.targets[target].target.name),
        {-1, plan.targets[target].point});
    return;
  }
  if (pointOfTarget[target] < 0) {
    return;  // found as target.skipped
  }
  const auto index = static_cast<std::size_t>(pointOfTarget[target]);
  const PlacedSpiral placed{spiral, plan.targets[target], plan.tour[index], index};
  if (checkSpiralShape(context, placed)) {
    checkSpiralPitch(context, placed);
    checkSpiralGround(context, placed);
  }
  context.findings.warning(
      rule::kSpiralSuspended,
      fmt::format("between {:.0f} and {:.0f} m MSL at target {} the tour leaves the safe altitude in a spiral of {} circles: there the gliding "
                  "guarantee is suspended",
                  spiral.bottom, spiral.top, placed.target.target.name, spiral.turnsDown + spiral.turnsUp),
      context.at(index));
}

void compareMetric(CheckContext& context, const char* name, double claimed, double found) {
  const double allowed = std::max(kMetricsAbsolute, kMetricsRelative * found);
  if (!(std::abs(claimed - found) <= allowed)) {
    context.findings.violated(rule::kMetricsMismatch, fmt::format("the plan gives a {} of {:.1f} m, it is {:.1f} m", name, claimed, found), {},
                              allowed - std::abs(claimed - found));
  }
}

/// The lower bound is one over the sampled headings: a refined tour may cost less, but not the tour that it was refined from.
void checkBound(CheckContext& context) {
  const mission::PlanMetrics& metrics = context.plan.metrics;
  const bool isRefined = metrics.sampledCost > 0.0;
  const double sampled = isRefined ? metrics.sampledCost : metrics.cost;
  const auto isAbove = [](double low, double high) { return !(low <= high * (1.0 + 1e-9) + 1e-6); };
  if (isAbove(metrics.lowerBound, sampled)) {
    context.findings.violated(rule::kMetricsBound,
                              fmt::format("the plan says that no tour over its headings costs less than {:.1f} m, but {} costs {:.1f} m",
                                          metrics.lowerBound, isRefined ? "the one that it was refined from" : "its own", sampled));
  }
  if (isAbove(metrics.freeLowerBound, metrics.cost)) {
    context.findings.violated(
        rule::kMetricsBound,
        fmt::format("the plan says that no tour at all costs less than {:.1f} m, but its own costs {:.1f} m", metrics.freeLowerBound, metrics.cost));
  }
  if (isAbove(metrics.cost, sampled)) {
    context.findings.violated(
        rule::kMetricsBound,
        fmt::format("the plan says that it was refined from a tour of {:.1f} m, but its own costs {:.1f} m", sampled, metrics.cost));
  }
}

}  // namespace

void checkVisits(CheckContext& context) {
  const mission::Plan& plan = context.plan;
  std::vector<int> pointOfTarget(plan.targets.size(), -1);
  std::vector<bool> hasSpiral(plan.targets.size(), false);
  for (std::size_t i = 0; i < plan.tour.size(); ++i) {
    if (isTarget(plan, plan.tour[i].target)) {
      const auto target = static_cast<std::size_t>(plan.tour[i].target);
      pointOfTarget[target] = static_cast<int>(i);
      checkVisit(context, i, plan.targets[target]);
    }
  }
  for (std::size_t target = 0; target < plan.targets.size(); ++target) {
    if (pointOfTarget[target] < 0) {
      context.findings.violated(rule::kTargetSkipped, fmt::format("target {}: no point of the tour visits it", plan.targets[target].target.name),
                                {-1, plan.targets[target].point});
    }
  }
  for (const mission::SpiralVisit& spiral : plan.spirals) {
    if (!isTarget(plan, spiral.target)) {
      continue;  // found as plan.index
    }
    const auto target = static_cast<std::size_t>(spiral.target);
    if (hasSpiral[target]) {
      context.findings.violated(rule::kSpiralData, fmt::format("target {} has two spirals", plan.targets[target].target.name));
    }
    hasSpiral[target] = true;
    checkSpiral(context, spiral, pointOfTarget);
  }
  for (std::size_t target = 0; target < plan.targets.size(); ++target) {
    const bool isAbove = pointOfTarget[target] >= 0 &&
                         plan.tour[static_cast<std::size_t>(pointOfTarget[target])].altitude > plan.targets[target].altitude + kTargetHeightTolerance;
    if (isAbove && !hasSpiral[target] && plan.mission.planner.lowTargets == mission::LowTargets::Descend) {
      context.findings.note(rule::kTargetAbove,
                            fmt::format("target {} is passed above its height without a descent", plan.targets[target].target.name),
                            context.at(static_cast<std::size_t>(pointOfTarget[target])));
    }
  }
}

/// Length counts the spirals; a target costs beta for each metre that even the lowest point of its visit stays above it.
void checkMetrics(CheckContext& context) {
  const mission::Plan& plan = context.plan;
  double length = 0.0;
  double penalty = 0.0;
  std::vector<double> lowest(plan.targets.size(), std::numeric_limits<double>::infinity());  // reached at a target by its spiral
  for (const mission::SpiralVisit& spiral : plan.spirals) {
    if (isTarget(plan, spiral.target)) {
      const double circle = 2.0 * Angle::kPi * spiral.radius;
      const double height = spiral.top - spiral.bottom;
      length += std::hypot(spiral.turnsDown * circle, height) + std::hypot(spiral.turnsUp * circle, height);
      lowest[static_cast<std::size_t>(spiral.target)] = spiral.bottom;
    }
  }
  for (std::size_t i = 0; i < plan.tour.size(); ++i) {
    const mission::DecisionPoint& point = plan.tour[i];
    length += std::hypot(point.onward.length, plan.tour[context.next(i)].altitude - point.altitude);
    if (isTarget(plan, point.target)) {
      const auto target = static_cast<std::size_t>(point.target);
      penalty += plan.mission.planner.beta * std::max(0.0, std::min(point.altitude, lowest[target]) - plan.targets[target].altitude);
    }
  }
  compareMetric(context, "length", plan.metrics.length, length);
  compareMetric(context, "penalty", plan.metrics.penalty, penalty);
  compareMetric(context, "cost", plan.metrics.cost, length + penalty);
  checkBound(context);
}

}  // namespace vp::safety
