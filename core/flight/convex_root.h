#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace vp::flight {

/// What counts as rounding of a place [radii]: a turn that comes out below zero by no more is a turn of zero.
inline constexpr double kRounding = 1e-10;

/// A function and its derivative.
struct Value {
  double value = 0.0;
  double slope = 0.0;
};

/** The root of a convex function that is nearest to `x`, on the way to `end`. Newton's steps fall short of it, so they never pass it;
 *  each divides value times slope by four at least (WHY.md).  @pre at = function(x), at.value > 0 and falling towards `end`
 *  @param isCrossed  the function is known not to be positive at `end`, so that passing it is rounding
 *  @return none if the function stays positive; a lowest point within rounding of zero counts as a root */
template <typename Function>
std::optional<double> nextRoot(const Function& function, double x, Value at, double end, bool isCrossed) {
  constexpr int kMostSteps = 100;      // four to the power of -100 is below any rounding
  constexpr double kLastStep = 4e-16;  // changes nothing any more, relative above one
  const double way = end < x ? -1.0 : 1.0;
  for (int i = 0; i < kMostSteps; ++i) {
    const double next = x - at.value / at.slope;
    if (!((end - next) * way >= 0.0)) {
      return isCrossed ? std::optional(end) : std::nullopt;
    }
    if (std::abs(next - x) <= kLastStep * std::max(1.0, std::abs(x))) {
      return next;
    }
    x = next;
    at = function(x);
    if (at.value <= 0.0) {
      return x;  // only rounding brings a tangent of a convex function below it
    }
    if (at.slope * way >= 0.0) {
      return at.value <= 8.0 * kRounding ? std::optional(x) : std::nullopt;  // past the lowest point: touched or missed
    }
  }
  return x;
}

}  // namespace vp::flight
