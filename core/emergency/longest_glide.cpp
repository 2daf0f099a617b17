#include "core/emergency/longest_glide.h"

#include "core/base/quantity.h"
#include "core/emergency/glide_flight.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vp::emergency {
namespace {

constexpr int kCourses = 72;
/// Of a glide's end [m]: some ten seconds' flight decide nothing.
constexpr double kAccuracy = 10.0;

/// Straight on for as far as it keeps clear, at most `most`. @return the length, to kAccuracy
double straightReach(const GlideFlight& flight, const geo::Pose& from, double altitude, double most) {
  const auto isClear = [&](double length) {
    geo::Pose pose = from;
    return flight.fly(pose, altitude, {{flight::Turn::Straight, 0.0, length}}, nullptr) > GlideFlight::kTouches;
  };
  double clear = 0.0;
  double touches = most;
  if (isClear(most)) {
    return most;
  }
  while (touches - clear > kAccuracy) {
    const double middle = 0.5 * (clear + touches);
    (isClear(middle) ? clear : touches) = middle;
  }
  return clear;
}

}  // namespace

std::optional<mission::LandingPath> longestGlide(const LandingRequest& request, const Countdown& countdown) {
  const landing::World& world = *request.world;
  const GlideFlight flight(world);
  const geo::Box extent = world.terrain.grid().extent();
  // no glide is longer than its height lasts, and no straight one within the map than its diagonal
  const double diagonal = std::hypot(extent.maxX - extent.minX, extent.maxY - extent.minY);
  double farthest = 0.0;
  std::vector<flight::Piece> best;
  const auto tryAfter = [&](const std::vector<flight::Piece>& turn) {
    geo::Pose pose = request.pose;
    const double altitude = flight.fly(pose, request.altitude, turn, nullptr);
    if (altitude <= GlideFlight::kTouches) {
      return false;
    }
    const double straight = straightReach(flight, pose, altitude, diagonal);
    const geo::Point end{pose.x + straight * std::cos(pose.heading), pose.y + straight * std::sin(pose.heading)};
    if (const double far = geo::distance(request.pose.point(), end); straight > 0.0 && far > farthest) {
      farthest = far;
      best = turn;
      best.push_back({flight::Turn::Straight, 0.0, straight});
    }
    return true;
  };
  tryAfter({});
  for (const double radius : world.glide.glideRadii()) {
    for (const flight::Turn side : {flight::Turn::Left, flight::Turn::Right}) {
      for (int i = 1; i < kCourses; ++i) {
        const double length = radius * 2.0 * Angle::kPi * i / kCourses;
        // time spent here is some milliseconds beyond the deadline at most; an answer is worth more than none
        if ((countdown.isOver() && !best.empty()) || !tryAfter({{side, radius, length}})) {
          break;
        }
      }
    }
  }
  if (best.empty()) {
    return std::nullopt;
  }
  mission::LandingPath path{request.pose, request.altitude, {}, -1};
  geo::Pose pose = request.pose;
  return flight.fly(pose, request.altitude, best, &path.legs) > GlideFlight::kTouches ? std::optional(path) : std::nullopt;
}

}  // namespace vp::emergency
