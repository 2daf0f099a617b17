// X-Plane flight plans. Source: developer.x-plane.com, flight plan files v11 (FMS 1100). Lines end with \n, fields are split by a
// space, so no ident has one. Choices: DEP/DES (not ADEP/ADES), as a tour starts at a target and no airport is part of it; every
// row is type 28 (latitude/longitude), which needs no navigation data, so any four-digit CYCLE serves.
#include "core/formats/exports/writers.h"

#include <fmt/format.h>

namespace vp::formats::exports {
namespace {

constexpr const char* kCycle = "1710";  // that of the format's own example
const IdentRules kIdents{10, false, "_", "_"};

}  // namespace

Result<std::string> fms(const ExportInput& input) {
  const std::vector<const mission::RouteWaypoint*> points = pointsOf(input);
  const std::vector<std::string> idents = identsOf(input, points, kIdents);
  std::string text = fmt::format("I\n1100 Version\nCYCLE {}\nDEP {}\nDES {}\nNUMENR {}\n", kCycle, idents.front(), idents.back(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const mission::RouteWaypoint& point = *points[i];
    const char* via = i == 0 ? "DEP" : i + 1 == points.size() ? "DES" : "DRCT";
    text += fmt::format("28 {} {} {}.000000 {:.6f} {:.6f}\n", idents[i], via, feetOf(point.altitude), point.place.latitude_deg,
                        point.place.longitude_deg);
  }
  return text;
}

Result<std::string> fms3(const ExportInput& input) {
  const std::vector<const mission::RouteWaypoint*> points = pointsOf(input);
  const std::vector<std::string> idents = identsOf(input, points, kIdents);
  std::string text = fmt::format("I\n3 version\n1\n{}\n", points.size() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    text += fmt::format("28 {} {}.000000 {:.6f} {:.6f}\n", idents[i], feetOf(points[i]->altitude), points[i]->place.latitude_deg,
                        points[i]->place.longitude_deg);
  }
  return text;
}

}  // namespace vp::formats::exports
