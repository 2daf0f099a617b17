#pragma once

#include "core/geo/height.h"

namespace vp::air {

/// Air density at sea level [kg/m^3]. @source ICAO Doc 7488/3 (1993), International Standard Atmosphere
inline constexpr double kSeaLevelDensity = 1.225;

/** The air of a day: the standard atmosphere, warmer or colder by the same at every height, under the pressure of a QNH. */
struct Atmosphere {
  double temperatureOffset_K = 0.0;  ///< ISA + 10 is 10
  double qnh_hPa = 1013.25;          ///< pressure reduced to mean sea level in the standard atmosphere, as airfields report it
  bool operator==(const Atmosphere&) const = default;
};

/** Temperature [K]; the same above the tropopause at 11 km. @threads pure */
double temperature(const Atmosphere& air, geo::HeightMsl altitude);

/** Pressure [hPa]. An altimeter set to the QNH shows the altitude that the standard atmosphere has this pressure at; heights count
 *  as such altitudes, so a cold day's error of the altimeter is not in it (see `altimeterError`).   @threads pure */
double pressure(const Atmosphere& air, geo::HeightMsl altitude);

/** Density [kg/m^3], pressure / (R T) of dry air. @source ICAO Doc 7488/3, sections 2 and 3; at most up to 20 km   @threads pure */
double density(const Atmosphere& air, geo::HeightMsl altitude);

/** Where the standard atmosphere has this density: the altitude that engine and propeller feel [m].
 *  @pre density of no more than 40 km up, which that at 0 to 20 km on any day of this struct's is   @threads pure */
geo::HeightMsl densityAltitude(const Atmosphere& air, geo::HeightMsl altitude);

/** How much an altimeter that was set at a station shows too much [m] when the aircraft is at an altitude: cold air makes it show more
 *  height than there is. Below zero on warm days.
 *  @param station  elevation of the airfield that the QNH comes from
 *  @source ICAO Doc 8168 volume I, part III, section 1, chapter 4: H (15 - t0) / (273 + t0 - 0.5 L0 (H + H_station)), t0 at the station
 *  reduced to sea level */
double altimeterError(const Atmosphere& air, geo::HeightMsl altitude, geo::HeightMsl station);

}  // namespace vp::air
