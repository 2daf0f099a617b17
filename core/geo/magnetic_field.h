#pragma once

#include "core/base/quantity.h"
#include "core/geo/height.h"
#include "core/geo/local_frame.h"

#include <chrono>
#include <string>

namespace vp::geo {

/** The Earth's main magnetic field at a place, nanotesla, in local directions. */
struct MagneticField {
  double north = 0.0;
  double east = 0.0;
  double down = 0.0;

  /** The part that a compass feels. Below 6000 nT compasses are unreliable, below 2000 nT they are of no use
   *  (caution and blackout zones of the model's report). */
  [[nodiscard]] double horizontal() const;
  /** False in the blackout zone, where a compass is of no use and no variation should be told. */
  [[nodiscard]] bool movesACompass() const;
  /** Magnetic variation (declination): from true north to magnetic north, east positive. True = magnetic + variation. */
  [[nodiscard]] Angle variation() const;
};

/** World Magnetic Model 2025, degree and order 12; heights above the sea stand for heights above the ellipsoid, which
 *  changes nothing that shows (100 m: 0.001 degrees away from the poles).
 *  @param year  decimal, see decimalYear; outside 2025 to 2030 the rates of the model are carried on
 *  @accuracy of the model: standard error of the variation sqrt(0.26^2 + (5417 nT / horizontal)^2) degrees (its report, section 3);
 *  iron in the ground and in the aircraft comes on top
 *  @threads pure
 *  @source NOAA NCEI and BGS, World Magnetic Model WMM2025 of 13 November 2024 (resources/magnetic/WMM2025.COF); sum by GeographicLib */
MagneticField magneticField(LatLon place, HeightMsl height, double year);

/** True if the model is made for this moment; where it is not, a reader should be told. */
bool isCoveredByMagneticModel(double year);

/** "World Magnetic Model WMM-2025 (NOAA NCEI, BGS), valid 2025 to 2029", for briefings. */
std::string magneticModelName();

/** The moment of a day's noon as the model counts: year + fraction of that year. */
double decimalYear(std::chrono::year_month_day day);

/** The day that it is now, in UTC. */
std::chrono::year_month_day today();

}  // namespace vp::geo
