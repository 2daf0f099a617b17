#include "core/emergency/landing_goals.h"

#include "core/base/quantity.h"
#include "core/emergency/glide_flight.h"
#include "core/flight/piece_loss.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vp::emergency {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Height that a radian of a turn costs at least beyond the straight flight of the same length [m], over all radii and bands.
double turnExcess(const aircraft::GlideModel& glide) {
  double least = kInfinite;
  for (std::size_t i = 0; i < glide.glideRadii().size(); ++i) {
    for (const flight::TurnLoss& loss : flight::bandLossesOf(glide, i)) {
      const double excess = loss.byCourse == nullptr ? loss.turn - loss.straight : loss.byCourse->leastExcess();
      least = std::min(least, excess * glide.glideRadii()[i]);
    }
  }
  return std::isfinite(least) ? std::max(0.0, least) : 0.0;
}

}  // namespace

LandingGoals::LandingGoals(const landing::World& world, const geo::Pose& from, double altitude, std::optional<int> onlySite)
    : world_(&world), turnPerRadian_(turnExcess(world.glide)) {
  double closest = kInfinite;
  std::size_t closestSite = 0;
  for (std::size_t i = 0; i < world.sites.size(); ++i) {
    if (onlySite && *onlySite != static_cast<int>(i)) {
      continue;
    }
    const mission::SiteInFrame& site = world.sites[i];
    // every approach begins no lower than this; what it takes to know it exactly is spent on those that may be in range
    const double loss = leastLoss(from, landing::gateOf(world.approach, site));
    double least = site.site.elevation.metres() + world.arrivalMargin + loss;
    if (least <= altitude) {
      Result<landing::Approach> approach = approachInLegs(world, i);
      if (!approach) {
        continue;
      }
      least = approach->altitude + loss;
      if (least <= altitude) {
        goals_.push_back({std::move(*approach), least});
      }
    }
    if (least < closest) {
      closest = least;
      closestSite = i;
    }
  }
  std::stable_sort(goals_.begin(), goals_.end(), [](const LandingGoal& a, const LandingGoal& b) { return a.least < b.least; });
  if (!goals_.empty()) {
    lowestGate_ = kInfinite;
    for (const LandingGoal& goal : goals_) {
      lowestGate_ = std::min(lowestGate_, goal.approach.altitude);
    }
  } else if (std::isfinite(closest)) {
    const mission::SiteInFrame& site = world.sites[closestSite];
    missing_ = closest - altitude;
    whyNone_ = fmt::format(
        "No runway is in range: the closest is {}, {:.1f} km away, and even straight there the glide would have to begin {:.0f} m higher.",
        site.site.id, 1e-3 * geo::distance(from.point(), site.pose.point()), std::ceil(missing_));
  } else {
    whyNone_ = landing::noApproach(world).what;
    whyNone_ = fmt::format("No runway can be landed on: {}.", whyNone_);
  }
}

double LandingGoals::leastLoss(const geo::Pose& from, const geo::Pose& to) const {
  return world_->glide.leastLossOver(to.x - from.x, to.y - from.y) + turnPerRadian_ * std::abs(wrapPi(to.heading - from.heading));
}

double LandingGoals::leastFrom(const geo::Pose& from) const {
  double least = kInfinite;
  for (const LandingGoal& goal : goals_) {
    least = std::min(least, goal.approach.altitude + leastLoss(from, goal.approach.gate));
  }
  return least;
}

}  // namespace vp::emergency
