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
 *  number and the magnetic variation (runway_names.h); elevation from the airport, else from the terrain. No
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

/** Landing sites of X-Plane's apt.dat, versions 850 to 1200, plain or .gz: rows 1, 16 (headers), 100, 101 (runways on land
 *  and water) and the icao_code of 1302. Both ends are always there and count; the elevation is the airport's and marked.
 *  Airports named "[X] ..." are closed. Heliports (17), helipads (102) and rows that make no sense are left out, counted and
 *  listed by their line.   @errors BadFile, BadFormat - not an apt.dat or of another version
 *  @source developer.x-plane.com, "Airport data (apt.dat) file format specification"; atools xpairportreader.cpp for the
 *  unit of displaced thresholds (metres) */
Result<AirfieldReport> readAptDat(const std::string& path, const mission::SiteFilter& filter, const std::optional<geo::GeoBox>& area);

/** Landing sites that somebody keeps in a table of his own (comma, semicolon or tab; UTF-8 or Windows-1252). One row is a
 *  runway: `latitude longitude` of the threshold that is landed on, and `course_deg` (true) with `length_m`, or
 *  `end_latitude end_longitude` of the other end; without any of these the number in `runway` and the magnetic variation
 *  count, marked. Further columns, all optional: `airport name runway elevation_m|elevation_ft length_ft width_m|width_ft
 *  displaced_m|displaced_ft surface lighted closed one_way`. Without `one_way` the other end may be landed on as well.
 *  Values may carry a unit ("1640 ft"). The elevation is the terrain's where none is given, marked. Rows that cannot be
 *  used are left out, counted and listed by their line.   @errors BadFile, BadFormat - no such columns, an open quote */
Result<AirfieldReport> readOwnTable(const std::string& path, const mission::SiteFilter& filter, const std::optional<geo::GeoBox>& area);

/** The same from GeoJSON: a LineString is a runway from its first to its last place; a Point is the threshold. Properties
 *  are named like the columns of readOwnTable.   @errors BadFile, BadFormat - no GeoJSON features */
Result<AirfieldReport> readOwnGeoJson(const std::string& path, const mission::SiteFilter& filter, const std::optional<geo::GeoBox>& area);

enum class AirfieldFile { None, Airports, Runways, SeeYou, AptDat, OwnTable, GeoJson };

/** What kind of airfield file this is by its content; its name does not matter. None: none of them, or unreadable. */
AirfieldFile airfieldFileOf(const std::string& path);

/** Reads a source of a mission by what it is (airfieldFileOf); an airports table with its runways table.
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
