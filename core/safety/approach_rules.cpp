// Approaches: slopes that can be held, runways that are long enough, and holds over the gates.

#include "core/safety/cell_walk.h"
#include "core/safety/check_context.h"
#include "core/safety/descent.h"
#include "core/safety/ground_path.h"
#include "core/safety/landing_length.h"
#include "core/safety/last_part.h"
#include "core/safety/limits.h"
#include "core/safety/rules.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace vp::safety {
namespace {

bool isUsed(const CheckContext& context, std::size_t site) {
  return site < context.siteUsed.size() && context.siteUsed[site];
}

/// Neither flatter than the glide in the worst wind, nor steeper than the aircraft descends with the wind behind it. Who is above the slope may lose
/// more: flatter counts at the altitudes of the lowest that every glide to the site may be on.
void checkSlope(CheckContext& context, std::size_t index) {
  const mission::SiteInFrame& site = context.plan.sites[index];
  const mission::Mission& mission = context.plan.mission;
  if (mission.approach.kind != mission::ApproachKind::Straight || !mission.approach.slope || !mission.aircraft.steepestDescent) {
    return;
  }
  const flight::Piece final{flight::Turn::Straight, 0.0, mission.approach.finalLength.si()};
  const double slope = tan(*mission.approach.slope);
  const double gate = context.gateLowest[index];
  const bool isKnown = gate > -kNoHeight;
  const double least =
      context.rates.mostStraightBetween(site.pose.heading, isKnown ? gate - slope * final.length : -kNoHeight, isKnown ? gate : kNoHeight);
  const double most = tan(*mission.aircraft.steepestDescent) * context.rates.descentShare(site.pose.heading, final);
  const auto degrees = [](double tangent) { return Angle::radians(std::atan(tangent)).degrees(); };
  if (!(slope >= least * (1.0 - kRadiusTolerance))) {
    context.findings.violated(rule::kApproachSlope,
                              fmt::format("the approach to {} at {:.2f} degrees is flatter than the glide there, which needs up to {:.2f} degrees",
                                          site.site.id, degrees(slope), degrees(least)),
                              {-1, site.pose.point()}, degrees(slope) - degrees(least));
  }
  if (!(slope <= most * (1.0 + kRadiusTolerance))) {
    context.findings.violated(
        rule::kApproachSlope,
        fmt::format("the approach to {} at {:.2f} degrees is steeper than the aircraft can descend there, {:.2f} degrees with the "
                    "wind from behind",
                    site.site.id, degrees(slope), degrees(most)),
        {-1, site.pose.point()}, degrees(most) - degrees(slope));
  }
}

/** A hold, the site that it belongs to, and the pose over which it is flown. */
struct PlacedHold {
  const mission::Hold& hold;
  std::size_t index = 0;
  const mission::SiteInFrame& site;
  geo::Pose gate;
  flight::Piece circle;
};

/// @return false if the circle cannot be flown
bool checkHoldRadius(CheckContext& context, const PlacedHold& placed) {
  const mission::Hold& hold = placed.hold;
  const double smallest = context.rates.leastGlideRadius();
  const bool turns = hold.turn == flight::Turn::Left || hold.turn == flight::Turn::Right;
  if (turns && hold.radius >= smallest * (1.0 - kRadiusTolerance) && isIntegrable(placed.circle)) {
    return true;
  }
  context.findings.violated(
      rule::kHoldRadius,
      fmt::format("the hold before {} has a radius of {:.2f} m to the {}, the aircraft needs {:.2f} m to one side", placed.site.site.id, hold.radius,
                  hold.turn == flight::Turn::Left    ? "left"
                  : hold.turn == flight::Turn::Right ? "right"
                                                     : "front",
                  smallest),
      {-1, placed.gate.point()}, hold.radius - smallest);
  return false;
}

void checkHoldHeight(CheckContext& context, const PlacedHold& placed) {
  CellWalk walk(context.terrain);
  walk.start(placed.gate, placed.circle);
  double ground = -kNoHeight;
  Span span;
  while (walk.next(span)) {
    if (!span.isKnown()) {
      context.findings.unknown(rule::kTerrainUnknown, fmt::format("the hold before {} crosses ground of unknown height", placed.site.site.id),
                               {-1, poseOn(placed.gate, placed.circle, span.from).point()});
      return;
    }
    ground = std::max(ground, span.ground);
  }
  const double needed = std::max(ground + context.clearance, context.gateLowest[placed.index]);
  if (!(placed.hold.lowest >= needed - kAltitudeTolerance)) {
    context.findings.violated(rule::kHoldClearance,
                              fmt::format("the hold before {} goes down to {:.1f} m MSL, but its ground of {:.1f} m and the approach need {:.1f} m",
                                          placed.site.site.id, placed.hold.lowest, ground, needed),
                              {-1, placed.gate.point()}, placed.hold.lowest - needed);
  }
}

/// Whole circles leave up to one of them over; the final approach has to be steep enough for that.
void warnAboutSurplus(CheckContext& context, const PlacedHold& placed) {
  const mission::Mission& mission = context.plan.mission;
  if (mission.approach.kind != mission::ApproachKind::Straight || !mission.aircraft.steepestDescent) {
    return;
  }
  const flight::Piece final{flight::Turn::Straight, 0.0, mission.approach.finalLength.si()};
  Descent circle(context.rates, placed.gate.heading, placed.circle);
  const double above = circle.up(placed.circle.length, placed.hold.lowest, 0.0) - placed.site.site.elevation.metres() - context.arrivalMargin;
  const double most = tan(*mission.aircraft.steepestDescent) * context.rates.descentShare(placed.site.pose.heading, final) * final.length;
  if (above > most) {
    context.findings.warning(
        rule::kHoldSurplus,
        fmt::format("after the last whole circle of the hold before {} up to {:.0f} m above the runway may be left, and the steepest "
                    "descent on the final approach loses {:.0f} m: lose the rest in S-turns or on a part of a circle",
                    placed.site.site.id, std::ceil(above), std::floor(most)),
        {-1, placed.gate.point()});
  }
}

}  // namespace

void checkLength(CheckContext& context, const mission::SiteInFrame& site) {
  const std::optional<double> needed = landingLength(context.plan, site.site);
  if (!needed || !site.site.length || *needed <= site.site.length->si() + kClaimTolerance) {
    return;
  }
  context.findings.violated(rule::kSiteLength,
                            fmt::format("glides end at {}, which is {:.0f} m long, but the aircraft needs {:.0f} m to land there", site.site.id,
                                        std::floor(site.site.length->si()), std::ceil(*needed)),
                            {-1, site.pose.point()}, site.site.length->si() - *needed);
}

void checkApproaches(CheckContext& context) {
  for (std::size_t i = 0; i < context.plan.sites.size(); ++i) {
    if (isUsed(context, i)) {
      checkSlope(context, i);
      checkLength(context, context.plan.sites[i]);
    }
  }
}

void checkHolds(CheckContext& context) {
  const mission::Plan& plan = context.plan;
  std::vector<int> count(plan.sites.size(), 0);
  for (const mission::Hold& hold : plan.holds) {
    const auto site = static_cast<std::size_t>(hold.site);
    if (hold.site < 0 || site >= plan.sites.size()) {
      continue;  // found as plan.index
    }
    ++count[site];
    const geo::Pose gate = gateOf(plan.sites[site].pose, plan.mission.approach);
    const PlacedHold placed{hold, site, plan.sites[site], gate, {hold.turn, hold.radius, 2.0 * Angle::kPi * hold.radius}};
    if (checkHoldRadius(context, placed)) {
      checkHoldHeight(context, placed);
      warnAboutSurplus(context, placed);
    }
  }
  for (std::size_t i = 0; i < plan.sites.size(); ++i) {
    const bool isAsked = plan.mission.approach.hold && isUsed(context, i);
    const std::string& site = plan.sites[i].site.id;
    const FindingPlace place{-1, plan.sites[i].pose.point()};
    if (isAsked && count[i] != 1) {
      context.findings.violated(
          rule::kHoldMissing,
          fmt::format("the mission asks for one hold before each landing site that a glide ends at, but the plan has {} before {}", count[i], site),
          place);
    } else if (count[i] > 1) {
      context.findings.violated(rule::kHoldMissing,
                                fmt::format("the plan has {} holds before {}, so it is not clear which one is flown", count[i], site), place);
    }
  }
}

}  // namespace vp::safety
