// X-Plane flight plans. Source: developer.x-plane.com, flight plan files v11 (FMS 1100). Lines end with \n, fields are split by a
// space, so no ident has one. Choices: ADEP/ADES with their runways and rows of type 1 for home airports of 2 to 8 capitals and digits, else
// DEP/DES; every other row is type 28 (latitude/longitude), which needs no navigation data, so any four-digit CYCLE serves.
#include "core/formats/exports/writers.h"

#include <fmt/format.h>

namespace vp::formats::exports {
namespace {

constexpr const char* kCycle = "1710";  // that of the format's own example
const IdentRules kIdents{10, false, "_", "_"};

/// A row's type and ident: an airport, or a place by its coordinates.
std::string typed(const ExportInput& input, const mission::RouteWaypoint& point, const std::string& ident) {
  const std::string airport = airportOf(input, point);
  return airport.empty() ? "28 " + ident : "1 " + airport;
}

/// "ADEP LSZS" and its runway, or "DEP TARGET_1". @param kind  DEP or DES
std::string endOf(const ExportInput& input, const mission::RouteWaypoint& point, const std::string& ident, const char* kind) {
  const std::string airport = airportOf(input, point);
  if (airport.empty()) {
    return fmt::format("{} {}\n", kind, ident);
  }
  const std::string runway = runwayOf(input, point);
  return fmt::format("A{} {}\n{}", kind, airport, runway.empty() ? "" : fmt::format("{}RWY RW{}\n", kind, runway));
}

}  // namespace

Result<std::string> fms(const ExportInput& input) {
  const std::vector<const mission::RouteWaypoint*> points = pointsOf(input);
  const std::vector<std::string> idents = identsOf(input, points, kIdents);
  std::string text = fmt::format("I\n1100 Version\nCYCLE {}\n{}{}NUMENR {}\n", kCycle, endOf(input, *points.front(), idents.front(), "DEP"),
                                 endOf(input, *points.back(), idents.back(), "DES"), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const mission::RouteWaypoint& point = *points[i];
    const std::string end = i == 0 ? "DEP" : i + 1 == points.size() ? "DES" : "";
    const std::string via = end.empty() ? "DRCT" : airportOf(input, point).empty() ? end : "A" + end;
    text += fmt::format("{} {} {}.000000 {:.6f} {:.6f}\n", typed(input, point, idents[i]), via, feetOf(point.altitude), point.place.latitude_deg,
                        point.place.longitude_deg);
  }
  return text;
}

Result<std::string> fms3(const ExportInput& input) {
  const std::vector<const mission::RouteWaypoint*> points = pointsOf(input);
  const std::vector<std::string> idents = identsOf(input, points, kIdents);
  std::string text = fmt::format("I\n3 version\n1\n{}\n", points.size() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    text += fmt::format("{} {}.000000 {:.6f} {:.6f}\n", typed(input, *points[i], idents[i]), feetOf(points[i]->altitude),
                        points[i]->place.latitude_deg, points[i]->place.longitude_deg);
  }
  return text;
}

}  // namespace vp::formats::exports
