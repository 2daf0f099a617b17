// LRL and RLR to a goal that the air carries along: all roots on the pieces between inflections (WHY.md).
#include "core/base/quantity.h"
#include "core/flight/convex_root.h"
#include "core/flight/turn_angle.h"
#include "core/flight/wind_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace vp::flight {
namespace {

constexpr double kTwoPi = 2.0 * Angle::kPi;

}  // namespace

/// One branch of left-right-left: outer turns that make up the change of heading, the middle turn and a number of circles.
struct WindSearch::Middle {
  double x = 0.0;  ///< between the outer centres for a middle turn of zero
  double y = 0.0;
  double windX = 0.0;
  double windY = 0.0;
  double turned = 0.0;  ///< outer turns less the middle one

  /// Square of the distance of the outer centres, less that which the middle turn asks for.
  [[nodiscard]] Value mismatch(double angle) const {
    const double cx = x - 2.0 * windX * angle;
    const double cy = y - 2.0 * windY * angle;
    const double s = std::sin(0.5 * angle);
    const double c = std::cos(0.5 * angle);
    return {cx * cx + cy * cy - 16.0 * s * s, -4.0 * (cx * windX + cy * windY) - 16.0 * s * c};
  }

  /// Square of the least distance of the outer centres for middle turns of a range.
  [[nodiscard]] double nearestSquare(double low, double high) const {
    const double windSquare = windX * windX + windY * windY;
    const double angle = windSquare > 0.0 ? std::clamp(0.5 * (x * windX + y * windY) / windSquare, low, high) : low;
    const double cx = x - 2.0 * windX * angle;
    const double cy = y - 2.0 * windY * angle;
    return cx * cx + cy * cy;
  }
};

void WindSearch::threeCircles(const WindFrame& frame) {
  for (const double circles : {-kTwoPi, 0.0, kTwoPi}) {
    const double turned = turnAngle(frame.turn) + circles;
    middleBranch(
        {frame.x - frame.sinTurn - frame.windX * turned, frame.y + frame.cosTurn - 1.0 - frame.windY * turned, frame.windX, frame.windY, turned});
  }
}

void WindSearch::middleBranch(const Middle& middle) {
  constexpr double kSlack = 1e-9;
  // the outer turns together are between none and two circles
  const double low = std::max(0.0, -middle.turned - kSlack);
  const double high = std::min({kTwoPi, 2.0 * kTwoPi - middle.turned + kSlack, 0.5 * (longest(0.0) - middle.turned)});
  if (high < low || middle.nearestSquare(low, high) > 16.0 + kRounding) {
    return;
  }
  const double inflection = std::acos(std::min(1.0, middle.windX * middle.windX + middle.windY * middle.windY));
  const double convex = std::clamp(inflection, low, high);
  const double concave = std::clamp(kTwoPi - inflection, low, high);
  if (middle.mismatch(low).value == 0.0) {
    middleFound(middle, low);
  }
  middlePart(middle, low, convex, -1.0);
  middlePart(middle, convex, concave, 1.0);
  middlePart(middle, concave, high, -1.0);
}

void WindSearch::middlePart(const Middle& middle, double low, double high, double sign) {
  if (high <= low) {
    return;
  }
  const auto convex = [&middle, sign](double angle) {
    const Value value = middle.mismatch(angle);
    return Value{sign * value.value, sign * value.slope};
  };
  const Value atLow = convex(low);
  const Value atHigh = convex(high);
  if (atLow.value > 0.0 && atLow.slope < 0.0) {
    if (const std::optional<double> root = nextRoot(convex, low, atLow, high, atHigh.value < 0.0)) {
      middleFound(middle, *root);
    }
  }
  if (atHigh.value > 0.0 && atHigh.slope > 0.0) {
    if (const std::optional<double> root = nextRoot(convex, high, atHigh, low, atLow.value < 0.0)) {
      middleFound(middle, *root);
    }
  }
  if (atHigh.value == 0.0) {
    middleFound(middle, high);
  }
}

void WindSearch::middleFound(const Middle& middle, double angle) {
  const double cx = middle.x - 2.0 * middle.windX * angle;
  const double cy = middle.y - 2.0 * middle.windY * angle;
  const double apart = std::sqrt(cx * cx + cy * cy);
  if (std::abs(apart - 4.0 * std::sin(0.5 * angle)) <= kRounding) {
    take(std::atan2(cy, cx) + 0.5 * angle, middle.turned + angle, angle, apart);
  }
}

}  // namespace vp::flight
