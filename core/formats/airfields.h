#pragma once

#include "core/base/result.h"
#include "core/geo/geo_box.h"
#include "core/mission/landing_site.h"
#include "core/mission/mission.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::formats {

/** Landing sites of a file, and what became of the rest. */
struct AirfieldReport {
  std::vector<mission::LandingSite> sites;  ///< in the order of the file, ids unique
  std::vector<std::string> notes;           ///< what was left out and why, counted; one sentence each
  std::vector<std::string> matched;         ///< entries of SiteFilter::exclude and oneWay that named something here
};

/** Landing sites of OurAirports: airports.csv and runways.csv, plain or .gz, columns found by name.
 *
 *  Touchdown = runway end moved along the runway by its displaced threshold; length = from there to the other end.
 *  Missing values are derived where that can be done and the site is marked (LandingSite::approximations):
 *  end coordinates from the airport's position, length and heading; heading from the opposite end, else from the runway
 *  number as if it were a true course (magnetic variation ignored); elevation from the airport. No elevation or no
 *  heading at all: left out with a note. Closed airports and runways, helipads, balloonports and water are left out
 *  unless the filter asks for water or closed ones.
 *  @param area  only sites with their touchdown in this box; everything if absent
 *  @errors BadFile - cannot be read;  BadFormat - a missing column, an open quote, a coordinate that is no number:
 *  names file, row and column
 *  @source ourairports.com/help/data-dictionary.html; the files themselves (type "closed", not "closed_airport") */
Result<AirfieldReport> readOurAirports(const std::string& airportsCsv, const std::string& runwaysCsv, const mission::SiteFilter& filter,
                                       const std::optional<geo::GeoBox>& area);

/** Landing sites of a SeeYou .cup file (2018 and 2022 columns, found by name; UTF-8 or Windows-1252): points of style
 *  2 (grass), 3 (outlanding), 4 (gliding site) and 5 (solid). Both ends lie half the runway length from the point along
 *  rwdir; all are marked approximate. No rwdir or no elevation: left out with a note. Tasks are not read.
 *  @errors as readOurAirports */
Result<AirfieldReport> readCup(const std::string& path, const mission::SiteFilter& filter, const std::optional<geo::GeoBox>& area);

/** Reads a source of a mission by what it is: a .cup, or an airports file with its runways file.
 *  @param folder  mission file or folder that relative paths start from */
Result<AirfieldReport> readAirfields(const mission::AirfieldSource& source, const std::string& folder, const mission::SiteFilter& filter,
                                     const std::optional<geo::GeoBox>& area);

/** The same filter for sites that the mission itself lists. The opposite end of a one-way site is the one of the same
 *  airport whose course differs by 180 degrees (within 10). */
AirfieldReport filterSites(const std::vector<mission::LandingSite>& sites, const mission::SiteFilter& filter, const std::optional<geo::GeoBox>& area);

/** Gives sites of equal id the endings #2, #3, ... in order; needed where several sources are joined. */
void makeIdsUnique(std::vector<mission::LandingSite>& sites);

/** Entries of exclude and oneWay that no report matched: most likely misspelt, so the caller should refuse or warn. */
std::vector<std::string> unmatchedNames(const mission::SiteFilter& filter, const std::vector<AirfieldReport>& reports);

}  // namespace vp::formats
