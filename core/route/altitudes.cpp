#include "core/route/altitudes.h"

#include "core/base/quantity.h"

#include <algorithm>
#include <cmath>

namespace vp::route {
namespace {

constexpr double kFeetTolerance = 1e-7;  // ft, so that a whole number of feet stays what it is
constexpr double kNever = -1e4;          // m, before anything is required

/// The leg that a distance lies on, and how far along it, 0 to 1.
struct Place {
  std::size_t leg = 0;
  double t = 0.0;
};

Place placeOf(const std::vector<double>& knots, double length, double distance) {
  const auto next = std::upper_bound(knots.begin(), knots.end(), distance);
  const std::size_t count = knots.size();
  const std::size_t to = next == knots.end() ? 0 : static_cast<std::size_t>(next - knots.begin());
  const std::size_t leg = (to + count - 1) % count;
  double span = knots[to] - knots[leg];
  double done = distance - knots[leg];
  span += span <= 0.0 ? length : 0.0;
  done += done < 0.0 ? length : 0.0;
  return {leg, std::clamp(done / span, 0.0, 1.0)};
}

double toWholeFeet(double metres) {
  return std::ceil(metres / kMetresPerFoot - kFeetTolerance);
}

/// Raises to the pitch limits around the loop, in whole feet: each pass can only raise, and all equal is a solution.
void raiseForPitch(const std::vector<double>& span, std::vector<double>& feet, Pitch pitch) {
  const std::size_t count = feet.size();
  for (bool isChanged = true; isChanged;) {
    isChanged = false;
    for (std::size_t step = 0; step < 2 * count; ++step) {
      const bool isForward = step < count;
      const std::size_t i = isForward ? step : 2 * count - 1 - step;
      const std::size_t next = (i + 1) % count;
      const double most = span[i] * (isForward ? pitch.descent : pitch.climb) / kMetresPerFoot;
      double& low = isForward ? feet[next] : feet[i];
      const double least = std::ceil((isForward ? feet[i] : feet[next]) - most - kFeetTolerance * 1e-2);
      if (low < least) {
        low = least;
        isChanged = true;
      }
    }
  }
}

}  // namespace

std::vector<double> waypointAltitudes(const std::vector<double>& knots, double length, const std::vector<Required>& required, Pitch pitch) {
  const std::size_t count = knots.size();
  std::vector<double> altitude(count, kNever);
  for (const Required& need : required) {  // what lies on a waypoint, or nearly so
    const Place at = placeOf(knots, length, need.distance);
    constexpr double kNear = 1e-6;
    if (at.t <= kNear) {
      altitude[at.leg] = std::max(altitude[at.leg], need.altitude);
    } else if (at.t >= 1.0 - kNear) {
      altitude[(at.leg + 1) % count] = std::max(altitude[(at.leg + 1) % count], need.altitude);
    }
  }
  std::vector<double> deficit(count, 0.0);
  for (const Required& need : required) {
    const Place at = placeOf(knots, length, need.distance);
    const double flown = altitude[at.leg] + at.t * (altitude[(at.leg + 1) % count] - altitude[at.leg]);
    deficit[at.leg] = std::max(deficit[at.leg], need.altitude - flown);
  }
  std::vector<double> feet(count);
  std::vector<double> span(count);
  for (std::size_t i = 0; i < count; ++i) {
    feet[i] = toWholeFeet(altitude[i] + std::max(deficit[i], deficit[(i + count - 1) % count]));
    const double ahead = knots[(i + 1) % count] - knots[i];
    span[i] = ahead > 0.0 ? ahead : ahead + length;
  }
  raiseForPitch(span, feet, pitch);
  std::transform(feet.begin(), feet.end(), altitude.begin(), [](double f) { return f * kMetresPerFoot; });
  return altitude;
}

double altitudeBetween(const std::vector<double>& knots, const std::vector<double>& altitudes, double length, double distance) {
  const Place at = placeOf(knots, length, distance);
  return altitudes[at.leg] + at.t * (altitudes[(at.leg + 1) % knots.size()] - altitudes[at.leg]);
}

}  // namespace vp::route
