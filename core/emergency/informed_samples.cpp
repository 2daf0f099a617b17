#include "core/emergency/informed_samples.h"

#include "core/base/quantity.h"

#include <algorithm>
#include <cmath>

namespace vp::emergency {
namespace {

/// Samples along the way turn off it by up to this [rad].
constexpr double kOffWay = 0.25 * Angle::kPi;
/// An ellipse is at least this wide, so that one whose axis is used up still has an area [m].
constexpr double kLeastWidth = 1.0;

}  // namespace

InformedSamples::InformedSamples(const landing::World& world, const LandingGoals& goals, const geo::Pose& start, double altitude, std::uint64_t seed)
    : goals_(goals), start_(start), altitude_(altitude), leastLoss_(world.glide.leastLoss()), extent_(world.terrain.grid().extent()), engine_(seed) {
  narrow(0.0);
}

void InformedSamples::narrow(double heightInHand) {
  ellipses_.clear();
  double sum = 0.0;
  for (std::size_t i = 0; i < goals_.inRange().size(); ++i) {
    const LandingGoal& goal = goals_.inRange()[i];
    if (goal.least + heightInHand >= altitude_) {
      break;  // and so are all that follow
    }
    const geo::Pose& gate = goal.approach.gate;
    const double most = (altitude_ - goal.approach.altitude - heightInHand) / leastLoss_;
    const double apart = geo::distance(start_.point(), gate.point());
    Ellipse ellipse;
    ellipse.goal = i;
    ellipse.centre = {0.5 * (start_.x + gate.x), 0.5 * (start_.y + gate.y)};
    ellipse.longAxis = 0.5 * std::max(most, apart);
    ellipse.shortAxis = std::max(kLeastWidth, 0.5 * std::sqrt(std::max(0.0, most * most - apart * apart)));
    if (apart > 0.0) {
      ellipse.east = (gate.x - start_.x) / apart;
      ellipse.north = (gate.y - start_.y) / apart;
    }
    // the part of the ellipse's box that lies on the terrain stands for how much of the ellipse does
    const double reachX = std::hypot(ellipse.longAxis * ellipse.east, ellipse.shortAxis * ellipse.north);
    const double reachY = std::hypot(ellipse.longAxis * ellipse.north, ellipse.shortAxis * ellipse.east);
    const double insideX = std::min(extent_.maxX, ellipse.centre.x + reachX) - std::max(extent_.minX, ellipse.centre.x - reachX);
    const double insideY = std::min(extent_.maxY, ellipse.centre.y + reachY) - std::max(extent_.minY, ellipse.centre.y - reachY);
    sum += 0.25 * Angle::kPi * std::max(kLeastWidth, insideX) * std::max(kLeastWidth, insideY) * ellipse.shortAxis * ellipse.longAxis /
           (reachX * reachY);
    ellipse.sum = sum;
    ellipses_.push_back(ellipse);
  }
  area_ = std::min(sum, (extent_.maxX - extent_.minX) * (extent_.maxY - extent_.minY));
}

geo::Pose InformedSamples::next() {
  const double chosen = unit() * ellipses_.back().sum;
  const auto found = std::find_if(ellipses_.begin(), ellipses_.end(), [chosen](const Ellipse& one) { return chosen < one.sum; });
  const Ellipse& ellipse = found == ellipses_.end() ? ellipses_.back() : *found;
  geo::Pose pose;
  constexpr int kTries = 20;  // an ellipse may reach far beyond the map
  for (int i = 0; i < kTries; ++i) {
    const double radius = std::sqrt(unit());
    const double angle = 2.0 * Angle::kPi * unit();
    const double along = ellipse.longAxis * radius * std::cos(angle);
    const double across = ellipse.shortAxis * radius * std::sin(angle);
    pose.x = ellipse.centre.x + along * ellipse.east - across * ellipse.north;
    pose.y = ellipse.centre.y + along * ellipse.north + across * ellipse.east;
    if (extent_.contains(pose.point())) {
      break;
    }
  }
  const double kind = unit();
  const double off = (2.0 * unit() - 1.0);
  const geo::Pose& gate = goals_.inRange()[ellipse.goal].approach.gate;
  if (kind < 0.25) {
    pose.heading = std::atan2(gate.y - pose.y, gate.x - pose.x) + kOffWay * off;
  } else if (kind < 0.5) {
    pose.heading = std::atan2(pose.y - start_.y, pose.x - start_.x) + kOffWay * off;
  } else {
    pose.heading = Angle::kPi * off;
  }
  return pose;
}

geo::Pose InformedSamples::near(const geo::Pose& pose, double reach) {
  constexpr double kTurnReach = 1000.0;  // m: from here on headings are turned by up to half a circle
  const double radius = reach * std::sqrt(unit());
  const double angle = 2.0 * Angle::kPi * unit();
  const double turned = Angle::kPi * std::min(1.0, reach / kTurnReach) * (2.0 * unit() - 1.0);
  return {pose.x + radius * std::cos(angle), pose.y + radius * std::sin(angle), pose.heading + turned};
}

}  // namespace vp::emergency
