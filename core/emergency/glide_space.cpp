#include "core/emergency/glide_space.h"

#include "core/aircraft/glide_bands.h"
#include "core/base/quantity.h"
#include "core/landing/line_height.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::emergency {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::vector<Point3> allPoints(const LandingRequest& request, const LandingGoals& goals, const std::vector<geo::Point>& points) {
  std::vector<Point3> all{{request.pose.x, request.pose.y, 0.0}};
  for (const LandingGoal& goal : goals.inRange()) {
    all.push_back({goal.approach.gate.x, goal.approach.gate.y, 0.0});
  }
  for (const geo::Point& point : points) {
    all.push_back({point.x, point.y, 0.0});
  }
  return all;
}

double turned(double from, double to) {
  return std::abs(wrapPi(to - from));
}

}  // namespace

GlideSpace::GlideSpace(const LandingRequest& request, const LandingGoals& goals, const std::vector<geo::Point>& points, double radius,
                       const LinearOctree* octree, double wanted)
    : request_(request),
      world_(*request.world),
      goals_(goals),
      points_(allPoints(request, goals, points)),
      buckets_(points_, radius),
      octree_(octree),
      gates_(static_cast<int>(goals.inRange().size())),
      turn_(goals.leastLoss({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0})) {
  for (const Point3& p : points_) {
    double least = kInfinite;
    for (const LandingGoal& goal : goals.inRange()) {
      const geo::Pose& gate = goal.approach.gate;
      least = std::min(least, goal.approach.altitude + world_.glide.leastLossOver(gate.x - p.x, gate.y - p.y));
    }
    least_.push_back(least + wanted);
  }
}

double GlideSpace::gateExtra(int node) const {
  return isGoal(node) ? goals_.inRange()[goalOf(node)].approach.altitude - goals_.lowestGate() : 0.0;
}

double GlideSpace::arrival(int parent, int from, double cost, int to) const {
  const geo::Point a = at(from);
  const geo::Point b = at(to);
  const double altitude = request_.altitude - cost;
  const aircraft::GlideBands* const bands = world_.glide.bands();
  const std::size_t band = bands == nullptr ? 0 : bands->below(altitude);
  const aircraft::GlideModel& model = bands == nullptr ? world_.glide : bands->between(band, band);
  double loss = model.lossOver(b.x - a.x, b.y - a.y);
  // without the turns first: most legs are out of reach already
  if (!(altitude - loss >= least_[static_cast<std::size_t>(to)])) {
    return kInfinite;
  }
  const double course = std::atan2(b.y - a.y, b.x - a.x);
  double before = request_.pose.heading;
  if (parent >= 0) {
    const geo::Point c = at(parent);
    before = std::atan2(a.y - c.y, a.x - c.x);
  }
  loss += turn_ * turned(before, course);
  if (isGoal(to)) {
    loss += turn_ * turned(course, goals_.inRange()[goalOf(to)].approach.gate.heading);
    if (altitude - loss < goals_.inRange()[goalOf(to)].approach.altitude) {
      return kInfinite;
    }
  }
  return altitude - loss >= least_[static_cast<std::size_t>(to)] ? cost + loss + gateExtra(to) : kInfinite;
}

bool GlideSpace::isFree(int from, double cost, int to, double arrival) const {
  const geo::Point a = at(from);
  const geo::Point b = at(to);
  const double altitude = request_.altitude - cost;
  const double end = request_.altitude - (arrival - gateExtra(to));
  if (octree_ == nullptr) {
    return isFreeBySteps(a, altitude, b, end);
  }
  if (from != 0 && !isGoal(to)) {
    return octree_->isFree({a.x, a.y, altitude}, {b.x, b.y, end});
  }
  // aircraft and gates are where they are, even if the cells around them are blocked by ground that is near
  const double length = geo::distance(a, b);
  const double rate = length > 0.0 ? (altitude - end) / length : 0.0;
  constexpr double kRounding = 1e-6;  // m
  return landing::requiredAlongLine(world_.terrain, a, b, rate, world_.clearance, end, altitude) <= altitude + kRounding;
}

/// The usual test; it may step over a corner of a cell, which the check of the curves will see.
bool GlideSpace::isFreeBySteps(geo::Point from, double altitude, geo::Point to, double end) const {
  const terrain::ElevationGrid& grid = world_.terrain.grid();
  const int steps = std::max(1, static_cast<int>(std::ceil(geo::distance(from, to) / (0.5 * grid.cellSize()))));
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const double x = from.x + share * (to.x - from.x);
    const double y = from.y + share * (to.y - from.y);
    if (altitude + share * (end - altitude) < static_cast<double>(grid.upperInCell(grid.columnOf(x), grid.rowOf(y))) + world_.clearance) {
      return false;
    }
  }
  return true;
}

}  // namespace vp::emergency
