// FlightGear flight plan. Its reader counts the children of <route> and asks for wp n = 0...N-1, so <route> holds nothing else.
// Departure and destination are left out: they must be airports that FlightGear knows, and a tour begins at a target.
#include "core/formats/exports/writers.h"
#include "core/formats/exports/xml_writer.h"

#include <fmt/format.h>

namespace vp::formats::exports {

Result<std::string> fgfp(const ExportInput& input) {
  const std::vector<const mission::RouteWaypoint*> points = pointsOf(input);
  const std::vector<std::string> idents = identsOf(input, points, {10, true, "_-", "_"});
  XmlWriter xml;
  xml.open("PropertyList");
  xml.element("version", "2", {{"type", "int"}});
  xml.open("route");
  for (std::size_t i = 0; i < points.size(); ++i) {
    xml.open("wp", {{"n", std::to_string(i)}});
    xml.element("type", "basic", {{"type", "string"}});
    xml.element("alt-restrict", "at", {{"type", "string"}});
    xml.element("altitude-ft", std::to_string(feetOf(points[i]->altitude)), {{"type", "double"}});
    xml.element("ident", idents[i], {{"type", "string"}});
    xml.element("lon", fmt::format("{:.6f}", points[i]->place.longitude_deg), {{"type", "double"}});
    xml.element("lat", fmt::format("{:.6f}", points[i]->place.latitude_deg), {{"type", "double"}});
    xml.close();
  }
  return xml.finish();
}

}  // namespace vp::formats::exports
