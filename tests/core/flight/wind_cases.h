// What the tests of paths in wind share: random connections, and the equations of motion over ground.
#pragma once

#include "core/base/quantity.h"
#include "core/flight/wind_dubins.h"

#include <cmath>
#include <random>

namespace vp::flight {

inline constexpr unsigned kSeed = 20201116;
inline constexpr double kPi = Angle::kPi;
inline constexpr double kRadius = 65.7;
inline constexpr double kAirspeed = 33.4;
inline constexpr TurnLoss kLoss{0.0857, 0.232};

struct Case {
  geo::Pose from;
  geo::Pose to;
  air::Wind wind;
};

class RandomCases {
public:
  RandomCases(double reach, double windiest) : reach_(reach), windiest_(windiest) {}
  double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(engine_); }
  double angle() { return 2.0 * kPi * unit(); }
  Case operator()() {
    const geo::Pose from{1000.0 * unit(), 1000.0 * unit(), angle()};
    const double distance = reach_ * unit();
    const double direction = angle();
    const double speed = windiest_ * kAirspeed * unit();
    const double towards = angle();
    return {from,
            {from.x + distance * std::cos(direction), from.y + distance * std::sin(direction), angle()},
            {speed * std::cos(towards), speed * std::sin(towards)}};
  }

private:
  std::mt19937_64 engine_{kSeed};
  double reach_;
  double windiest_;
};

/** x' = v cos h + wind, y' = v sin h + wind, h' = +-v / r in time, classic Runge-Kutta with steps of at most 0.025 rad. */
inline geo::Pose integrate(const WindPath& path) {
  geo::Pose pose = path.start;
  const auto turns = turnsOf(path.word);
  for (std::size_t part = 0; part < 3; ++part) {
    const double rate = static_cast<double>(static_cast<int>(turns[part])) * path.airspeed / path.radius;
    const double seconds = path.lengths[part] / path.airspeed;
    const int steps = 1 + static_cast<int>(std::abs(rate) * seconds * 40.0);
    const double h = seconds / steps;
    for (int i = 0; i < steps; ++i) {
      const double middle = pose.heading + 0.5 * h * rate;
      const double end = pose.heading + h * rate;
      pose.x += h / 6.0 * path.airspeed * (std::cos(pose.heading) + 4.0 * std::cos(middle) + std::cos(end)) + h * path.wind.east;
      pose.y += h / 6.0 * path.airspeed * (std::sin(pose.heading) + 4.0 * std::sin(middle) + std::sin(end)) + h * path.wind.north;
      pose.heading = end;
    }
  }
  return pose;
}

}  // namespace vp::flight
