#pragma once

#include "core/air/atmosphere.h"

namespace vp::safety {

/** Highest altitude that the air of these functions is known for [m MSL]: above it the standard atmosphere warms again. */
inline constexpr double kHighestAir = 20000.0;

/** Density of the air of a day [kg/m^3] at an altitude [m MSL, -1000 to kHighestAir], falling with it. The checker's own.
 *  @source ICAO Doc 7488/3 (1993), sections 2 and 3; heights count as altitudes of an altimeter set to the QNH   @threads pure */
double densityAt(const air::Atmosphere& air, double altitude);

/** Altitude at which the standard atmosphere has the density that a day's air has here [m MSL, up to kHighestAir]: what engine and propeller feel.
 *  Above 20 km, which it gets to on hot days, the standard atmosphere is taken to stay as cold.  @source as above   @threads pure */
double densityAltitudeOf(const air::Atmosphere& air, double altitude);

/** How much such an altimeter, set at a station of this elevation [m MSL], shows too much [m] where it shows `altitude`; negative in warm air.
 *  @source ICAO Doc 8168 volume I, part III, section 1, chapter 4, 4.3.3: H (15 - t0) / (273 + t0 - 0.5 L0 (H + H_station))   @threads pure */
double altimeterShowsTooMuch(const air::Atmosphere& air, double altitude, double station);

}  // namespace vp::safety
