#pragma once

#include "core/base/result.h"
#include "core/formats/exports/export_input.h"

#include <string>

// One function a format, in the file of its name. All of them: positions as the route has them, which are multiples of what the
// format can hold; altitudes in whole feet where it holds feet; texts in the characters that it allows. Rules that were verified
// for each format and their sources stand at the head of the .cpp.
// @pre input.route is there for all but geojson   @errors OutputFailed - GDAL cannot write (kmz, gpkg)   @threads pure
namespace vp::formats::exports {

Result<std::string> fms(const ExportInput& input);     ///< X-Plane FMS 1100
Result<std::string> fms3(const ExportInput& input);    ///< X-Plane FMS 3
Result<std::string> fpl(const ExportInput& input);     ///< Garmin FlightPlan v1
Result<std::string> wpt(const ExportInput& input);     ///< Garmin user waypoints
Result<std::string> pln(const ExportInput& input);     ///< Microsoft Flight Simulator
Result<std::string> lnmpln(const ExportInput& input);  ///< Little Navmap
Result<std::string> plan(const ExportInput& input);    ///< QGroundControl
Result<std::string> cup(const ExportInput& input);     ///< SeeYou
Result<std::string> gpx(const ExportInput& input);     ///< GPX 1.1
Result<std::string> kml(const ExportInput& input);     ///< KML 2.2
Result<std::string> kmz(const ExportInput& input);     ///< the same, zipped
Result<std::string> fgfp(const ExportInput& input);    ///< FlightGear
Result<std::string> gpkg(const ExportInput& input);    ///< GeoPackage
Result<std::string> csv(const ExportInput& input);     ///< waypoints and decision points as a table

/** Plan, decision points, glides, targets and sites as GeoJSON, and the waypoints where there is a route (property "kind" tells
 *  which). Positions are [longitude, latitude, metres above MEAN SEA LEVEL]; RFC 7946 means heights above the ellipsoid, so every
 *  feature repeats its height as alt_msl_m and alt_msl_ft and the collection says so.
 *  @accuracy 7 decimals (1 cm); arcs are drawn as chords at most 0.5 m off.  @source RFC 7946 */
Result<std::string> geojson(const ExportInput& input);

}  // namespace vp::formats::exports
