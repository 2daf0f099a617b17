// GPX 1.1: the waypoints as a route, the flown path with its arcs as a track. Elements in the order of gpx11.xsd.
#include "core/formats/exports/writers.h"
#include "core/formats/exports/xml_writer.h"

#include <fmt/format.h>

namespace vp::formats::exports {
namespace {

XmlWriter::Attributes position(geo::LatLon place, int decimals) {
  return {{"lat", fmt::format("{:.{}f}", place.latitude_deg, decimals)}, {"lon", fmt::format("{:.{}f}", place.longitude_deg, decimals)}};
}

}  // namespace

Result<std::string> gpx(const ExportInput& input) {
  const mission::Route& route = *input.route;
  XmlWriter xml;
  xml.open("gpx", {{"version", "1.1"},
                   {"creator", input.plan.createdBy.empty() ? "Volplane" : input.plan.createdBy},
                   {"xmlns", "http://www.topografix.com/GPX/1/1"},
                   {"xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"},
                   {"xsi:schemaLocation", "http://www.topografix.com/GPX/1/1 http://www.topografix.com/GPX/1/1/gpx.xsd"}});
  xml.open("metadata");
  xml.element("name", titleOf(input));
  xml.close();
  xml.open("rte");
  xml.element("name", titleOf(input));
  xml.element("desc",
              fmt::format("Fly-by turns of {:.0f} m radius; the path is at most {:.0f} m beside and {:.0f} m above the tour.{}{}",
                          route.waypoints.front().turnRadius, route.lateral, route.above, route.guarantee.empty() ? "" : " ", route.guarantee));
  for (const mission::RouteWaypoint* point : pointsOf(input)) {
    xml.open("rtept", position(point->place, 6));
    xml.element("ele", fmt::format("{:.4f}", point->altitude));
    xml.element("name", point->name);
    xml.element("cmt", altitudeNote(*point));
    xml.element("type", point->site >= 0 ? "runway" : point->target >= 0 ? "target" : "turn");
    xml.close();
  }
  xml.close();
  xml.open("trk");
  xml.element("name", titleOf(input) + ", flown");
  xml.open("trkseg");
  for (const mission::RoutePoint& point : route.flown) {
    xml.open("trkpt", position(point.place, 7));
    xml.element("ele", fmt::format("{:.2f}", point.altitude));
    xml.close();
  }
  return xml.finish();
}

}  // namespace vp::formats::exports
