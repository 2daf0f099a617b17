#include "core/emergency/best_descent.h"

#include "core/emergency/landing_outcome.h"
#include "core/risk/leg_risk.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::emergency {
namespace {

/// Height over the gate that the pilot loses in passing, by a slip or flaps on the approach [m]; more is a worse way than any without.
constexpr double kUsualSurplus = 15.0;

}  // namespace

double BestDescent::riskAlong(geo::Pose& pose, double& altitude, const Pieces& pieces, double share) {
  double risk = 0.0;
  for (const flight::Piece& piece : pieces) {
    const geo::Pose before = pose;
    const double high = altitude;
    altitude = flight_->fly(pose, high, piece, share, nullptr);
    if (altitude == DescentFlight::kNoGlide) {
      return std::numeric_limits<double>::infinity();
    }
    risk += request_->risk != nullptr ? request_->risk->of(before, piece, high, altitude) : 0.0;
  }
  return risk;
}

bool BestDescent::offer(const Pieces& pieces) {
  ++offered_;
  std::optional<Descent> descent = flight_->descendTo(request_->pose, request_->altitude, pieces, approach_->altitude);
  if (!descent) {
    return false;
  }
  const double surplus = std::max(0.0, descent->surplus - kUsualSurplus);
  if (surplus > surplus_ + 1.0) {
    return false;
  }
  mission::LandingPath way{request_->pose, request_->altitude, descent->legs, approach_->site};
  const double cost = request_->risk != nullptr ? riskOf(*request_, way) : std::abs(descent->share - 0.5);
  const bool isHigher = surplus < surplus_ - 1.0;
  if (!isHigher && !(cost < risk_)) {
    return false;
  }
  if (!flight_->isClear(request_->pose, request_->altitude, descent->legs)) {
    return false;
  }
  std::optional<mission::LandingPath> path = withApproach(*request_, *approach_, std::move(descent->legs), approach_->altitude + descent->surplus);
  if (!path) {
    return false;
  }
  path_ = std::move(path);
  risk_ = cost;
  surplus_ = surplus;
  return true;
}

}  // namespace vp::emergency
