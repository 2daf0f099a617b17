#include "core/route/build_route.h"

#include "core/landing/build_roadmap.h"
#include "core/route/altitudes.h"
#include "core/route/fly_by.h"
#include "core/route/reflown_plan.h"
#include "core/route/track.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vp::route {
namespace {

constexpr double kMatchError = 0.05;  // m of altitude, for the chords that the two paths are compared on
/// Waypoints closer than this are one place [m]. Where places are coarse, a short leg between two of them points anywhere, so longer ones are tried,
/// too.
constexpr double kLeastLegs[] = {0.5, 6.0, 15.0, 30.0};

Error noTour() {
  return {Errc::OutOfRange, "the plan has no tour to export; plan a mission with at least one target", {}};
}

double rounded(double degrees, double steps) {
  return std::round(degrees * steps) / steps;
}

/// Corners where the file will say that they are.
void roundPlaces(const geo::LocalFrame& frame, double steps, double leastLeg, std::vector<Corner>& corners, std::vector<geo::LatLon>& places) {
  std::vector<Corner> kept;
  for (Corner corner : corners) {
    const geo::LatLon exact = frame.toLatLon(corner.point);
    const geo::LatLon place{rounded(exact.latitude_deg, steps), rounded(exact.longitude_deg, steps)};
    corner.point = frame.toPoint(place);
    if (!kept.empty() && corner.target < 0 && geo::distance(corner.point, kept.back().point) < leastLeg) {
      continue;
    }
    kept.push_back(corner);
    places.push_back(place);
  }
  corners = std::move(kept);
}

/// Distances of corners along the path, ascending from the first that is passed.
struct Knots {
  std::vector<std::size_t> corner;
  std::vector<double> distance;
};

Knots knotsOf(const FlownPath& path) {
  Knots knots;
  const std::size_t count = path.passed.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t corner = (path.first + i) % count;
    knots.corner.push_back(corner);
    knots.distance.push_back(knots.distance.empty() ? path.passed[corner] : std::max(path.passed[corner], knots.distance.back() + 1e-3));
  }
  return knots;
}

/// Where each target of the plan is passed along the path: by corner; -1 for corners without one.
std::vector<double> visitsOf(const mission::Plan& plan, const std::vector<Corner>& corners, const FlownPath& path, const Track& track,
                             mission::Route& route) {
  std::vector<double> visits(corners.size(), -1.0);
  const geo::LocalFrame frame(plan.frameOrigin);
  Follower follower(track, 0.0);
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    if (corners[corner].target < 0) {
      continue;
    }
    follower.moveTo(path.passed[corner]);
    const geo::Point target = plan.targets[static_cast<std::size_t>(corners[corner].target)].point;
    const Beside passed = follower.next(target);
    visits[corner] = passed.distance;
    route.visit = std::max(route.visit, passed.aside + kTrackError);
    route.besideWaypoint = std::max(route.besideWaypoint, geo::distance(target, corners[corner].point));
  }
  return visits;
}

/// Both ways between tour and path: what the path must not be below, and how far it is aside.
struct Comparison {
  std::vector<Required> required;
  double lateral = 0.0;
};

/// @param start  m along the flown path at which the tour begins
Comparison compare(const Track& tour, const Track& flown, const std::vector<double>& marks, double start) {
  Comparison result;
  Follower onFlown(flown, start);
  for (std::size_t i = 0; i < tour.points.size(); ++i) {
    const Beside at = onFlown.next(tour.points[i]);
    result.required.push_back({at.distance, tour.altitude[i] + kMatchError});
    result.lateral = std::max(result.lateral, at.aside);
  }
  Follower onTour(tour, tour.length() - start);
  auto mark = marks.begin();
  for (std::size_t i = 0; i < flown.points.size(); ++i) {
    const Beside at = onTour.next(flown.points[i]);
    result.lateral = std::max(result.lateral, at.aside);
    for (; mark != marks.end() && (i + 1 == flown.points.size() || *mark < flown.distance[i + 1]); ++mark) {
      const double onward = std::min(at.distance + (*mark - flown.distance[i]), tour.length());
      result.required.push_back({*mark, altitudeOn(tour, onward) + kMatchError});
    }
  }
  result.lateral += 2.0 * kTrackError;
  return result;
}

/// Waypoints where they will be and the path that they give, before altitudes.
struct Layout {
  std::vector<Corner> corners;
  std::vector<geo::LatLon> places;
  FlownPath path;
  Track track;
  Knots knots;
  std::vector<double> visits;
  Comparison comparison;
  mission::Route route;
};

Result<Layout> layOut(const mission::Plan& plan, const geo::LocalFrame& frame, const Track& tour, double steps, const CornerLimits& limits,
                      double leastLeg) {
  Layout layout;
  layout.corners = tangentCorners(plan, limits);
  roundPlaces(frame, steps, leastLeg, layout.corners, layout.places);
  Result<FlownPath> path = flyAround(layout.corners);
  if (!path) {
    return forward(path);
  }
  layout.path = std::move(*path);
  layout.route.stepsPerDegree = steps;
  layout.route.length = layout.path.length;
  layout.track = trackOf(layout.path.start, layout.path.pieces);
  layout.knots = knotsOf(layout.path);
  layout.visits = visitsOf(plan, layout.corners, layout.path, layout.track, layout.route);
  layout.comparison = compare(tour, layout.track, layout.knots.distance, layout.path.passed.front());
  layout.route.lateral = layout.comparison.lateral;
  return layout;
}

/// Few corners are better, but not where turns then follow each other so closely that the path leaves the tour: fewer liberties
/// are tried until it stays within what the options allow; else the nearest path counts.
Result<Layout> bestLayout(const mission::Plan& plan, const geo::LocalFrame& frame, const Track& tour, const RouteOptions& options) {
  std::optional<Layout> best;
  Error error;
  const auto worst = [](const Layout& l) { return std::max(l.route.lateral, 2.0 * l.route.visit); };
  for (const double leastLeg : kLeastLegs) {
    for (const double liberty : {1.0, 0.5, 0.2, 0.05}) {
      CornerLimits limits = options.limits;
      limits.beside *= liberty;
      limits.lateral *= liberty;
      Result<Layout> layout = layOut(plan, frame, tour, options.stepsPerDegree, limits, leastLeg);
      if (!layout) {
        error = layout.error();
        continue;
      }
      if (!best || worst(*layout) < worst(*best)) {
        best = std::move(*layout);
      }
      if (worst(*best) <= options.lateral) {
        return std::move(*best);
      }
    }
  }
  return best ? Result<Layout>(std::move(*best)) : tl::unexpected(error);
}

std::vector<std::string> namesOf(const mission::Plan& plan, const std::vector<Corner>& corners) {
  std::set<std::string> used;
  for (const mission::TargetInFrame& target : plan.targets) {
    used.insert(target.target.name);
  }
  std::vector<std::string> names;
  int number = 0;
  for (const Corner& corner : corners) {
    std::string name;
    if (corner.target >= 0) {
      name = plan.targets[static_cast<std::size_t>(corner.target)].target.name;
      name = name.empty() ? fmt::format("T{}", corner.target + 1) : name;
    }
    while (name.empty() || (corner.target < 0 && used.contains(name))) {
      name = fmt::format("V{:03}", ++number);
    }
    names.push_back(name);
  }
  return names;
}

double overTour(const Track& tour, const FlownPoints& flown, double start) {
  Follower follower(tour, tour.length() - start);
  double most = 0.0;
  for (const mission::DecisionPoint& point : flown.points) {
    most = std::max(most, point.altitude - altitudeOn(tour, follower.next(point.pose.point()).distance));
  }
  return most;
}

void fillWaypoints(const mission::Plan& plan, const std::vector<Corner>& corners, const std::vector<geo::LatLon>& places, const FlownPath& path,
                   const Knots& knots, const std::vector<double>& altitudes, mission::Route& route) {
  const std::vector<std::string> names = namesOf(plan, corners);
  route.waypoints.resize(corners.size());
  for (std::size_t k = 0; k < knots.corner.size(); ++k) {
    const std::size_t i = knots.corner[k];
    route.waypoints[i] = {names[i],         places[i], altitudes[k], corners[i].target, corners[i].radius, Angle::radians(path.turned[i]).degrees(),
                          knots.distance[k]};
  }
  const double start = route.waypoints.front().distance;
  for (mission::RouteWaypoint& waypoint : route.waypoints) {
    waypoint.distance -= start;
    waypoint.distance += waypoint.distance < 0.0 ? path.length : 0.0;
  }
}

void fillFlown(const geo::LocalFrame& frame, const Track& track, const Knots& knots, const std::vector<double>& altitudes, double from,
               mission::Route& route) {
  const auto at = [&](std::size_t i, double distance) {
    route.flown.push_back({frame.toLatLon(track.points[i]), altitudeBetween(knots.distance, altitudes, track.length(), distance)});
  };
  const std::size_t chords = track.points.size() - 1;
  const auto first = static_cast<std::size_t>(std::lower_bound(track.distance.begin(), track.distance.end(), from) - track.distance.begin()) % chords;
  for (std::size_t k = 0; k <= chords; ++k) {
    const std::size_t i = (first + k) % chords;
    at(i, track.distance[i]);
  }
}

/// The plan of the flown path. Targets move to where it passes them.
mission::Plan reflownPlan(const mission::Plan& plan, FlownPoints flown, const std::vector<Corner>& corners, const std::vector<double>& visits) {
  mission::Plan result = plan;
  const geo::LocalFrame frame(plan.frameOrigin);
  result.certificate.reset();
  result.spirals.clear();
  result.mission.home.reset();
  result.departure.reset();
  result.arrival.reset();
  result.metrics = {};
  result.mission.planner.lowTargets = mission::LowTargets::PassAbove;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (visits[i] < 0.0) {
      continue;
    }
    const auto nearest = std::min_element(flown.distance.begin(), flown.distance.end(),
                                          [&](double a, double b) { return std::abs(a - visits[i]) < std::abs(b - visits[i]); });
    mission::DecisionPoint& point = flown.points[static_cast<std::size_t>(nearest - flown.distance.begin())];
    const auto target = static_cast<std::size_t>(corners[i].target);
    point.target = corners[i].target;
    mission::TargetInFrame& placed = result.targets[target];
    placed.point = point.pose.point();
    placed.target.position = frame.toLatLon(placed.point);
    placed.target.reference = mission::HeightReference::Msl;
    placed.target.height_m = placed.altitude;
    if (target < result.mission.targets.size()) {  // else the plan is not one of its mission, which the checker says
      result.mission.targets[target] = placed.target;
    }
  }
  result.tour = std::move(flown.points);
  for (std::size_t i = 0; i < result.tour.size(); ++i) {
    const mission::DecisionPoint& point = result.tour[i];
    const mission::DecisionPoint& next = result.tour[(i + 1) % result.tour.size()];
    result.metrics.length += std::hypot(point.onward.length, next.altitude - point.altitude);
    if (point.target >= 0) {
      const double above = point.altitude - result.targets[static_cast<std::size_t>(point.target)].altitude;
      result.metrics.penalty += plan.mission.planner.beta * std::max(0.0, above);
    }
  }
  result.metrics.cost = result.metrics.length + result.metrics.penalty;
  return result;
}

}  // namespace

Result<Ground> prepareGround(const mission::Plan& plan, std::shared_ptr<const terrain::ElevationGrid> terrain, const Job& job) {
  constexpr double kMargin = 3000.0;  // m around the tour and the sites that it glides to
  if (plan.tour.empty()) {
    return tl::unexpected(noTour());
  }
  geo::Box box;
  for (const mission::DecisionPoint& point : plan.tour) {
    box.add(point.pose.point());
    if (point.witness.site >= 0) {
      box.add(plan.sites[static_cast<std::size_t>(point.witness.site)].pose.point());
    }
  }
  box = box.grown(kMargin);
  const geo::Box extent = terrain->extent();
  Ground ground;
  ground.world.terrain = terrain::TerrainPyramid(std::move(terrain));
  ground.world.glide = aircraft::GlideModel(plan.mission.aircraft);
  ground.world.sites = plan.sites;
  ground.world.clearance = plan.mission.safety.clearance.si();
  ground.world.arrivalMargin = plan.mission.safety.arrivalMargin.si();
  landing::RoadmapRequest request;
  request.area = {std::max(box.minX, extent.minX), std::max(box.minY, extent.minY), std::min(box.maxX, extent.maxX), std::min(box.maxY, extent.maxY)};
  auto built = landing::buildRoadmap(ground.world, plan.mission.planner, request, job);
  if (!built) {
    return forward(built);
  }
  ground.roadmap = std::move(*built);
  return ground;
}

Result<BuiltRoute> buildRoute(const mission::Plan& plan, const Ground* ground, const RouteOptions& options, const Job& job) {
  if (plan.tour.empty()) {
    return tl::unexpected(noTour());
  }
  const geo::LocalFrame frame(plan.frameOrigin);
  const Track tour = trackOfTour(plan, firstVisit(plan));
  Result<Layout> layout = bestLayout(plan, frame, tour, options);
  if (!layout) {
    return forward(layout);
  }
  BuiltRoute built;
  built.route = std::move(layout->route);
  mission::Route& route = built.route;
  const std::vector<Corner>& corners = layout->corners;
  const FlownPath& path = layout->path;
  const std::vector<double>& visits = layout->visits;
  const Knots& knots = layout->knots;
  Comparison& comparison = layout->comparison;

  std::vector<double> marks = knots.distance;
  std::copy_if(visits.begin(), visits.end(), std::back_inserter(marks), [](double at) { return at >= 0.0; });
  Result<FlownPoints> flown = flownPoints(ground != nullptr ? &ground->world : nullptr, ground != nullptr ? ground->roadmap.get() : nullptr, path,
                                          std::move(marks), plan.mission.planner.step.si(), job);
  if (!flown) {
    return forward(flown);
  }
  for (std::size_t i = 0; i < flown->points.size(); ++i) {
    comparison.required.push_back({flown->distance[i], flown->lowest[i]});
  }
  const Pitch pitch{tan(plan.mission.aircraft.maxClimb), tan(plan.mission.aircraft.maxDescent)};
  const std::vector<double> altitudes = waypointAltitudes(knots.distance, path.length, comparison.required, pitch);
  for (std::size_t i = 0; i < flown->points.size(); ++i) {
    flown->points[i].altitude = altitudeBetween(knots.distance, altitudes, path.length, flown->distance[i]);
  }
  route.above = overTour(tour, *flown, path.passed.front());
  fillWaypoints(plan, corners, layout->places, path, knots, altitudes, route);
  fillFlown(frame, layout->track, knots, altitudes, knots.distance[(corners.size() - path.first) % corners.size()], route);
  built.reflown = reflownPlan(plan, std::move(*flown), corners, visits);
  return built;
}

}  // namespace vp::route
