// Microsoft Flight Simulator 2020 and FSX. UTF-8 with byte order mark, CRLF, four spaces; positions in degrees, minutes and seconds
// with two decimals, which never read 60.00; every waypoint has its ICAOIdent, without which a reader moved points to the pole.
#include "core/formats/exports/writers.h"
#include "core/formats/exports/xml_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace vp::formats::exports {
namespace {

const IdentRules kIdents{10, true, "_", "_"};  // FSX takes no more; MSFS 80

/// Whole hundredths of a second first, so that no rounding can reach 60 later.
std::string sexagesimal(double degrees, char positive, char negative) {
  constexpr long long kPerDegree = 360000;
  const long long hundredths = std::llround(degrees * static_cast<double>(kPerDegree));
  const long long size = std::llabs(hundredths);
  return fmt::format("{}{}\u00B0 {}' {}.{:02}\"", hundredths < 0 ? negative : positive, size / kPerDegree, size % kPerDegree / 6000,
                     size % 6000 / 100, size % 100);
}

std::string worldPosition(const mission::RouteWaypoint& point) {
  return fmt::format("{},{},{:+010.2f}", sexagesimal(point.place.latitude_deg, 'N', 'S'), sexagesimal(point.place.longitude_deg, 'E', 'W'),
                     static_cast<double>(feetOf(point.altitude)));
}

/// An element whose text has quotes as they are, as the simulator writes them.
void position(XmlWriter& xml, const std::string& name, const mission::RouteWaypoint& point) {
  xml.line("<" + name + ">" + worldPosition(point) + "</" + name + ">");
}

void header(XmlWriter& xml, const ExportInput& input, const std::vector<const mission::RouteWaypoint*>& points,
            const std::vector<std::string>& idents) {
  const auto highest = std::max_element(points.begin(), points.end(), [](const auto* a, const auto* b) { return a->altitude < b->altitude; });
  const std::string title = titleOf(input);
  xml.element("Title", title);
  xml.element("FPType", "VFR");
  xml.element("RouteType", "Direct");
  xml.element("CruisingAlt", std::to_string(feetOf((*highest)->altitude)));
  xml.element("DepartureID", idents.front());
  position(xml, "DepartureLLA", *points.front());
  xml.element("DestinationID", idents.back());
  position(xml, "DestinationLLA", *points.back());
  xml.element("Descr", title + ": altitudes of the waypoints are to be flown, not the cruising altitude alone." +
                           (input.route->guarantee.empty() ? "" : " " + input.route->guarantee));
  xml.element("DepartureName", points.front()->name);
  xml.element("DestinationName", points.back()->name);
  xml.open("AppVersion");
  xml.element("AppVersionMajor", "11");
  xml.element("AppVersionBuild", "282174");
  xml.close();
}

}  // namespace

Result<std::string> pln(const ExportInput& input) {
  const std::vector<const mission::RouteWaypoint*> points = pointsOf(input);
  std::vector<std::string> idents = identsOf(input, points, kIdents);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string airport = airportOf(input, *points[i]);
    idents[i] = airport.empty() ? idents[i] : airport;
  }
  XmlWriter xml("\r\n", 4);
  xml.open("SimBase.Document", {{"Type", "AceXML"}, {"version", "1,0"}});
  xml.element("Descr", "AceXML Document");
  xml.open("FlightPlan.FlightPlan");
  header(xml, input, points, idents);
  for (std::size_t i = 0; i < points.size(); ++i) {
    xml.open("ATCWaypoint", {{"id", idents[i]}});
    const bool isAirport = !airportOf(input, *points[i]).empty();
    xml.element("ATCWaypointType", isAirport ? "Airport" : "User");
    position(xml, "WorldPosition", *points[i]);
    if (const std::string runway = runwayOf(input, *points[i]); isAirport && !runway.empty()) {
      xml.element("RunwayNumberFP", std::to_string(std::stoi(runway)));
    }
    xml.open("ICAO");
    xml.element("ICAOIdent", idents[i]);
    xml.close();
    xml.close();
  }
  return "\xEF\xBB\xBF" + xml.finish();
}

}  // namespace vp::formats::exports
