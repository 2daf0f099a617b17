#include "core/route/build_route.h"

#include "core/landing/approach.h"
#include "core/landing/build_roadmap.h"
#include "core/mission/glide_conditions.h"
#include "core/route/altitudes.h"
#include "core/route/home_route.h"
#include "core/route/layout.h"
#include "core/route/reflown_plan.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vp::route {
namespace {

Error noTour() {
  return {Errc::OutOfRange, "the plan has no tour to export; plan a mission with at least one target", {}};
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
    mission::RouteWaypoint& waypoint = route.waypoints[i];
    waypoint.name = names[i];
    waypoint.place = places[i];
    waypoint.altitude = altitudes[k];
    waypoint.target = corners[i].target;
    waypoint.turnRadius = corners[i].radius;
    waypoint.turn_deg = Angle::radians(path.turned[i]).degrees();
    waypoint.distance = knots.distance[k];
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
  result.holds.clear();
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
  const auto add = [&](const std::vector<mission::DecisionPoint>& points) {
    for (const mission::DecisionPoint& point : points) {
      box.add(point.pose.point());
      if (point.witness.site >= 0) {
        const mission::SiteInFrame& site = plan.sites[static_cast<std::size_t>(point.witness.site)];
        box.add(site.pose.point());
        box.add(landing::gateOf(plan.mission.approach, site).point());
      }
    }
  };
  add(plan.tour);
  for (const std::optional<mission::HomePath>* path : {&plan.departure, &plan.arrival}) {
    if (*path) {
      add((*path)->points);
    }
  }
  box = box.grown(kMargin);
  const geo::Box extent = terrain->extent();
  Ground ground;
  ground.world = landing::worldOf(plan.mission, plan.sites, terrain::TerrainPyramid(std::move(terrain)));
  landing::RoadmapRequest request;
  request.area = {std::max(box.minX, extent.minX), std::max(box.minY, extent.minY), std::min(box.maxX, extent.maxX), std::min(box.maxY, extent.maxY)};
  auto built = landing::buildRoadmap(ground.world, plan.mission.planner, request, job);
  if (!built) {
    return forward(built);
  }
  ground.roadmap = std::move(*built);
  return ground;
}

namespace {

/// Altitudes of the closed tour's waypoints by knot, and the ways from and to home that fit them.
struct Fitted {
  std::vector<double> altitudes;
  std::optional<HomeRoute> home;
};

std::vector<double> byCorner(const Knots& knots, const std::vector<double>& altitudes) {
  std::vector<double> result(altitudes.size());
  for (std::size_t k = 0; k < altitudes.size(); ++k) {
    result[knots.corner[k]] = altitudes[k];
  }
  return result;
}

/// Whether the indices of a way are those of the plan; what else is wrong with it the checker finds.
bool fits(const mission::Plan& plan, const mission::HomePath& path) {
  const auto inside = [](int index, std::size_t size) { return index >= 0 && static_cast<std::size_t>(index) < size; };
  return path.points.size() >= 2 && inside(path.site, plan.sites.size()) && inside(path.join, plan.tour.size()) &&
         inside(path.guaranteed, path.points.size());
}

/// Ways and closed tour ask for each other's altitudes until both are high enough; whole feet may cost the climb-out another circle.
Result<Fitted> fitAltitudes(const mission::Plan& plan, const Ground* ground, const Layout& layout, const FlownPoints& flown,
                            const RouteOptions& options, const Job& job) {
  constexpr int kMostRounds = 8;
  constexpr int kMostCircles = 2;
  const Pitch pitch = pitchOf(plan);
  std::vector<Required> required = layout.comparison.required;
  for (std::size_t i = 0; i < flown.points.size(); ++i) {
    required.push_back({flown.distance[i], flown.lowest[i]});
  }
  Fitted fitted;
  fitted.altitudes = waypointAltitudes(layout.knots.distance, layout.path.length, required, pitch);
  if (!plan.departure || !plan.arrival) {
    return fitted;
  }
  if (!fits(plan, *plan.departure) || !fits(plan, *plan.arrival)) {
    return fail(Errc::OutOfRange, "the ways from and to the home runway do not fit the plan; plan the mission again");
  }
  for (int circles = 0; circles <= kMostCircles; ++circles) {
    Result<HomeRoute> home = HomeRoute::layOut(plan, ground, layout, flown, options, circles, job);
    if (!home) {
      return forward(home);
    }
    std::vector<Required> all = required;
    std::vector<double> altitudes = fitted.altitudes;
    std::vector<Required> raised = home->fit(byCorner(layout.knots, altitudes));
    for (int round = 0; round < kMostRounds && !raised.empty(); ++round) {
      all.insert(all.end(), raised.begin(), raised.end());
      altitudes = waypointAltitudes(layout.knots.distance, layout.path.length, all, pitch);
      raised = home->fit(byCorner(layout.knots, altitudes));
    }
    const bool isKept = home->keepsItsPromise();
    if (isKept || circles == kMostCircles) {
      return Fitted{std::move(altitudes), std::move(*home)};
    }
  }
  return fitted;
}

}  // namespace

Result<BuiltRoute> buildRoute(const mission::Plan& plan, const Ground* ground, const RouteOptions& options, const Job& job) {
  if (plan.tour.empty()) {
    return tl::unexpected(noTour());
  }
  const geo::LocalFrame frame(plan.frameOrigin);
  const Track tour = trackOfTour(plan, firstVisit(plan));
  Result<Layout> layout = bestLayout(plan, frame, tour, ground != nullptr ? &ground->world : nullptr, options);
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

  std::vector<double> marks = knots.distance;
  std::copy_if(visits.begin(), visits.end(), std::back_inserter(marks), [](double at) { return at >= 0.0; });
  Result<FlownPoints> flown = flownPoints(plan, ground != nullptr ? &ground->world : nullptr, ground != nullptr ? ground->roadmap.get() : nullptr,
                                          path, std::move(marks), job);
  if (!flown) {
    return forward(flown);
  }
  const Result<Fitted> fitted = fitAltitudes(plan, ground, *layout, *flown, options, job);
  if (!fitted) {
    return forward(fitted);
  }
  const std::vector<double>& altitudes = fitted->altitudes;
  for (std::size_t i = 0; i < flown->points.size(); ++i) {
    flown->points[i].altitude = altitudeBetween(knots.distance, altitudes, path.length, flown->distance[i]);
  }
  route.above = overTour(tour, *flown, path.passed.front());
  fillWaypoints(plan, corners, layout->places, path, knots, altitudes, route);
  fillFlown(frame, layout->track, knots, altitudes, knots.distance[(corners.size() - path.first) % corners.size()], route);
  built.reflown = reflownPlan(plan, std::move(*flown), corners, visits);
  if (fitted->home) {
    fitted->home->addTo(byCorner(knots, altitudes), built);
  }
  if (ground != nullptr) {
    landing::setHolds(ground->world, built.reflown);
  }
  return built;
}

}  // namespace vp::route
