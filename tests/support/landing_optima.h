#pragma once
// Landing problems whose least loss is known in closed form or by an exhaustive search: what planners of emergency landings are held against.

#include "core/flight/piece_loss.h"
#include "core/landing/required_height.h"
#include "tests/support/landing_cases.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::test {

/** Altitude lost by the best single curve over flat ground, all radii [m]. */
inline double closedForm(const landing::World& world, const geo::Pose& from, const geo::Pose& to) {
  double least = std::numeric_limits<double>::infinity();
  for (const double radius : world.glide.glideRadii()) {
    const flight::TurnLoss loss = flight::turnLossOf(world.glide, radius);
    for (const flight::Word word : flight::kWords) {
      if (const auto path = flight::dubinsWord(from, to, radius, word)) {
        least = std::min(least, flight::lossOf(*path, loss));
      }
    }
  }
  return least;
}

/** Least loss [m] by two curves through a pose within the gap of a wall at x = 0: poses every 10 m and 3 degrees. */
inline double bestThroughGap(const emergency::LandingRequest& request, const landing::Approach& approach, double south, double north) {
  const landing::World& world = *request.world;
  const double radius = world.glide.glideRadii().front();
  const flight::TurnLoss loss = flight::turnLossOf(world.glide, radius);
  double best = std::numeric_limits<double>::infinity();
  for (double y = south; y <= north; y += 10.0) {
    for (int degrees = -90; degrees <= 90; degrees += 3) {
      const geo::Pose middle{0.0, y, Angle::degrees(degrees).radians()};
      const flight::DubinsPath second = flight::leastLossDubins(middle, approach.gate, radius, loss);
      const double half = landing::requiredStartHeight(world, second, loss, approach.altitude);
      const flight::DubinsPath first = flight::leastLossDubins(request.pose, middle, radius, loss);
      best = std::min(best, std::isfinite(half) ? landing::requiredStartHeight(world, first, loss, half) : half);
    }
  }
  return best - approach.altitude;
}

}  // namespace vp::test
