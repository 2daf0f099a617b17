// Where the waypoints of the closed tour lie, and how the path that they give compares with the tour.
#include "core/route/layout.h"

#include "core/flight/curve_sampling.h"
#include "core/landing/required_height.h"
#include "core/route/keep_out.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::route {
namespace {

double rounded(double degrees, double steps, double shift) {
  return std::round(degrees * steps + shift) / steps;
}

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

/// @param tourStart, flownStart  m along each where following it begins
Comparison comparePaths(const Track& tour, double tourStart, const Track& flown, double flownStart, const std::vector<double>& marks) {
  Comparison result;
  Follower onFlown(flown, flownStart);
  for (std::size_t i = 0; i < tour.points.size(); ++i) {
    const Beside at = onFlown.next(tour.points[i]);
    result.required.push_back({at.distance, tour.altitude[i] + kMatchError});
    result.lateral = std::max(result.lateral, at.aside);
  }
  Follower onTour(tour, tourStart);
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

Result<Layout> layOut(const mission::Plan& plan, const geo::LocalFrame& frame, const Track& tour, double steps, const CornerLimits& limits,
                      double leastLeg, Shift shift) {
  Layout layout;
  layout.corners = tangentCorners(plan, limits);
  roundPlaces(frame, steps, leastLeg, layout.corners, layout.places, shift);
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

}  // namespace

void roundPlaces(const geo::LocalFrame& frame, double steps, double leastLeg, std::vector<Corner>& corners, std::vector<geo::LatLon>& places,
                 Shift shift) {
  std::vector<Corner> kept;
  for (Corner corner : corners) {
    const geo::LatLon exact = frame.toLatLon(corner.point);
    const geo::LatLon place{rounded(exact.latitude_deg, steps, shift.north), rounded(exact.longitude_deg, steps, shift.east)};
    corner.point = frame.toPoint(place);
    if (!kept.empty() && corner.target < 0 && geo::distance(corner.point, kept.back().point) < leastLeg) {
      continue;
    }
    kept.push_back(corner);
    places.push_back(place);
  }
  corners = std::move(kept);
}

Comparison compare(const Track& tour, const Track& flown, const std::vector<double>& marks, double start) {
  return comparePaths(tour, tour.length() - start, flown, start, marks);
}

Comparison compareWays(const Track& way, const Track& flown, const std::vector<double>& marks) {
  return comparePaths(way, 0.0, flown, 0.0, marks);
}

namespace {

/// Whether a path comes over ground whose height is not known, for which there is no glide.
bool isOverUnknown(const landing::World& world, const FlownPath& path) {
  geo::Pose pose = path.start;
  for (const flight::Piece& piece : path.pieces) {
    if (!std::isfinite(landing::maxTerrainAlong(world.terrain, pose, piece))) {
      return true;
    }
    pose = flight::endOf(pose, piece);
  }
  return false;
}

/// The best layout so far; staying out of forbidden airspace and off unknown ground goes first, then nearness to the tour.
struct Choice {
  std::optional<Layout> layout;
  bool isInside = false;
  double worst = 0.0;  ///< m
  Error error;

  void offer(Result<Layout> made, const KeepOut& keepOut, const landing::World* world) {
    if (!made) {
      error = made.error();
      return;
    }
    const bool inside = keepOut.isEnteredBy(made->track) || (world != nullptr && isOverUnknown(*world, made->path));
    const double aside = std::max(made->route.lateral, 2.0 * made->route.visit);
    if (!layout || std::pair(inside, aside) < std::pair(isInside, worst)) {
      layout = std::move(*made);
      isInside = inside;
      worst = aside;
    }
  }
  [[nodiscard]] bool isGood(double lateral) const { return layout && !isInside && worst <= lateral; }
};

}  // namespace

Result<Layout> bestLayout(const mission::Plan& plan, const geo::LocalFrame& frame, const Track& tour, const landing::World* world,
                          const RouteOptions& options) {
  const KeepOut keepOut(plan, tour);
  Choice best;
  for (const Shift& shift : kShifts) {
    for (const double leastLeg : kLeastLegs) {
      for (const double liberty : kLiberties) {
        CornerLimits limits = options.limits;
        limits.beside *= liberty;
        limits.lateral *= liberty;
        best.offer(layOut(plan, frame, tour, options.stepsPerDegree, limits, leastLeg, shift), keepOut, world);
        if (best.isGood(options.lateral)) {
          return std::move(*best.layout);
        }
      }
    }
    if (!best.layout || !best.isInside) {
      break;  // another rounding is for airspace and unknown ground alone
    }
  }
  return best.layout ? Result<Layout>(std::move(*best.layout)) : tl::unexpected(best.error);
}

}  // namespace vp::route
