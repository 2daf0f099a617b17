#include "core/formats/export_formats.h"

#include "core/formats/flight_plan_fms.h"
#include "core/formats/geojson.h"

namespace vp::formats {

const std::vector<ExportFormat>& exportFormats() {
  static const std::vector<ExportFormat> list{
      {"fms", "fms", "X-Plane 11/12 flight plan (1100)",
       "arcs become straight legs, altitudes are rounded up to whole feet, glides and margins are left out",
       [](const mission::Plan& plan) { return toFms1100(plan); }},
      {"geojson", "geojson", "GeoJSON for maps and GIS", "", [](const mission::Plan& plan) -> Result<std::string> { return toGeoJson(plan); }},
  };
  return list;
}

}  // namespace vp::formats
