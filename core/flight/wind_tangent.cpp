// LSR and RSL to a goal that the air carries along: one root on each branch (WHY.md).
#include "core/base/quantity.h"
#include "core/flight/convex_root.h"
#include "core/flight/wind_words.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace vp::flight {
namespace {

constexpr double kTwoPi = 2.0 * Angle::kPi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Least and most number of whole circles that bring some angle of a range into [0, 2 pi].
std::pair<int, int> wholeCircles(double least, double most) {
  constexpr double kSlack = 1e-9;
  return {static_cast<int>(std::ceil(-most / kTwoPi - kSlack)), static_cast<int>(std::floor(1.0 - least / kTwoPi + kSlack))};
}

}  // namespace

/// The inner tangent of the first circle, turned left, and the last one, turned right, when `length` has been flown.
struct WindSearch::Tangent {
  double x = 0.0;  ///< between the centres at length 0
  double y = 0.0;
  double windX = 0.0;
  double windY = 0.0;
  double turn = 0.0;
  double refX = 1.0;  ///< direction of the tangent where the branch begins
  double refY = 0.0;
  double refHeading = 0.0;

  struct At {
    double straight = 0.0;
    double dirX = 1.0;
    double dirY = 0.0;
  };

  [[nodiscard]] At at(double length) const {
    const double cx = x - windX * length;
    const double cy = y - windY * length;
    const double straight = std::sqrt(std::max(0.0, cx * cx + cy * cy - 4.0));
    const double scale = 1.0 / (straight * straight + 4.0);
    return {straight, scale * (straight * cx - 2.0 * cy), scale * (straight * cy + 2.0 * cx)};
  }

  /// Less than half a circle from the reference, and monotone in the length flown (WHY.md).
  [[nodiscard]] double heading(double dirX, double dirY) const {
    return refHeading + std::atan2(refX * dirY - refY * dirX, refX * dirX + refY * dirY);
  }

  /// Length of the word, less the length flown, without whole circles.
  [[nodiscard]] Value excess(double length) const {
    const At a = at(length);
    return {2.0 * heading(a.dirX, a.dirY) - turn + a.straight - length, -(1.0 + a.dirX * windX + a.dirY * windY)};
  }

  /// Heading of the tangent at the end of a branch, which is against the wind after infinite length.
  [[nodiscard]] double lastHeading(double length) const {
    if (length == kInfinity) {
      return windX == 0.0 && windY == 0.0 ? refHeading : heading(-windX, -windY);
    }
    const At a = at(length);
    return heading(a.dirX, a.dirY);
  }

  /// Where the length of the word with `added` radians of whole circles is the length flown, if that is not above `allowed`.
  /// @param atLow  its excess at `low`, not below zero but for rounding
  [[nodiscard]] std::optional<double> root(double low, Value atLow, double high, double allowed, double added) const {
    const double first = low - std::max(0.0, atLow.value) / atLow.slope;  // falls short of the root, as all steps of Newton
    if (first >= allowed || atLow.value <= 0.0) {
      return first < allowed ? std::optional(low) : std::nullopt;
    }
    const auto excessOf = [this, added](double length) {
      Value value = excess(length);
      value.value += added;
      return value;
    };
    const double windSpeed = std::sqrt(windX * windX + windY * windY);
    const double bracket = std::min(high, low + atLow.value / (1.0 - windSpeed) + kRounding);  // the slope is nowhere flatter
    return nextRoot(excessOf, low, atLow, std::min(bracket, allowed), bracket <= allowed);
  }
};

void WindSearch::otherSide(const WindFrame& frame) {
  Tangent tangent{frame.x + frame.sinTurn, frame.y - frame.cosTurn - 1.0, frame.windX, frame.windY, frame.turn};
  const double apart = tangent.x * tangent.x + tangent.y * tangent.y - 4.0;
  const double windSquare = frame.windSquare();
  if (windSquare == 0.0) {
    if (apart >= -kRounding) {
      tangentBranches(tangent, 0.0, kInfinity);
    }
    return;
  }
  const double along = tangent.x * frame.windX + tangent.y * frame.windY;
  const double discriminant = along * along - windSquare * apart;
  if (discriminant <= 0.0 || (along <= 0.0 && apart >= 0.0)) {
    tangentBranches(tangent, 0.0, kInfinity);  // the circles never overlap while the goal drifts
    return;
  }
  const double sum = along + std::copysign(std::sqrt(discriminant), along);
  const auto [overlap, free] = std::minmax({apart / sum, sum / windSquare});
  if (overlap >= 0.0) {
    tangentBranches(tangent, 0.0, overlap);
  }
  if (free <= 3.0 * kTwoPi + kRounding) {  // where the circles part the word is two turns, that change by less than a circle later
    tangentBranches(tangent, std::max(0.0, free), kInfinity);
  }
}

void WindSearch::tangentBranches(const Tangent& shape, double low, double high) {
  Tangent tangent = shape;
  const Tangent::At begin = tangent.at(low);
  tangent.refX = begin.dirX;
  tangent.refY = begin.dirY;
  tangent.refHeading = std::atan2(begin.dirY, begin.dirX);
  const double lastHeading = tangent.lastHeading(high);
  const auto [least, most] = std::minmax({tangent.refHeading, lastHeading});
  const auto [firstLow, firstHigh] = wholeCircles(least, most);
  const auto [lastLow, lastHigh] = wholeCircles(least - tangent.turn, most - tangent.turn);
  const Value atLow = tangent.excess(low);
  const double atHigh = high < kInfinity ? tangent.excess(high).value : -kInfinity;
  for (int circles = firstLow + lastLow; circles <= firstHigh + lastHigh; ++circles) {
    const double added = kTwoPi * circles;
    if (atLow.value + added < -kRounding || atHigh + added > kRounding) {
      continue;
    }
    const double allowed = longest(2.0 * least - tangent.turn + added);
    if (const std::optional<double> length = tangent.root(low, {atLow.value + added, atLow.slope}, high, allowed, added)) {
      const Tangent::At at = tangent.at(*length);
      const double heading = tangent.heading(at.dirX, at.dirY);
      take(heading, 2.0 * heading - tangent.turn + added, at.straight, at.straight + 4.0);
    }
  }
}

}  // namespace vp::flight
