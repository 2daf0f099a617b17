#include "core/emergency/gradient_cost.h"

#include "core/base/quantity.h"

#include <algorithm>
#include <cmath>

namespace vp::emergency {

GradientCost::GradientCost(const GradientTask& task, const GradientOptions& options) : task_(task), inner_(options.inner.si()) {
  // where even the guiding length is more than the optimal descent, a flatter one is flown, and d_opt is its length ([3] section 4.5.2)
  optimalLength_ = std::max((task.altitude - task.goalAltitude) / task.optimal, 1.0);
  outer_ = 0.5 * (optimalLength_ + guidingLength(task.start));
}

double GradientCost::guidingLength(const geo::Pose& pose) const {
  const double dx = task_.goal.x - pose.x;
  const double dy = task_.goal.y - pose.y;
  const double distance = std::sqrt(dx * dx + dy * dy);
  return distance > 0.0 ? distance + task_.radius * std::abs(wrapPi(std::atan2(dy, dx) - pose.heading)) : 0.0;
}

double GradientCost::leastLength(const geo::Pose& pose) const {
  // in the frame of the aircraft, x ahead, y towards the side that the goal is on
  const double dx = task_.goal.x - pose.x;
  const double dy = task_.goal.y - pose.y;
  const double ahead = dx * std::cos(pose.heading) + dy * std::sin(pose.heading);
  const double aside = std::abs(-dx * std::sin(pose.heading) + dy * std::cos(pose.heading));
  const double fromCentre = std::hypot(ahead, aside - task_.radius);
  if (fromCentre < task_.radius) {
    return std::hypot(ahead, aside);  // inside the circle of the turn: only the straight line is a bound that needs no cases
  }
  const double tangent = std::sqrt(fromCentre * fromCentre - task_.radius * task_.radius);
  // angle of the goal about the centre, from the aircraft's place on the circle on, less what the tangent spares
  const double turned = wrapTwoPi(std::atan2(ahead, task_.radius - aside) - std::atan2(tangent, task_.radius));
  return task_.radius * (turned > 2.0 * Angle::kPi - 1e-9 ? 0.0 : turned) + tangent;
}

double GradientCost::descent(double flown, double guiding) const {
  return std::min(1.0, std::abs(flown + guiding - optimalLength_) / optimalLength_);
}

double GradientCost::distance(double guiding) const {
  return std::min(1.0, guiding / optimalLength_);
}

double GradientCost::share(double guiding) const {
  if (guiding <= inner_ || outer_ <= inner_) {
    return 1.0;
  }
  return std::max(0.0, (outer_ - guiding) / (outer_ - inner_));
}

double GradientCost::beyond(geo::Point place) const {
  return (place.x - task_.goal.x) * std::cos(task_.goal.heading) + (place.y - task_.goal.y) * std::sin(task_.goal.heading);
}

double GradientCost::course(geo::Point place) const {
  // the product with (d_opt - d_gc) is greatest half-way, on the extended final course: d_opt^2 / 4, (40)
  const double product = std::max(0.0, beyond(place)) * std::max(0.0, optimalLength_ - geo::distance(place, task_.goal.point()));
  return std::min(1.0, product / (0.25 * optimalLength_ * optimalLength_));
}

GradientWeights GradientCost::weights(double course) {
  if (course >= 0.5) {
    return {0.2, 0.3, 0.2, 0.3};
  }
  return course > 1e-4 ? GradientWeights{0.2, 0.3, 0.1, 0.4} : GradientWeights{0.2, 0.4, 0.0, 0.4};
}

double GradientCost::guide(const geo::Pose& pose, double flown, double& course) const {
  const double guiding = guidingLength(pose);
  course = this->course(pose.point());
  const GradientWeights weight = weights(course);
  const double rho = share(guiding);
  return weight.descent * rho * descent(flown, guiding) + weight.distance * (1.0 - rho) * distance(guiding) + weight.course * course;
}

}  // namespace vp::emergency
