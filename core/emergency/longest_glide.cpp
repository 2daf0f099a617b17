#include "core/emergency/longest_glide.h"

#include "core/base/quantity.h"
#include "core/emergency/glide_flight.h"
#include "core/emergency/landing_outcome.h"
#include "core/flight/curve_sampling.h"
#include "core/risk/leg_risk.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace vp::emergency {
namespace {

constexpr int kCourses = 72;
/// Of a glide's end [m]: some ten seconds' flight decide nothing.
constexpr double kAccuracy = 10.0;
/// Of the farthest: with a risk, glides that end nearer are none of least risk, they are only over sooner.
constexpr double kFarEnough = 0.5;

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

/** The glides tried, and the one to take: without a risk the farthest; with one that of least risk among those that get far enough. */
class Choice {
public:
  Choice(const LandingRequest& request, const GlideFlight& flight) : request_(request), flight_(flight) {}

  [[nodiscard]] bool isEmpty() const { return tried_.empty(); }
  void add(std::vector<flight::Piece> pieces, double far) { tried_.push_back({std::move(pieces), far}); }

  [[nodiscard]] std::optional<mission::LandingPath> best() const {
    const auto farthest = std::max_element(tried_.begin(), tried_.end(), [](const Tried& a, const Tried& b) { return a.far < b.far; });
    if (farthest == tried_.end()) {
      return std::nullopt;
    }
    std::optional<mission::LandingPath> best = pathOf(farthest->pieces);
    if (request_.risk == nullptr || !best) {
      return best;
    }
    double least = riskOf(*best);
    for (const Tried& tried : tried_) {
      if (tried.far < kFarEnough * farthest->far) {
        continue;
      }
      std::optional<mission::LandingPath> path = pathOf(tried.pieces);
      if (const double risk = path ? riskOf(*path) : least; risk < least) {
        least = risk;
        best = std::move(path);
      }
    }
    return best;
  }

private:
  struct Tried {
    std::vector<flight::Piece> pieces;
    double far = 0.0;  // m, from where it begins to where it ends
  };

  [[nodiscard]] std::optional<mission::LandingPath> pathOf(const std::vector<flight::Piece>& pieces) const {
    mission::LandingPath path{request_.pose, request_.altitude, {}, -1};
    geo::Pose pose = request_.pose;
    return flight_.fly(pose, request_.altitude, pieces, &path.legs) > GlideFlight::kTouches ? std::optional(path) : std::nullopt;
  }

  /// Of the path and of what comes behind its end: straight on down to the ground.
  [[nodiscard]] double riskOf(const mission::LandingPath& path) const {
    double risk = emergency::riskOf(request_, path);
    geo::Pose end = path.start;
    for (const mission::LandingLeg& leg : path.legs) {
      end = flight::endOf(end, leg.piece);
    }
    const double altitude = path.legs.empty() ? path.altitude : path.legs.back().endAltitude;
    const double clearance = request_.world->clearance;
    const double loss = request_.world->glide.lossOver(std::cos(end.heading), std::sin(end.heading));
    const flight::Piece onward{flight::Turn::Straight, 0.0, clearance / loss};
    if (std::isfinite(loss) && clearance > 0.0) {
      risk += request_.risk->of(end, onward, altitude, altitude - clearance);
    }
    return risk;
  }

  const LandingRequest& request_;
  const GlideFlight& flight_;
  std::vector<Tried> tried_;
};

}  // namespace

std::optional<mission::LandingPath> longestGlide(const LandingRequest& request, const Countdown& countdown) {
  const landing::World& world = *request.world;
  const GlideFlight flight(world);
  const geo::Box extent = world.terrain.grid().extent();
  // no glide is longer than its height lasts, and no straight one within the map than its diagonal
  const double diagonal = std::hypot(extent.maxX - extent.minX, extent.maxY - extent.minY);
  Choice choice(request, flight);
  const auto tryAfter = [&](std::vector<flight::Piece> pieces) {
    geo::Pose pose = request.pose;
    const double altitude = flight.fly(pose, request.altitude, pieces, nullptr);
    if (altitude <= GlideFlight::kTouches) {
      return false;
    }
    if (const double straight = straightReach(flight, pose, altitude, diagonal); straight > 0.0) {
      const geo::Point end{pose.x + straight * std::cos(pose.heading), pose.y + straight * std::sin(pose.heading)};
      pieces.push_back({flight::Turn::Straight, 0.0, straight});
      choice.add(std::move(pieces), geo::distance(request.pose.point(), end));
    }
    return true;
  };
  tryAfter({});
  for (const double radius : world.glide.glideRadii()) {
    for (const flight::Turn side : {flight::Turn::Left, flight::Turn::Right}) {
      for (int i = 1; i < kCourses; ++i) {
        const double length = radius * 2.0 * Angle::kPi * i / kCourses;
        // time spent here is some milliseconds beyond the deadline at most; an answer is worth more than none
        if ((countdown.isOver() && !choice.isEmpty()) || !tryAfter({{side, radius, length}})) {
          break;
        }
      }
    }
  }
  return choice.best();
}

}  // namespace vp::emergency
