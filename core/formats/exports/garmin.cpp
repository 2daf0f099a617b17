// Garmin flight plan (FlightPlan v1) and user waypoints. Identifiers of at most 6 capitals and digits, which every unit shows; a
// place that is passed twice stands once in the table and twice in the route (xsd:key, xsd:keyref); comments of [A-Z0-9 /].
#include "core/formats/exports/writers.h"
#include "core/formats/exports/xml_writer.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

namespace vp::formats::exports {
namespace {

const IdentRules kIdents{6, false, "", ""};
const IdentRules kComment{17, false, " /", " "};
const IdentRules kName{25, false, " /", " "};
constexpr const char* kType = "USER WAYPOINT";

std::string altitudeComment(const mission::RouteWaypoint& point) {
  return restrictedTo(fmt::format("ALT {}FT", feetOf(point.altitude)), kComment);
}

}  // namespace

Result<std::string> fpl(const ExportInput& input) {
  const std::vector<const mission::RouteWaypoint*> places = placesOf(input);
  const std::vector<std::string> table = identsOf(input, places, kIdents);
  const std::vector<std::string> route = identsOf(input, pointsOf(input), kIdents);
  XmlWriter xml;
  xml.open("flight-plan", {{"xmlns", "http://www8.garmin.com/xmlschemas/FlightPlan/v1"}});
  xml.element("created", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))));
  xml.open("waypoint-table");
  for (std::size_t i = 0; i < places.size(); ++i) {
    xml.open("waypoint");
    xml.element("identifier", table[i]);
    xml.element("type", kType);
    xml.element("country-code", "");
    xml.element("lat", fmt::format("{:.6f}", places[i]->place.latitude_deg));
    xml.element("lon", fmt::format("{:.6f}", places[i]->place.longitude_deg));
    xml.element("comment", altitudeComment(*places[i]));
    xml.element("elevation", fmt::format("{:.4f}", places[i]->altitude));
    xml.close();
  }
  xml.close();
  xml.open("route");
  xml.element("route-name", restrictedTo(titleOf(input), kName));
  xml.element("flight-plan-index", "1");
  for (const std::string& ident : route) {
    xml.open("route-point");
    xml.element("waypoint-identifier", ident);
    xml.element("waypoint-type", kType);
    xml.element("waypoint-country-code", "");
    xml.close();
  }
  return xml.finish();
}

Result<std::string> wpt(const ExportInput& input) {
  const std::vector<const mission::RouteWaypoint*> places = placesOf(input);
  const std::vector<std::string> idents = identsOf(input, places, kIdents);
  std::string text;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::string name = restrictedTo(fmt::format("{} {}", altitudeComment(*places[i]), places[i]->name), kName);
    text += fmt::format("{},{},{:.8f},{:.8f}\n", idents[i], name, places[i]->place.latitude_deg, places[i]->place.longitude_deg);
  }
  return text;
}

}  // namespace vp::formats::exports
