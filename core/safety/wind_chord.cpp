#include "core/safety/wind_chord.h"

#include <algorithm>
#include <utility>

namespace vp::safety {
namespace {

/// More than rounding of the sum below, as a part of the square of the airspeed.
constexpr double kRounding = 1e-11;

Between operator+(Between a, Between b) {
  return {a.least + b.least, a.most + b.most};
}

Between operator*(Between a, Between b) {
  const auto [low, high] = std::minmax({a.least * b.least, a.least * b.most, a.most * b.least, a.most * b.most});
  return {low, high};
}

Between times(double factor, Between a) {
  return Between::of(factor * a.least, factor * a.most);
}

/// One over numbers above 0.
Between inverse(Between a) {
  return {1.0 / a.most, 1.0 / a.least};
}

}  // namespace

Between Between::of(double a, double b) {
  return a <= b ? Between{a, b} : Between{b, a};
}

/// The sign of the sum is that of the derivative, by any value of the ranges.
bool isOneWay(const Chord& chord, const ChordRanges& ranges, double square) {
  const auto& [along, across, ahead, glided, induced] = ranges;
  const Between overAhead = inverse(ahead);
  const Between share = along * overAhead;
  const Between rest{1.0 - share.most, 1.0 - share.least};
  const Between bank = Between{2.0 * chord.alongBy, 2.0 * chord.alongBy} + times(-chord.acrossBy, rest * (across * overAhead));
  const Between weight = (ahead * ahead + glided * along) * inverse(ahead + along);
  const Between sum = times(2.0, induced * weight * bank) + times(chord.acrossBy, across) + times(-chord.alongBy, glided);
  return sum.least > kRounding * square || sum.most < -kRounding * square;
}

}  // namespace vp::safety
