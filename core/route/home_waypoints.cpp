// The waypoints of a flight from and to home: those of the ways around those of the closed tour, their names, and what is said about them.
#include "core/aircraft/glide_model.h"
#include "core/mission/glide_conditions.h"
#include "core/route/home_route.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace vp::route {
namespace {

constexpr double kEnough = 1e-6;  // m

double runwayLength(const mission::SiteInFrame& site) {
  return site.site.length ? site.site.length->si() : 0.0;
}

const mission::SiteInFrame& siteOf(const mission::Plan& plan, const std::optional<mission::HomePath>& path) {
  return plan.sites[static_cast<std::size_t>(path->site)];
}

long feet(double metres) {
  return std::lround(metres / kMetresPerFoot);
}

}  // namespace

/// Names that no two waypoints share.
class HomeRoute::Names {
public:
  explicit Names(const std::vector<mission::RouteWaypoint>& waypoints) {
    for (const mission::RouteWaypoint& waypoint : waypoints) {
      used_.insert(waypoint.name);
    }
  }
  std::string unused(const std::string& wanted) {
    std::string name = wanted;
    for (int number = 2; !used_.insert(name).second; ++number) {
      name = fmt::format("{}-{}", wanted, number);
    }
    return name;
  }

private:
  std::set<std::string> used_;
};

void HomeRoute::addFlown(const std::vector<double>& loopAltitudes, mission::Route& route) const {
  const geo::LocalFrame frame(plan_->frameOrigin);
  route.flown.clear();
  const mission::SiteInFrame& takeoff = siteOf(*plan_, plan_->departure);
  if (runwayLength(takeoff) > 0.0) {
    route.flown.push_back({takeoff.site.touchdown, takeoff.site.elevation.metres()});
  }
  const auto addWay = [&](const Way& way) {
    for (std::size_t i = 0; i < way.flown.track.points.size(); ++i) {
      route.flown.push_back({frame.toLatLon(way.flown.track.points[i]), altitudeBetween(way.knots, way.altitudes, way.flown.track.distance[i])});
    }
  };
  addWay(departure_);
  const double length = loop_->path.length;
  std::vector<double> altitudes;
  for (const std::size_t corner : loop_->knots.corner) {
    altitudes.push_back(loopAltitudes[corner]);
  }
  double from = loopDistance(departure_.flown.join);
  const double to = loopDistance(arrival_.flown.join);
  const auto passes = std::count(corners_.begin(), corners_.end(), departure_.flown.join);
  double left = std::fmod(to - from + length, length);
  left += passes > 1 ? length * static_cast<double>(passes - 1) : 0.0;
  while (left > kEnough) {
    const double part = std::min(left, length - from);
    const FlownPath path = partOf(loop_->path, from, from + part);
    const Track track = trackOf(path.start, path.pieces);
    for (std::size_t i = 1; i < track.points.size(); ++i) {
      route.flown.push_back(
          {frame.toLatLon(track.points[i]), altitudeBetween(loop_->knots.distance, altitudes, length, std::min(length, from + track.distance[i]))});
    }
    left -= part;
    from = 0.0;
  }
  addWay(arrival_);
}

void HomeRoute::addRunway(int site, Names& names, mission::Route& route) const {
  const mission::SiteInFrame& takeoff = plan_->sites[static_cast<std::size_t>(site)];
  const geo::LocalFrame frame(plan_->frameOrigin);
  const double steps = route.stepsPerDegree;
  const auto placed = [&](geo::LatLon exact) {
    return geo::LatLon{std::round(exact.latitude_deg * steps) / steps, std::round(exact.longitude_deg * steps) / steps};
  };
  mission::RouteWaypoint threshold;
  threshold.name = names.unused(takeoff.site.id);
  threshold.place = placed(frame.toLatLon(takeoff.pose.point()));
  threshold.altitude = static_cast<double>(feet(takeoff.site.elevation.metres())) * kMetresPerFoot;
  threshold.turnRadius = aircraft::GlideModel(plan_->mission.aircraft, mission::glideConditionsOf(plan_->mission, plan_->sites)).tourRadius();
  threshold.site = site;
  threshold.note = "takeoff: no gliding guarantee yet";
  route.waypoints.push_back(threshold);
  if (runwayLength(takeoff) > 0.0) {
    mission::RouteWaypoint end = threshold;
    end.name = names.unused("RWY-END");
    end.site = -1;
    end.place = placed(frame.toLatLon(departure_.flown.path.start.point()));
    end.distance = runwayLength(takeoff);
    end.note = "far end of the runway: no gliding guarantee yet";
    route.waypoints.push_back(end);
  }
}

mission::RouteWaypoint HomeRoute::ownWaypoint(const Way& way, std::size_t knot, double base) const {
  const HomeKnot& at = way.flown.knots[knot];
  mission::RouteWaypoint waypoint;
  waypoint.place = way.flown.places[static_cast<std::size_t>(at.own)];
  waypoint.altitude = way.altitudes[knot + way.ends];
  waypoint.turnRadius = way.flown.corners[static_cast<std::size_t>(at.own)].radius;
  waypoint.turn_deg = Angle::radians(at.turned).degrees();
  waypoint.distance = base + at.distance;
  return waypoint;
}

/// Marks where the guarantee begins. @return whether it has begun
bool HomeRoute::sayGuarantee(double distance, bool hasBegun, Names& names, mission::RouteWaypoint& waypoint) const {
  const double begins = isGroundKnown_ ? departure_.points.distance[guaranteed_] : std::numeric_limits<double>::infinity();
  if (distance < begins - kEnough) {
    waypoint.note = "no gliding guarantee yet";
    return false;
  }
  if (!hasBegun) {
    waypoint.note = "gliding guarantee begins";
    waypoint.name = waypoint.target < 0 ? names.unused("SAFE-BEGIN") : waypoint.name;
  }
  return true;
}

/// The way's own waypoints, then those of the closed tour until the paths are one. @return how many of the latter
std::size_t HomeRoute::addDeparture(const std::vector<mission::RouteWaypoint>& loop, Names& names, mission::Route& route) const {
  const double runway = runwayLength(siteOf(*plan_, plan_->departure));
  bool hasBegun = false;
  std::size_t shared = 0;
  for (std::size_t i = 0; i < departure_.flown.knots.size(); ++i) {
    const HomeKnot& knot = departure_.flown.knots[i];
    mission::RouteWaypoint waypoint;
    if (knot.own >= 0) {
      waypoint = ownWaypoint(departure_, i, runway);
    } else {
      waypoint = loop[static_cast<std::size_t>(knot.loop)];
      waypoint.turn_deg = Angle::radians(knot.turned).degrees();
      waypoint.distance = runway + knot.distance;
      ++shared;
    }
    hasBegun = sayGuarantee(knot.distance, hasBegun, names, waypoint);
    waypoint.name = waypoint.name.empty() ? names.unused(fmt::format("D{:02}", i + 1)) : waypoint.name;
    route.waypoints.push_back(waypoint);
  }
  return shared;
}

/// The waypoints of the closed tour behind the departure's join. @param passed  of corners_, those that are there already
void HomeRoute::addLoop(const std::vector<mission::RouteWaypoint>& loop, std::size_t passed, Names& names, mission::Route& route) const {
  const double length = loop_->path.length;
  const double base = route.waypoints.back().distance;
  const double first = loopDistance(departure_.flown.join);
  std::vector<bool> isNamed(loop.size(), false);
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const std::size_t corner = corners_[i];
    if (i >= passed) {
      mission::RouteWaypoint waypoint = loop[corner];
      double onward = std::fmod(loopDistance(corner) - first + length, length);
      while (base + onward <= route.waypoints.back().distance - kEnough) {
        onward += length;
      }
      waypoint.distance = base + onward;
      if (isNamed[corner]) {  // passed for a second time
        waypoint.target = -1;
        waypoint.name = names.unused(waypoint.name);
      }
      route.waypoints.push_back(waypoint);
    }
    isNamed[corner] = true;
  }
}

void HomeRoute::addArrival(std::size_t lastLoop, Names& names, mission::Route& route) const {
  const std::vector<HomeKnot>& knots = arrival_.flown.knots;
  const auto shared = static_cast<std::size_t>(std::count_if(knots.begin(), knots.end(), [](const HomeKnot& knot) { return knot.loop >= 0; }));
  const std::size_t join = lastLoop + 1 - shared;
  const double base = route.waypoints[join].distance;
  // The arrival's own turns and distances at the corners behind the join; only the last differs from the closed tour's.
  for (std::size_t i = 0; i < shared; ++i) {
    route.waypoints[join + i].distance = base + knots[i].distance;
    route.waypoints[join + i].turn_deg = Angle::radians(knots[i].turned).degrees();
  }
  for (std::size_t i = shared; i < knots.size(); ++i) {
    mission::RouteWaypoint waypoint = ownWaypoint(arrival_, i, base);
    const bool isLast = i + 1 == knots.size();
    waypoint.name = names.unused(isLast ? "SAFE-END" : fmt::format("A{:02}", i - shared + 1));
    waypoint.note = isLast ? "above the threshold: gliding guarantee ends" : "";
    route.waypoints.push_back(waypoint);
  }
  mission::RouteWaypoint threshold = route.waypoints.back();
  const mission::LandingSite& landing = siteOf(*plan_, plan_->arrival).site;
  threshold.name = names.unused(landing.id);
  threshold.altitude = static_cast<double>(feet(landing.elevation.metres())) * kMetresPerFoot;
  threshold.site = plan_->arrival->site;
  threshold.note = "landing: no gliding guarantee any more";
  route.waypoints.push_back(threshold);
}

void HomeRoute::addWaypoints(mission::Route& route) const {
  const std::vector<mission::RouteWaypoint> loop = std::move(route.waypoints);
  route.waypoints.clear();
  Names names(loop);
  addRunway(plan_->departure->site, names, route);
  const std::size_t shared = addDeparture(loop, names, route);
  addLoop(loop, shared, names, route);
  addArrival(route.waypoints.size() - 1, names, route);
  route.length = route.waypoints.back().distance;
}

std::string HomeRoute::guaranteeText() const {
  if (!isGroundKnown_) {
    return "Nothing is known of gliding guarantees on this route.";
  }
  const mission::SiteInFrame& from = siteOf(*plan_, plan_->departure);
  const mission::SiteInFrame& to = siteOf(*plan_, plan_->arrival);
  return fmt::format(
      "The gliding guarantee begins {:.0f} m of flight past the far end of the runway of {}, at {} ft MSL, at or before SAFE-BEGIN, and ends above "
      "the threshold of {} at {} ft MSL; before and after that no glide to a runway is guaranteed.",
      std::ceil(departure_.points.distance[guaranteed_]), from.site.id, feet(departure_.points.points[guaranteed_].altitude), to.site.id,
      feet(arrival_.points.points.back().altitude));
}

}  // namespace vp::route
