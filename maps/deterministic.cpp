#include "maps/deterministic.h"

#include <algorithm>
#include <cmath>

namespace vp::maps {
namespace {

std::uint64_t mix(std::uint64_t value) {
  value = (value ^ (value >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  value = (value ^ (value >> 27U)) * 0x94d049bb133111ebULL;
  return value ^ (value >> 31U);
}

double toUnit(std::uint64_t bits) {
  return static_cast<double>(bits >> 11U) * 0x1.0p-53;
}

double latticeValue(std::int64_t i, std::int64_t j, std::uint64_t seed) {
  const std::uint64_t key = mix(static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15ULL + mix(static_cast<std::uint64_t>(j) + seed));
  return 2.0 * toUnit(mix(key)) - 1.0;
}

double fade(double t) {
  return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

}  // namespace

std::uint64_t Random::next() {
  state_ += 0x9e3779b97f4a7c15ULL;
  return mix(state_);
}

double Random::uniform() {
  return toUnit(next());
}

double valueNoise(double x, double y, std::uint64_t seed) {
  const double left = std::floor(x);
  const double bottom = std::floor(y);
  const auto i = static_cast<std::int64_t>(left);
  const auto j = static_cast<std::int64_t>(bottom);
  const double u = fade(x - left);
  const double v = fade(y - bottom);
  const double south = latticeValue(i, j, seed) * (1.0 - u) + latticeValue(i + 1, j, seed) * u;
  const double north = latticeValue(i, j + 1, seed) * (1.0 - u) + latticeValue(i + 1, j + 1, seed) * u;
  return south * (1.0 - v) + north * v;
}

double fractalNoise(double x, double y, std::uint64_t seed, int octaves) {
  double sum = 0.0;
  double range = 0.0;
  double amplitude = 1.0;
  double frequency = 1.0;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += amplitude * valueNoise(x * frequency, y * frequency, seed + static_cast<std::uint64_t>(octave));
    range += amplitude;
    amplitude *= 0.5;
    frequency *= 2.0;
  }
  return sum / range;
}

double smoothStep(double from, double to, double value) {
  const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double roundTo(double value, double unit) {
  return std::round(value / unit) * unit;
}

}  // namespace vp::maps
