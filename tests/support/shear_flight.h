#pragma once
// A glide in a wind that changes with height, by Newton's law: the accelerations are differences of velocities, the drag is what they leave.
// Shares nothing with planner and checker but the numbers of the aircraft.

#include "core/aircraft/course_loss.h"
#include "core/base/quantity.h"
#include "tests/support/wind_flight.h"

#include <cmath>
#include <limits>

namespace vp::test {

/** Height lost per metre of track where the wind depends on the altitude, airspeed and track being held; infinite if no sink rate is enough.
 *  @param windAt  (m MSL) -> SteadyWind, smooth within a metre   @param radius  of a left turn over ground, 0: straight */
template <typename WindAt>
double lossInShear(const aircraft::GlidePolar& polar, WindAt windAt, double altitude, double course, double radius) {
  struct Flight {
    double east, north;  // over ground, m/s
    double airE, airN;   // through the air
    double ground;       // speed over ground
  };
  const double v = polar.airspeed;
  const auto at = [&](double chi, double z, double sink) {
    const SteadyWind wind = windAt(z);
    const double across = wind.east * std::sin(chi) - wind.north * std::cos(chi);
    const double along = wind.east * std::cos(chi) + wind.north * std::sin(chi);
    const double ground = std::sqrt(v * v - sink * sink - across * across) + along;
    const double e = ground * std::cos(chi);
    const double n = ground * std::sin(chi);
    return Flight{e, n, e - wind.east, n - wind.north, ground};
  };
  const double g = kGravity.si();
  constexpr double kStep = 1e-3;  // s, to each side
  /// Drag that the motion leaves less the drag of the polar, in weights: rises with the sink rate.
  const auto surplus = [&](double sink) {
    const Flight now = at(course, altitude, sink);
    const double turned = radius > 0.0 ? now.ground / radius * kStep : 0.0;
    const Flight before = at(course - turned, altitude + sink * kStep, sink);
    const Flight after = at(course + turned, altitude - sink * kStep, sink);
    const double aE = (after.east - before.east) / (2.0 * kStep * g);
    const double aN = (after.north - before.north) / (2.0 * kStep * g);
    // force of the air per weight: (aE, aN, 1); along the airspeed (airE, airN, -sink) it is minus the drag
    const double along = (aE * now.airE + aN * now.airN - sink) / v;
    const double lift2 = aE * aE + aN * aN + 1.0 - along * along;
    return -along - (polar.parasite + polar.induced * lift2);
  };
  double low = 0.0;
  double high = 0.9 * v;
  if (!(surplus(high) > 0.0)) {
    return std::numeric_limits<double>::infinity();
  }
  while (high - low > 1e-9) {
    const double middle = 0.5 * (low + high);
    (surplus(middle) > 0.0 ? high : low) = middle;
  }
  return high / at(course, altitude, high).ground;
}

}  // namespace vp::test
