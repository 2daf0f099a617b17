#pragma once

#include "core/base/result.h"
#include "core/mission/population.h"

#include <string>
#include <vector>

namespace vp::formats {

/** Areas of a population file, and what could not be used. */
struct PopulationReport {
  std::vector<mission::PopulationArea> areas;
  std::vector<std::string> notes;  ///< one sentence each
};

/** Reads polygons with how many people live in them: GeoJSON, shapefile, GeoPackage, KML or FlatGeobuf with polygons in its first layer that
 *  has some. A coordinate system of the file is turned to WGS 84; without one the coordinates must be degrees.
 *
 *  Which field it is goes by name, case and the signs _ - . ( ) aside: people per square kilometre DENSITY, POP_DENSITY, POP_KM2, PER_KM2,
 *  DENSITY_KM2; else people POP, POPULATION, PEOPLE, PERSONS, TOTAL_POP, TOTPOP, POP100, POP2000, POP2010, POP2020, P1_001N, B01001_001E, spread over
 *  the land area of the feature if the file has one (ALAND, ALAND10, ALAND20, AREALAND, in m^2, as the Census Bureau's files do), else over its
 *  polygons. Features without polygon or number are left out, with a note. What cannot be (negative numbers, sides that cross)
 *  is refused where the areas are put to use: risk::Population::from.
 *  @errors BadFile - no file that OGR opens; BadFormat - no polygons, no field of people, coordinates that are no degrees and no coordinate system
 *  @threads pure */
Result<PopulationReport> readPopulation(const std::string& path);

/** Whether a file has polygons with a field of people.   @threads pure; opens the file */
bool isPopulationFile(const std::string& path);

}  // namespace vp::formats
