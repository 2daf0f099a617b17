#include "core/formats/exports/export_formats.h"

#include "core/formats/exports/writers.h"

#include <algorithm>

namespace vp::formats {
namespace {

constexpr double kMicroDegree = 1e6;       // 0.11 m
constexpr double kCentiSecond = 360000.0;  // 0.31 m
constexpr double kMilliMinute = 60000.0;   // 1.85 m
constexpr std::size_t kGarminPoints = 99;  // G1000: 99 waypoints a plan
constexpr std::size_t kXPlanePoints = 99;  // not documented; as for the units that it imitates

}  // namespace

const std::vector<ExportFormat>& exportFormats() {
  static const std::vector<ExportFormat> list{
      {"fms", "fms", "X-Plane 11/12 flight plan (1100)",
       "turns are fly-by turns of the navigator, altitudes are rounded up to whole feet and some readers replace all by the highest, glides and "
       "margins are left out",
       kMicroDegree, kXPlanePoints, exports::fms, false},
      {"fms3", "fms", "X-Plane 10 flight plan (version 3)",
       "turns are fly-by turns of the navigator, altitudes are rounded up to whole feet and some readers replace all by the highest, glides and "
       "margins are left out",
       kMicroDegree, kXPlanePoints, exports::fms3, false},
      {"fpl", "fpl", "Garmin flight plan (G1000, GTN)",
       "altitudes and home runways are in the comments alone, a second runway of the home airport is a user waypoint, glides and margins are left "
       "out",
       kMicroDegree, kGarminPoints, exports::fpl},
      {"wpt", "wpt", "Garmin user waypoints", "altitudes are in the names alone, the order is that of the rows, glides and margins are left out",
       kMicroDegree, 0, exports::wpt},
      {"pln", "pln", "Microsoft Flight Simulator flight plan", "targets beyond ten letters are shortened, glides and margins are left out",
       kCentiSecond, 0, exports::pln},
      {"lnmpln", "lnmpln", "Little Navmap flight plan", "its reader moves places by up to half a metre, glides and margins are left out",
       kMicroDegree, 0, exports::lnmpln},
      {"plan", "plan", "QGroundControl plan", "names are left out, rally points stand for runways, glides and margins are left out", kMicroDegree, 0,
       exports::plan, false},
      {"cup", "cup", "SeeYou waypoints and tasks",
       "places are rounded to 1.85 m, a task has no altitudes: they are in the names and in the elevation column, glides and margins are left out",
       kMilliMinute, 0, exports::cup},
      {"gpx", "gpx", "GPX route and track", "glides and margins are left out", kMicroDegree, 0, exports::gpx},
      {"kml", "kml", "KML for Google Earth", "", kMicroDegree, 0, exports::kml},
      {"kmz", "kmz", "KMZ for Google Earth", "", kMicroDegree, 0, exports::kmz},
      {"fgfp", "fgfp", "FlightGear flight plan", "turns are those of its autopilot, glides and margins are left out", kMicroDegree, 0, exports::fgfp,
       false},
      {"geojson", "geojson", "GeoJSON for maps and GIS", "", kMicroDegree, 0, exports::geojson},
      {"gpkg", "gpkg", "GeoPackage for GIS", "", kMicroDegree, 0, exports::gpkg},
      {"csv", "csv", "Table of waypoints and decision points", "the paths of the glides are left out", kMicroDegree, 0, exports::csv},
  };
  return list;
}

const ExportFormat* findExportFormat(const std::string& name) {
  const std::vector<ExportFormat>& list = exportFormats();
  const auto format = std::find_if(list.begin(), list.end(), [&](const ExportFormat& f) { return f.name == name; });
  return format == list.end() ? nullptr : &*format;
}

}  // namespace vp::formats
