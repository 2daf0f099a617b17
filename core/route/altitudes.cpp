#include "core/route/altitudes.h"

#include "core/aircraft/climb.h"
#include "core/base/expect.h"
#include "core/base/quantity.h"
#include "core/mission/glide_conditions.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

Place placeOf(const std::vector<WayKnot>& knots, double distance) {
  const auto next = std::upper_bound(knots.begin() + 1, knots.end() - 1, distance, [](double d, const WayKnot& k) { return d < k.distance; });
  const auto leg = static_cast<std::size_t>(next - knots.begin()) - 1;
  const double span = knots[leg + 1].distance - knots[leg].distance;
  return {leg, span > 0.0 ? std::clamp((distance - knots[leg].distance) / span, 0.0, 1.0) : 1.0};
}

/// Highest altitudes that can be reached from the given ones, in feet.
std::vector<double> capsOf(const std::vector<WayKnot>& knots, Pitch pitch) {
  std::vector<double> caps(knots.size(), std::numeric_limits<double>::infinity());
  const auto limit = [&](std::size_t i, std::size_t from, double slope) {
    const double most = caps[from] + std::abs(knots[i].distance - knots[from].distance) * slope / kMetresPerFoot;
    caps[i] = knots[i].altitude ? *knots[i].altitude / kMetresPerFoot : std::min(caps[i], std::floor(most));
  };
  for (std::size_t i = 0; i < knots.size(); ++i) {
    limit(i, i == 0 ? 0 : i - 1, pitch.climb);
  }
  for (std::size_t i = knots.size() - 1; i-- > 0;) {
    limit(i, i + 1, pitch.descent);
  }
  for (std::size_t i = 1; i < knots.size(); ++i) {
    limit(i, i - 1, pitch.climb);
  }
  return caps;
}

/// Wanted altitudes in feet, before any limit.
std::vector<double> wantedFeet(const std::vector<WayKnot>& knots, const std::vector<Required>& wanted) {
  const std::size_t count = knots.size();
  constexpr double kNear = 1e-6;
  std::vector<double> altitude(count, kNever);
  for (const Required& need : wanted) {
    const Place at = placeOf(knots, need.distance);
    if (at.t <= kNear || at.t >= 1.0 - kNear) {
      double& here = altitude[at.t <= kNear ? at.leg : at.leg + 1];
      here = std::max(here, need.altitude);
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    altitude[i] = knots[i].altitude.value_or(altitude[i]);
  }
  std::vector<double> deficit(count, 0.0);
  for (const Required& need : wanted) {
    const Place at = placeOf(knots, need.distance);
    const double lacking = need.altitude - (altitude[at.leg] + at.t * (altitude[at.leg + 1] - altitude[at.leg]));
    deficit[at.leg] = std::max(deficit[at.leg], lacking);
    deficit[at.leg + 1] = std::max(deficit[at.leg + 1], lacking);
  }
  std::vector<double> feet(count);
  for (std::size_t i = 0; i < count; ++i) {
    feet[i] = toWholeFeet(altitude[i] + deficit[i]);
  }
  return feet;
}

}  // namespace

Pitch pitchOf(const mission::Plan& plan) {
  const aircraft::AircraftProfile& craft = plan.mission.aircraft;
  const aircraft::GlideConditions conditions = mission::glideConditionsOf(plan.mission, plan.sites);
  const aircraft::GlideModel glide(craft, conditions);
  const geo::HeightMsl top = geo::HeightMsl::fromMetres(mission::highestAltitude(plan) + mission::kClimbReserve);
  return {aircraft::climbSlopeOverGround(craft, conditions, glide, top), glide.slopeOf(craft.maxDescent)};
}

std::vector<double> waypointAltitudes(const std::vector<double>& knots, double length, const std::vector<Required>& required, Pitch pitch) {
  const std::size_t count = knots.size();
  VP_EXPECT(count > 0);
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

std::vector<double> wayAltitudes(const std::vector<WayKnot>& knots, const std::vector<Required>& wanted, Pitch pitch) {
  const std::vector<double> caps = capsOf(knots, pitch);
  std::vector<double> feet = wantedFeet(knots, wanted);
  const auto raise = [&](std::size_t i, std::size_t from, double slope) {
    if (!knots[i].altitude) {
      const double most = std::abs(knots[i].distance - knots[from].distance) * slope / kMetresPerFoot;
      feet[i] = std::min(caps[i], std::max(feet[i], std::ceil(feet[from] - most)));
    }
  };
  for (std::size_t i = 0; i < feet.size(); ++i) {
    feet[i] = knots[i].altitude ? *knots[i].altitude / kMetresPerFoot : std::min(feet[i], caps[i]);
  }
  for (std::size_t i = 1; i < feet.size(); ++i) {
    raise(i, i - 1, pitch.descent);
  }
  for (std::size_t i = feet.size() - 1; i-- > 0;) {
    raise(i, i + 1, pitch.climb);
  }
  for (std::size_t i = 1; i < feet.size(); ++i) {
    raise(i, i - 1, pitch.descent);
  }
  std::vector<double> altitudes(feet.size());
  for (std::size_t i = 0; i < feet.size(); ++i) {
    altitudes[i] = knots[i].altitude.value_or(feet[i] * kMetresPerFoot);
  }
  return altitudes;
}

double altitudeBetween(const std::vector<WayKnot>& knots, const std::vector<double>& altitudes, double distance) {
  const Place at = placeOf(knots, distance);
  return altitudes[at.leg] + at.t * (altitudes[at.leg + 1] - altitudes[at.leg]);
}

double altitudeBetween(const std::vector<double>& knots, const std::vector<double>& altitudes, double length, double distance) {
  const Place at = placeOf(knots, length, distance);
  return altitudes[at.leg] + at.t * (altitudes[(at.leg + 1) % knots.size()] - altitudes[at.leg]);
}

}  // namespace vp::route
