// The words of Dubins to a goal that the air carries along; WHY.md derives the equations and proves that no root is missed.
#include "core/flight/wind_words.h"

#include "core/base/expect.h"
#include "core/base/quantity.h"
#include "core/flight/convex_root.h"
#include "core/flight/turn_angle.h"

#include <algorithm>
#include <cmath>

namespace vp::flight {
namespace {

constexpr double kTwoPi = 2.0 * Angle::kPi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

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
    if (!(std::abs(turn - within) * lever <= kRounding)) {
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

}  // namespace vp::flight
