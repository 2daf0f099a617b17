// Garmin flight plan (FlightPlan v1) and user waypoints. Identifiers of at most 6 capitals and digits, which every unit shows; a
// place that is passed twice stands once in the table and twice in the route (xsd:key, xsd:keyref); comments of [A-Z0-9 /]. Home airports are of type
// AIRPORT, which units look up themselves; the format has no runways: the comment names them. An airport can stand in the table only once, so where
// the flight ends at another threshold of the airport that it began at, that one is a user waypoint.
#include "core/formats/exports/writers.h"
#include "core/formats/exports/xml_writer.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <map>
#include <set>
#include <tuple>

namespace vp::formats::exports {
namespace {

const IdentRules kIdents{6, false, "", ""};
const IdentRules kComment{17, false, " /", " "};
const IdentRules kName{25, false, " /", " "};
constexpr const char* kType = "USER WAYPOINT";
constexpr const char* kAirport = "AIRPORT";

/// With a word where the gliding guarantee begins and ends, and with the runway at the ends of the flight.
std::string altitudeComment(const ExportInput& input, const mission::RouteWaypoint& point) {
  const char* word = point.note.find("guarantee begins") != std::string::npos ? " BEGIN"
                     : point.note.find("guarantee ends") != std::string::npos ? " END"
                                                                              : "";
  const std::string runway = runwayOf(input, point);
  return restrictedTo(fmt::format("ALT {}FT{}{}", feetOf(point.altitude), word, runway.empty() ? "" : " RW" + runway), kComment);
}

/// How a point is called in the table and in the route.
struct Key {
  std::string ident;
  const char* type = kType;
  bool operator<(const Key& other) const { return std::tie(ident, type) < std::tie(other.ident, other.type); }
};

std::vector<Key> keysOf(const ExportInput& input, const std::vector<const mission::RouteWaypoint*>& points) {
  const std::vector<std::string> idents = identsOf(input, points, kIdents);
  std::vector<Key> keys;
  std::map<std::string, int> runways;  // that an airport stands for
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string airport = airportOf(input, *points[i]);
    const bool isAirport = !airport.empty() && runways.emplace(airport, points[i]->site).first->second == points[i]->site;
    keys.push_back(isAirport ? Key{airport, kAirport} : Key{idents[i], kType});
  }
  return keys;
}

}  // namespace

Result<std::string> fpl(const ExportInput& input) {
  const std::vector<const mission::RouteWaypoint*> places = placesOf(input);
  const std::vector<Key> table = keysOf(input, places);
  XmlWriter xml;
  xml.open("flight-plan", {{"xmlns", "http://www8.garmin.com/xmlschemas/FlightPlan/v1"}});
  xml.element("created", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))));
  xml.open("waypoint-table");
  std::set<Key> listed;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!listed.insert(table[i]).second) {
      continue;  // the same runway at both ends
    }
    xml.open("waypoint");
    xml.element("identifier", table[i].ident);
    xml.element("type", table[i].type);
    xml.element("country-code", "");
    xml.element("lat", fmt::format("{:.6f}", places[i]->place.latitude_deg));
    xml.element("lon", fmt::format("{:.6f}", places[i]->place.longitude_deg));
    xml.element("comment", altitudeComment(input, *places[i]));
    xml.element("elevation", fmt::format("{:.4f}", places[i]->altitude));
    xml.close();
  }
  xml.close();
  xml.open("route");
  xml.element("route-name", restrictedTo(titleOf(input), kName));
  xml.element("flight-plan-index", "1");
  for (const Key& key : keysOf(input, pointsOf(input))) {
    xml.open("route-point");
    xml.element("waypoint-identifier", key.ident);
    xml.element("waypoint-type", key.type);
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
    const std::string mark = input.route->mark.empty() ? "" : "DO NOT FLY ";
    const std::string name = restrictedTo(fmt::format("{}{} {}", mark, altitudeComment(input, *places[i]), places[i]->name), kName);
    text += fmt::format("{},{},{:.8f},{:.8f}\n", idents[i], name, places[i]->place.latitude_deg, places[i]->place.longitude_deg);
  }
  return text;
}

}  // namespace vp::formats::exports
