#pragma once

// Random winds for tests of the checker, and what one wind does to a glide, worked out with vectors and not by the checker.

#include "core/air/wind_layer.h"
#include "core/aircraft/aircraft_profile.h"
#include "tests/support/plan_builder.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace vp::test {

inline air::WindLayer layerOf(double altitude, double from, double spread, double least, double most) {
  return {geo::HeightMsl::fromMetres(altitude), {from, spread, least, most}};
}

/** Random numbers, and winds made of them. */
class WindCases {
public:
  explicit WindCases(std::uint64_t seed) : random_(seed) {}

  double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
  int below(int count) { return std::min(count - 1, static_cast<int>(count * unit())); }

  /// Some exact, some from all around, some narrow; at most 18 m/s.
  air::WindLayer layer(double altitude) {
    const double most = 18.0 * unit();
    const int kind = below(4);
    const double spread = kind == 0 ? 0.0 : kind == 1 ? 180.0 : kind == 2 ? 30.0 * unit() : 180.0 * unit();
    return layerOf(altitude, 360.0 * unit(), spread, below(3) == 0 ? most : most * unit() * below(2), most);
  }
  std::vector<air::WindLayer> layers(int count) {
    std::vector<air::WindLayer> all;
    for (int i = 0; i < count; ++i) {
      all.push_back(layer(1000.0 * i));
    }
    return all;
  }

  /// Any wind of the set, towards, east and north in m/s: of each layer one, and their mean by random weights.
  air::Wind wind(const std::vector<air::WindLayer>& layers) {
    air::Wind mean;
    double weights = 0.0;
    for (const air::WindLayer& layer : layers) {
      const double speed = layer.wind.leastSpeed + (layer.wind.mostSpeed - layer.wind.leastSpeed) * edgy();
      const double from = (layer.wind.from_deg + layer.wind.spread_deg * (2.0 * edgy() - 1.0)) * Angle::kPi / 180.0;
      const double weight = layers.size() == 1 ? 1.0 : below(3) == 0 ? 1e-12 : 1e-12 + unit();
      mean.east -= weight * speed * std::sin(from);
      mean.north -= weight * speed * std::cos(from);
      weights += weight;
    }
    return {mean.east / weights, mean.north / weights};
  }

private:
  /// In [0, 1], often at an end.
  double edgy() {
    const int kind = below(4);
    return kind == 0 ? 0.0 : kind == 1 ? 1.0 : unit();
  }

  std::mt19937_64 random_;
};

/** Height lost per metre over ground in one wind on a course, turning with a radius over ground (0: straight on), by vectors: the
 *  air velocity is ground minus wind, what keeps the circle is the part of the sideways acceleration at a right angle to it. */
inline double lossIn(const aircraft::AircraftProfile& profile, const air::Wind& wind, double course, double radius) {
  const double v = profile.bestGlideSpeed.si();
  const double ex = std::cos(course);
  const double ey = std::sin(course);
  const double along = wind.east * ex + wind.north * ey;
  const double square = wind.east * wind.east + wind.north * wind.north;
  const auto groundSpeed = [&](double air) { return along + std::sqrt(along * along - square + air * air); };  // |g e - w| = air
  double loadSquare = 1.0;
  if (radius > 0.0) {
    const double g = groundSpeed(v);
    const double ax = g * ex - wind.east;
    const double ay = g * ey - wind.north;
    const double sideways = g * g / radius / ((ax * ex + ay * ey) / std::hypot(ax, ay));
    loadSquare += sideways * sideways / (9.80665 * 9.80665);
  }
  const double pressure = 0.5 * profile.airDensity_kgm3 * v * v;
  const double weight = profile.mass_kg * 9.80665;
  const double lift = std::sqrt(loadSquare) * weight / (pressure * profile.wingArea_m2);
  const double sine = pressure * profile.wingArea_m2 * (profile.zeroLiftDrag + profile.inducedDrag * lift * lift) / weight;
  return v * sine / groundSpeed(v * std::sqrt(1.0 - sine * sine));
}

}  // namespace vp::test
