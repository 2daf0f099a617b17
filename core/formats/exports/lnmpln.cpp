// Little Navmap 1.2 (lnmpln.xsd). Pretty-printed, as its reader looks for the root in the first lines. Runways that glides of this
// tour lead to are alternates. Its reader keeps degrees as 32-bit numbers: 0.2 to 0.5 m.
#include "core/formats/exports/diversions.h"
#include "core/formats/exports/writers.h"
#include "core/formats/exports/xml_writer.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>

namespace vp::formats::exports {
namespace {

void position(XmlWriter& xml, geo::LatLon place, double altitude) {
  xml.empty("Pos", {{"Lon", fmt::format("{:.6f}", place.longitude_deg)},
                    {"Lat", fmt::format("{:.6f}", place.latitude_deg)},
                    {"Alt", fmt::format("{:.2f}", altitude / kMetresPerFoot)}});
}

}  // namespace

Result<std::string> lnmpln(const ExportInput& input) {
  const std::vector<const mission::RouteWaypoint*> points = pointsOf(input);
  const std::vector<std::string> idents = identsOf(input, points, {10, true, "_", "_"});
  const auto highest = std::max_element(points.begin(), points.end(), [](const auto* a, const auto* b) { return a->altitude < b->altitude; });
  XmlWriter xml;
  xml.open("LittleNavmap", {{"xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"},
                            {"xsi:noNamespaceSchemaLocation", "https://www.littlenavmap.org/schema/lnmpln.xsd"}});
  xml.open("Flightplan");
  xml.open("Header");
  xml.element("FlightplanType", "VFR");
  xml.element("CruisingAlt", std::to_string(feetOf((*highest)->altitude)));
  xml.element("CruisingAltF", fmt::format("{}.0000", feetOf((*highest)->altitude)));
  xml.element("Comment", titleOf(input) + ": fly the altitudes of the waypoints. Alternates are the airfields that a glide from this tour reaches." +
                             (input.route->guarantee.empty() ? "" : " " + input.route->guarantee));
  xml.element("CreationDate", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))));
  xml.element("FileVersion", "1.2");
  xml.element("ProgramName", "Volplane");
  xml.element("ProgramVersion", input.plan.createdBy);
  xml.element("Documentation", "https://www.littlenavmap.org/lnmpln.html");
  xml.close();
  if (!airportOf(input, *points.front()).empty()) {
    const mission::LandingSite& site = input.plan.sites[static_cast<std::size_t>(points.front()->site)].site;
    xml.open("Departure");
    position(xml, points.front()->place, points.front()->altitude);
    xml.element("Start", runwayOf(input, *points.front()));
    xml.element("Type", "Runway");
    xml.element("Heading", fmt::format("{:.1f}", site.landingCourse.degrees()));
    xml.close();
  }
  const std::vector<const mission::SiteInFrame*> alternates = diversionAirfields(input.plan);
  if (!alternates.empty()) {
    xml.open("Alternates");
    for (const mission::SiteInFrame* site : alternates) {
      xml.open("Alternate");
      xml.element("Name", site->site.airportName);
      xml.element("Ident", site->site.airportIdent.empty() ? site->site.id : site->site.airportIdent);
      xml.element("Type", "AIRPORT");
      position(xml, site->site.touchdown, site->site.elevation.metres());
      xml.close();
    }
    xml.close();
  }
  xml.open("Waypoints");
  for (std::size_t i = 0; i < points.size(); ++i) {
    xml.open("Waypoint");
    xml.element("Name", points[i]->name);
    const std::string airport = airportOf(input, *points[i]);
    xml.element("Ident", airport.empty() ? idents[i] : airport);
    xml.element("Type", airport.empty() ? "USER" : "AIRPORT");
    xml.element("Comment", (points[i]->target >= 0 ? "target, " : "") + altitudeNote(*points[i]));
    position(xml, points[i]->place, points[i]->altitude);
    xml.close();
  }
  return xml.finish();
}

}  // namespace vp::formats::exports
