// The words of Dubins to a goal that the air carries along; WHY.md derives the equations and proves that no root is missed.
#include "core/flight/wind_words.h"

#include "core/base/expect.h"
#include "core/base/quantity.h"
#include "core/flight/turn_angle.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vp::flight {
namespace {

constexpr double kTwoPi = 2.0 * Angle::kPi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What counts as rounding of a place [radii]: a turn that comes out below zero by no more is a turn of zero.
constexpr double kRounding = 1e-10;

/// Newton steps: each divides value times slope by four at least (WHY.md), so that this many are never needed.
constexpr int kMostSteps = 100;

/// A step of this size changes nothing any more [radians or radii, relative above one].
constexpr double kLastStep = 4e-16;

struct Value {
  double value = 0.0;
  double slope = 0.0;
};

/// The root of a convex function that is nearest to `x`, on the way to `end`. @pre at = function(x), at.value > 0 and falling towards `end`
/// @param isCrossed  the function is known to be negative at `end`, so that passing it is rounding
template <typename Function>
std::optional<double> nextRoot(const Function& function, double x, Value at, double end, bool isCrossed) {
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

}  // namespace

WindFrame::WindFrame(const geo::Pose& from, const geo::Pose& to, double radius, double airspeed, air::Wind wind) {
  const double c = std::cos(from.heading);
  const double s = std::sin(from.heading);
  const double east = (to.x - from.x) / radius;
  const double north = (to.y - from.y) / radius;
  x = c * east + s * north;
  y = c * north - s * east;
  turn = std::remainder(to.heading - from.heading, kTwoPi);
  sinTurn = std::sin(turn);
  cosTurn = std::cos(turn);
  windX = (c * wind.east + s * wind.north) / airspeed;
  windY = (c * wind.north - s * wind.east) / airspeed;
  constexpr double kCalm = 1e-14;
  if (windSquare() < kCalm * kCalm) {
    windX = windY = 0.0;
  }
}

WindFrame WindFrame::mirrored() const {
  WindFrame frame = *this;
  frame.y = -y;
  frame.turn = -turn;
  frame.sinTurn = -sinTurn;
  frame.windY = -windY;
  return frame;
}

void WindSearch::search(Word word, const WindFrame& frame) {
  word_ = word;
  switch (word) {
    case Word::LSL:
    case Word::RSR:
      return sameSide(frame);
    case Word::LSR:
    case Word::RSL:
      return otherSide(frame);
    case Word::RLR:
    case Word::LRL:
      return threeCircles(frame);
  }
}

double WindSearch::longest(double turned) const {
  if (keepsAll_ || least_ == kInfinity) {
    return kInfinity;
  }
  if (!isStraight()) {
    return loss_.turn > 0.0 ? least_ / loss_.turn : kInfinity;
  }
  return loss_.straight > 0.0 ? (least_ - (loss_.turn - loss_.straight) * std::max(0.0, turned)) / loss_.straight : kInfinity;
}

void WindSearch::take(double first, double total, double middle, double lever) {
  const double low = std::max(0.0, total - kTwoPi);
  const double high = std::min(kTwoPi, total);
  if (high < low - kRounding) {
    return;
  }
  first -= kTwoPi * std::floor(first / kTwoPi);
  for (const double turn : {first, first - kTwoPi, first + kTwoPi}) {
    const double within = std::max(std::min(turn, high), low);
    if (std::abs(turn - within) * lever > kRounding) {
      continue;
    }
    const Found found{word_, {within, middle, std::max(0.0, total - within)}};
    const double turned = found.parts[0] + found.parts[2];
    const double loss = isStraight() ? loss_.straight * middle + loss_.turn * turned : loss_.turn * (turned + middle);
    if (keepsAll_) {
      VP_EXPECT(size_ < kCapacity);
      found_[size_++] = found;
    } else if (loss < least_) {
      least_ = loss;
      found_[0] = found;
      size_ = 1;
    }
    return;
  }
}

void WindSearch::sameSide(const WindFrame& frame) {
  const double windSquare = frame.windSquare();
  const double turn = turnAngle(frame.turn);
  for (const double total : {turn, turn + kTwoPi}) {
    // from the first circle's centre to the last one's when all turning is done: what the straight part and its drift must cover
    const double x = frame.x - frame.sinTurn - frame.windX * total;
    const double y = frame.y + frame.cosTurn - 1.0 - frame.windY * total;
    const double square = x * x + y * y;
    const double along = x * frame.windX + y * frame.windY;
    const double root = std::sqrt(along * along + (1.0 - windSquare) * square);
    const double straight = along > 0.0 ? square / (root + along) : (root - along) / (1.0 - windSquare);
    if (total + straight < longest(total)) {
      take(std::atan2(y - frame.windY * straight, x - frame.windX * straight), total, straight, straight);
    }
  }
}

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
  const bool isCalm = tangent.windX == 0.0 && tangent.windY == 0.0;
  Value atHigh{-kInfinity, 0.0};
  double lastHeading = tangent.refHeading;
  if (high < kInfinity) {
    const Tangent::At end = tangent.at(high);
    lastHeading = tangent.heading(end.dirX, end.dirY);
    atHigh = tangent.excess(high);
  } else if (!isCalm) {
    lastHeading = tangent.heading(-tangent.windX, -tangent.windY);
  }
  const auto [least, most] = std::minmax({tangent.refHeading, lastHeading});
  const auto circles = [](double from, double to) {  // whole circles that bring some angle of the range into [0, 2 pi]
    constexpr double kSlack = 1e-9;
    return std::pair(std::ceil(-to / kTwoPi - kSlack), std::floor(1.0 - from / kTwoPi + kSlack));
  };
  const auto [firstLow, firstHigh] = circles(least, most);
  const auto [lastLow, lastHigh] = circles(least - tangent.turn, most - tangent.turn);
  const Value atLow = tangent.excess(low);
  const double windSpeed = std::sqrt(tangent.windX * tangent.windX + tangent.windY * tangent.windY);
  for (double circle = firstLow + lastLow; circle <= firstHigh + lastHigh; circle += 1.0) {
    const double added = kTwoPi * circle;
    if (atLow.value + added < -kRounding || atHigh.value + added > kRounding) {
      continue;
    }
    const double allowed = longest(2.0 * least - tangent.turn + added);
    if (low - (atLow.value + added) / atLow.slope >= allowed) {  // the first step falls short of the root
      continue;
    }
    double length = low;
    if (atLow.value + added > 0.0) {
      const auto excess = [&](double flown) {
        Value value = tangent.excess(flown);
        value.value += added;
        return value;
      };
      const double bracket = std::min(high, low + (atLow.value + added) / (1.0 - windSpeed) + kRounding);
      const std::optional<double> root = nextRoot(excess, low, {atLow.value + added, atLow.slope}, std::min(bracket, allowed), bracket <= allowed);
      if (!root) {
        continue;
      }
      length = *root;
    }
    const Tangent::At at = tangent.at(length);
    const double heading = tangent.heading(at.dirX, at.dirY);
    take(heading, 2.0 * heading - tangent.turn + added, at.straight, at.straight + 4.0);
  }
}

/// One branch of left-right-left: outer turns that make up the change of heading, the middle turn and a number of circles.
struct WindSearch::Middle {
  double x = 0.0;  ///< between the outer centres for a middle turn of zero
  double y = 0.0;
  double windX = 0.0;
  double windY = 0.0;
  double turned = 0.0;  ///< outer turns less the middle one

  /// Square of the distance of the outer centres, less that of the centres of such a middle turn.
  [[nodiscard]] Value mismatch(double angle) const {
    const double cx = x - 2.0 * windX * angle;
    const double cy = y - 2.0 * windY * angle;
    const double s = std::sin(0.5 * angle);
    const double c = std::cos(0.5 * angle);
    return {cx * cx + cy * cy - 16.0 * s * s, -4.0 * (cx * windX + cy * windY) - 16.0 * s * c};
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
  const double windSquare = middle.windX * middle.windX + middle.windY * middle.windY;
  constexpr double kSlack = 1e-9;
  // the outer turns together are between none and two circles
  const double low = std::max(0.0, -middle.turned - kSlack);
  const double high = std::min({kTwoPi, 2.0 * kTwoPi - middle.turned + kSlack, 0.5 * (longest(0.0) - middle.turned)});
  if (high < low) {
    return;
  }
  // nearest approach of the outer centres
  const double along = middle.x * middle.windX + middle.y * middle.windY;
  const double nearest = windSquare > 0.0 ? std::clamp(0.5 * along / windSquare, low, high) : low;
  const double cx = middle.x - 2.0 * middle.windX * nearest;
  const double cy = middle.y - 2.0 * middle.windY * nearest;
  if (cx * cx + cy * cy > 16.0 + kRounding) {
    return;
  }
  // concave, convex, concave
  const double inflection = std::acos(std::min(1.0, windSquare));
  const std::array<double, 4> ends{low, std::clamp(inflection, low, high), std::clamp(kTwoPi - inflection, low, high), high};
  const auto mismatch = [&middle](double angle) { return middle.mismatch(angle); };
  const auto negated = [&middle](double angle) {
    const Value value = middle.mismatch(angle);
    return Value{-value.value, -value.slope};
  };
  Value left = mismatch(ends[0]);
  if (left.value == 0.0) {
    middleFound(middle, ends[0]);
  }
  for (std::size_t part = 0; part < 3; ++part) {
    const double a = ends[part];
    const double b = ends[part + 1];
    if (!(a < b)) {
      continue;
    }
    const Value right = mismatch(b);
    const double sign = part == 1 ? 1.0 : -1.0;
    const auto root = [&](double from, Value at, double to, bool isCrossed) {
      const std::optional<double> found = part == 1 ? nextRoot(mismatch, from, at, to, isCrossed) : nextRoot(negated, from, at, to, isCrossed);
      if (found) {
        middleFound(middle, *found);
      }
    };
    const Value atA{sign * left.value, sign * left.slope};
    const Value atB{sign * right.value, sign * right.slope};
    if (atA.value > 0.0 && atA.slope < 0.0) {
      root(a, atA, b, atB.value < 0.0);
    }
    if (atB.value > 0.0 && atB.slope > 0.0) {
      root(b, atB, a, atA.value < 0.0);
    }
    if (right.value == 0.0) {
      middleFound(middle, b);
    }
    left = right;
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
