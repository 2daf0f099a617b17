// FlightGear flight plan. Its reader counts the children of <route> and asks for wp n = 0...N-1, so <route> holds nothing else.
// Departure and destination must be airports that FlightGear knows: given for home runways, left out where a tour begins at a target.
#include "core/formats/exports/writers.h"
#include "core/formats/exports/xml_writer.h"

#include <fmt/format.h>

namespace vp::formats::exports {
namespace {

void airport(XmlWriter& xml, const char* name, const ExportInput& input, const mission::RouteWaypoint& point) {
  const std::string ident = airportOf(input, point);
  if (ident.empty()) {
    return;
  }
  xml.open(name);
  xml.element("airport", ident, {{"type", "string"}});
  if (const std::string runway = runwayOf(input, point); !runway.empty()) {
    xml.element("runway", runway, {{"type", "string"}});
  }
  xml.close();
}

}  // namespace

Result<std::string> fgfp(const ExportInput& input) {
  const std::vector<const mission::RouteWaypoint*> points = pointsOf(input);
  const std::vector<std::string> idents = identsOf(input, points, {10, true, "_-", "_"});
  XmlWriter xml;
  xml.open("PropertyList");
  xml.element("version", "2", {{"type", "int"}});
  airport(xml, "departure", input, *points.front());
  airport(xml, "destination", input, *points.back());
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
