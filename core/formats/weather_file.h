#pragma once

#include "core/base/result.h"
#include "core/mission/weather.h"

#include <string>
#include <vector>

namespace vp::formats {

/** Cells of a weather file, and what could not be used as it is. */
struct WeatherReport {
  std::vector<mission::WeatherCell> cells;
  std::vector<std::string> notes;  ///< one sentence each
};

/** Reads bad weather as polygons: GeoJSON, shapefile, GeoPackage, KML or FlatGeobuf with polygons. A coordinate system of the file is turned
 * to WGS 84; without one the coordinates must be degrees.
 *
 *  Fields by name, case and the signs _ - . ( ) aside; all may be missing:
 *  - NAME (ID, LABEL, HAZARD): what it is, for messages and maps
 *  - FLOOR_M, TOP_M or FLOOR_FT, TOP_FT (BASE_..., CEILING_... too): metres or feet above mean sea level; FLOOR, BASE, TOP, CEILING with the unit in
 *    the value ("3000 m", "25000ft", "FL250" taken as pressure altitude in the standard atmosphere, "SFC", "GND", "UNL"). None: from the ground, as
 * high as anybody flies
 *  - SUCCESS: probability of coming through, above 0 and up to 1, for so many PER_NM, PER_KM or PER_M; without these for one nautical mile. Without
 *    SUCCESS 0.9 for a nautical mile, with a note
 *  A multipolygon becomes a cell for each part. Holes count as weather too, with a note. What cannot be (sides that cross, a floor above its top) is
 *  refused where cells are put to use: risk::Weather::from.
 *  @errors BadFile - no file that OGR opens; BadFormat - no polygons, a value of a field that is no number or has no unit, coordinates that are no
 * degrees and no coordinate system   @threads pure */
Result<WeatherReport> readWeather(const std::string& path);

/** Whether a file has polygons with fields of weather: a floor, a top, a probability of coming through. A name alone is not enough, so that areas of
 *  something else are not taken for weather.   @threads pure; opens the file */
bool isWeatherFile(const std::string& path);

/** Writes cells as GeoJSON (RFC 7946) with the fields NAME, FLOOR_M, TOP_M, SUCCESS and PER_M: readWeather gives them back bit for bit.
 *  @errors OutputFailed; OutOfRange - a number that is not finite */
Result<void> writeWeather(const std::string& path, const std::vector<mission::WeatherCell>& cells);

}  // namespace vp::formats
