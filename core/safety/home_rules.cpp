// The ways from the home runway to the tour and back: where they begin and end, what is promised on them, and the climb-out before that.

#include "core/safety/cell_walk.h"
#include "core/safety/check_context.h"
#include "core/safety/ground_path.h"
#include "core/safety/limits.h"
#include "core/safety/rules.h"

#include <fmt/core.h>

#include <cmath>

namespace vp::safety {
namespace {

using mission::HomePath;

bool isAt(const geo::Pose& pose, const geo::Pose& wanted, double place, double heading) {
  return geo::distance(pose.point(), wanted.point()) <= place && std::abs(wrapPi(pose.heading - wanted.heading)) <= heading;
}

/// @return false if the rest of the path cannot be checked
bool checkHomeData(CheckContext& context, const HomePath& path, const char* name, const std::string& wanted) {
  const mission::Plan& plan = context.plan;
  const auto inside = [](int index, std::size_t size) { return index >= 0 && static_cast<std::size_t>(index) < size; };
  if (path.points.size() < 2 || !inside(path.site, plan.sites.size()) || !inside(path.join, plan.tour.size()) ||
      !inside(path.guaranteed, path.points.size())) {
    context.findings.violated(rule::kHomeData,
                              fmt::format("the {} has {} points, runway no. {}, meets the tour at point {} and promises a glide from "
                                          "its point {} on, which does not fit the plan",
                                          name, path.points.size(), path.site, path.join, path.guaranteed));
    return false;
  }
  const std::string& id = plan.sites[static_cast<std::size_t>(path.site)].site.id;
  if (id != wanted) {
    context.findings.violated(rule::kHomeData, fmt::format("the {} uses {}, but the mission asks for {}", name, id, wanted));
  }
  return true;
}

void checkJoin(CheckContext& context, const HomePath& path, const char* name, const mission::DecisionPoint& end) {
  const mission::DecisionPoint& tour = context.plan.tour[static_cast<std::size_t>(path.join)];
  if (!isAt(end.pose, tour.pose, kGapTolerance, kGapHeadingTolerance) || !(std::abs(end.altitude - tour.altitude) <= kAltitudeTolerance)) {
    context.findings.violated(rule::kHomeJoin,
                              fmt::format("the {} meets the tour {:.2f} m beside its point {}, {:.2f} m above it", name,
                                          geo::distance(end.pose.point(), tour.pose.point()), path.join, end.altitude - tour.altitude),
                              {path.join, end.pose.point()});
  }
}

/// What the climb-out before the guarantee comes to, for the sentence that a pilot reads.
struct ClimbOut {
  double length = 0.0;
  double lowest = 0.0;  ///< m that it lies below the highest ground of its cells near the airfield; 0 if nowhere
};

/// Ground under one interval of the climb-out. @return false at unknown ground
bool checkClimbGround(CheckContext& context, std::size_t index, CellWalk& walk, ClimbOut& climb) {
  const mission::DecisionPoint& from = context.track.points[index];
  const mission::DecisionPoint& to = context.track.points[index + 1];
  const double length = from.onward.length;
  walk.start(from.pose, from.onward);
  Span span;
  while (walk.next(span)) {
    const geo::Point where = poseOn(from.pose, from.onward, span.to).point();
    if (!span.isKnown()) {
      context.findings.unknown(rule::kTerrainUnknown, fmt::format("{}: the climb-out crosses ground of unknown height", context.nameOf(index)),
                               context.atPlace(index, where));
      return false;
    }
    const auto altitudeAt = [&](double distance) {
      return length > 0.0 ? from.altitude + (to.altitude - from.altitude) * std::min(1.0, distance / length) : from.altitude;
    };
    const double flown = climb.length + span.to;
    const double above = std::min(altitudeAt(span.from), altitudeAt(span.to)) - span.ground;
    const double needed = std::min(context.clearance, kDepartureObstacleClearance * flown);
    if (flown <= kAirfieldDistance) {
      climb.lowest = std::max(climb.lowest, -above);
    } else if (!(above >= needed - kAltitudeTolerance)) {
      context.findings.violated(rule::kHomeClearance,
                                fmt::format("{}: {:.0f} m after the runway the climb-out is {:.1f} m above ground of {:.1f} m, {:.1f} m are required",
                                            context.nameOf(index), flown, above, span.ground, needed),
                                context.atPlace(index, where), above - needed);
      return false;
    }
  }
  climb.length += length;
  return true;
}

void checkClimbOut(CheckContext& context, const HomePath& path, ClimbOut& climb) {
  context.track = {};
  context.track.name = "departure";
  context.track.isClosed = false;
  context.track.points = std::span(path.points).first(static_cast<std::size_t>(path.guaranteed) + 1);
  const bool wasClean = context.findings.isClean();
  checkPoweredTrack(context);
  if (wasClean && !context.findings.isClean()) {
    return;
  }
  CellWalk walk(context.terrain);
  for (std::size_t i = 0; i + 1 < context.track.points.size(); ++i) {
    if (!isIntegrable(path.points[i].onward) || !checkClimbGround(context, i, walk, climb)) {
      return;
    }
  }
  if (climb.lowest > 0.0) {
    context.findings.warning(rule::kHomeLow, fmt::format("the climb-out starts up to {:.0f} m below the highest ground of the terrain cells within "
                                                         "{:.0f} m of the runway, which are no finer than {:.0f} m: look out for obstacles there",
                                                         std::ceil(climb.lowest), kAirfieldDistance, context.terrain.cellSize()));
  }
}

void checkGuaranteed(CheckContext& context, const HomePath& path, const char* name, const Job& job) {
  context.track = {};
  context.track.name = name;
  context.track.isClosed = false;
  context.track.first = static_cast<std::size_t>(path.guaranteed);
  context.track.points = std::span(path.points).subspan(context.track.first);
  const std::vector<bool> used = context.siteUsed;
  checkGlides(context, job.part(0.0, 0.8));
  for (std::size_t i = 0; i < used.size(); ++i) {
    context.siteUsed[i] = context.siteUsed[i] || used[i];
  }
  checkTour(context, job.part(0.8, 1.0));
}

void checkDeparture(CheckContext& context, const HomePath& path, ClimbOut& climb, const Job& job) {
  const mission::SiteInFrame& site = context.plan.sites[static_cast<std::size_t>(path.site)];
  const mission::DecisionPoint& first = path.points.front();
  const double runway = site.site.length ? site.site.length->si() : 0.0;
  const geo::Pose end = poseOn(site.pose, {flight::Turn::Straight, 0.0, runway}, runway);
  if (!isAt(first.pose, end, kFrameTolerance, kArrivalHeadingTolerance) ||
      !(std::abs(first.altitude - site.site.elevation.metres()) <= kClaimTolerance)) {
    context.findings.violated(rule::kHomeRunway,
                              fmt::format("the departure begins {:.1f} m from the far end of {} at {:.1f} m MSL, the runway is at {:.1f} m",
                                          geo::distance(first.pose.point(), end.point()), site.site.id, first.altitude, site.site.elevation.metres()),
                              {-1, first.pose.point()});
  }
  checkJoin(context, path, "departure", path.points.back());
  checkClimbOut(context, path, climb);
  checkGuaranteed(context, path, "departure", job);
}

void checkArrival(CheckContext& context, const HomePath& path, const Job& job) {
  const mission::SiteInFrame& site = context.plan.sites[static_cast<std::size_t>(path.site)];
  const mission::DecisionPoint& last = path.points.back();
  const double above = last.altitude - site.site.elevation.metres();
  if (!isAt(last.pose, site.pose, kArrivalPlaceTolerance, kArrivalHeadingTolerance) || !(above >= context.arrivalMargin - kAltitudeTolerance) ||
      path.guaranteed != 0) {
    context.findings.violated(
        rule::kHomeRunway,
        fmt::format("the arrival must lead above the threshold of {} with the glide promised all along; it ends {:.1f} m from it, "
                    "{:.1f} m above it, promised from its point {} on",
                    site.site.id, geo::distance(last.pose.point(), site.pose.point()), above, path.guaranteed),
        {-1, last.pose.point()});
    return;
  }
  checkJoin(context, path, "arrival", path.points.front());
  checkGuaranteed(context, path, "arrival", job);
}

void sayWhereGuaranteed(CheckContext& context, const ClimbOut& climb) {
  const HomePath& out = *context.plan.departure;
  const HomePath& in = *context.plan.arrival;
  const mission::LandingSite& from = context.plan.sites[static_cast<std::size_t>(out.site)].site;
  const mission::LandingSite& to = context.plan.sites[static_cast<std::size_t>(in.site)].site;
  const double begins = out.points[static_cast<std::size_t>(out.guaranteed)].altitude;
  const double ends = in.points.back().altitude;
  context.findings.note(
      rule::kHomeGuarantee,
      fmt::format(
          "The same holds on the ways from and to the runway, but for the climb-out: after taking off from {} it begins {:.0f} m of flight "
          "past the far end of the runway, at {:.0f} m MSL ({:.0f} m above the runway), and it ends above the threshold of {} at {:.0f} m MSL "
          "({:.0f} m above the runway), from where the landing is the pilot's.",
          from.id, std::ceil(climb.length), std::floor(begins), std::floor(begins - from.elevation.metres()), to.id, std::ceil(ends),
          std::ceil(ends - to.elevation.metres())));
}

}  // namespace

void checkHome(CheckContext& context, const Job& job) {
  const mission::Plan& plan = context.plan;
  const std::optional<mission::HomeBase>& home = plan.mission.home;
  if (!home && !plan.departure && !plan.arrival) {
    return;
  }
  if (!home || !plan.departure || !plan.arrival) {
    context.findings.violated(rule::kHomeData, home ? "the mission asks for a home runway, but the plan lacks the way from it or to it"
                                                    : "the plan has a way from or to a runway that the mission does not ask for");
    return;
  }
  ClimbOut climb;
  if (checkHomeData(context, *plan.departure, "departure", home->takeoff)) {
    checkDeparture(context, *plan.departure, climb, job.part(0.0, 0.5));
  }
  if (checkHomeData(context, *plan.arrival, "arrival", home->landing)) {
    checkArrival(context, *plan.arrival, job.part(0.5, 1.0));
  }
  if (context.findings.isClean()) {
    sayWhereGuaranteed(context, climb);
  }
}

}  // namespace vp::safety
