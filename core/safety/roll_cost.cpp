#include "core/safety/roll_cost.h"

#include "core/safety/limits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::safety {
namespace {

bool isFlown(const flight::Piece& piece) {
  return piece.length > kSpacingTolerance;
}

}  // namespace

RollCost::RollCost(const PlanConditions& conditions, const aircraft::AircraftProfile& profile, const GlideRates& rates)
    : rate_(Angle::degrees(*profile.rollRate_dps).radians()), airspeed_(conditions.glide.most) {
  const WindGlide fastest(profile, conditions, airspeed_, rates.shear());
  levelSine_ = std::max(fastest.straightSine(), fastest.sinkSine(0.0, 0.0, std::numeric_limits<double>::infinity()));
  inducedSine_ = fastest.inducedSine();
  const auto bankOf = [&](double airspeed) {
    return (airspeed + rates.winds().strongest()) * (airspeed + rates.winds().strongest()) / kGravity.si();
  };
  glideBank_ = bankOf(airspeed_);
  const double slowest = std::max(0.0, conditions.glide.least - rates.winds().strongest());
  leastBank_ = std::min(glideBank_, slowest * slowest / kGravity.si());
  tourBank_ = bankOf(std::max(airspeed_, conditions.tour.most));
}

double RollCost::costOf(double angle, double tangent) const {
  return angle / rate_ * airspeed_ * std::min(1.0, levelSine_ + inducedSine_ * tangent * tangent);
}

/// In a wind that asks for the tangent c/R of a bank. To the other side both banks count, greatest where c is; to the same side the difference of the
/// two is greatest where c is nearest to the mean of the radii.
double RollCost::between(const flight::Piece& before, const flight::Piece& after) const {
  const bool wasTurning = before.turn != flight::Turn::Straight;
  const bool isTurning = after.turn != flight::Turn::Straight;
  if (!wasTurning || !isTurning) {
    const double radius = wasTurning ? before.radius : after.radius;
    return wasTurning || isTurning ? costOf(std::atan(glideBank_ / radius), glideBank_ / radius) : 0.0;
  }
  const double tangent = glideBank_ / std::min(before.radius, after.radius);
  if (before.turn != after.turn) {
    return costOf(std::atan(glideBank_ / before.radius) + std::atan(glideBank_ / after.radius), tangent);
  }
  const double bank = std::clamp(std::sqrt(before.radius * after.radius), leastBank_, glideBank_);
  return costOf(std::abs(std::atan(bank / before.radius) - std::atan(bank / after.radius)), tangent);
}

double RollCost::afterTour(const flight::Piece& tour, const flight::Piece& first) const {
  if (tour.turn == flight::Turn::Straight) {
    return between(tour, first);
  }
  const double most = std::atan(tourBank_ / tour.radius);
  if (first.turn == flight::Turn::Straight) {
    return costOf(most, tourBank_ / tour.radius);
  }
  const double tangent = std::max(tourBank_ / tour.radius, glideBank_ / first.radius);
  if (first.turn != tour.turn) {
    return costOf(most + std::atan(glideBank_ / first.radius), tangent);
  }
  const bool isSame = std::abs(first.radius - tour.radius) <= kRadiusTolerance * tour.radius;
  return isSame ? 0.0 : costOf(std::max(most, std::atan(glideBank_ / first.radius)), tangent);  // either may be the steeper
}

std::vector<double> RollCost::along(const std::optional<flight::Piece>& tour, const std::vector<flight::Piece>& pieces) const {
  std::vector<double> costs;
  double sum = 0.0;
  const flight::Piece* before = nullptr;
  for (const flight::Piece& piece : pieces) {
    if (isFlown(piece)) {
      sum += before != nullptr ? between(*before, piece) : afterTour(tour.value_or(flight::Piece()), piece);
      before = &piece;
    }
    costs.push_back(sum);
  }
  if (before != nullptr && before->turn != flight::Turn::Straight) {
    const double level = between(*before, {});
    for (std::size_t i = static_cast<std::size_t>(before - pieces.data()); i < costs.size(); ++i) {
      costs[i] += level;
    }
  }
  return costs;
}

}  // namespace vp::safety
