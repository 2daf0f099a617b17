#pragma once

#include "core/air/atmosphere.h"
#include "core/aircraft/aircraft_profile.h"
#include "core/aircraft/runway_wind.h"

#include <optional>

namespace vp::aircraft {

/** What a landing depends on beside the aircraft. */
struct LandingConditions {
  air::Atmosphere air;           ///< of the day; the standard one where nobody knows
  geo::HeightMsl elevation;      ///< of the runway
  RunwayWind wind;               ///< the worst that a forecast may bring
  double downhillPercent = 0.0;  ///< fall along the landing course per 100 m; below zero uphill, which is no credit
  double surfaceFactor = 1.0;    ///< one of those below
};

// Of a dry hard runway's distance. @source UK CAA, Safety Sense Leaflet 7, "Aeroplane performance": dry grass 1.15, wet grass 1.35, soft ground
// or snow 1.25; nobody knows on the day of a failure whether grass is dry, and gravel is taken as dry grass
inline constexpr double kHardFactor = 1.0;
inline constexpr double kGravelFactor = 1.15;
inline constexpr double kGrassFactor = 1.35;
inline constexpr double kSoftFactor = 1.25;  ///< dirt, snow
inline constexpr double kUnknownSurfaceFactor = 1.35;

/** Distance from 15 m above the runway to standstill on the day: that of the profile times
 *  - 1.225 / density at the runway,
 *  - ((v + t) / v)^2, v true airspeed of the approach (1.3 stall speed; best glide speed where none is known), t one and a half times the greatest
 *    tailwind, or minus half of the least headwind where every wind is one,
 *  - 1 + 0.05 per percent downhill,
 *  - the surface's factor.
 *  @return none where the profile has no landing distance   @threads pure
 *  @source UK CAA, Safety Sense Leaflet 7: a slope of 2 % downhill adds 10 %, and factors multiply; 14 CFR 23.75 as applied by AC 23-8: not more
 *  than half of a headwind and not less than one and a half times a tailwind count */
std::optional<Length> landingDistance(const AircraftProfile& profile, const LandingConditions& conditions);

}  // namespace vp::aircraft
