// A table (RFC 4180): the waypoints in flying order, then the decision points of the tour with what their glides need.
#include "core/formats/exports/writers.h"

#include <fmt/format.h>

namespace vp::formats::exports {
namespace {

/// Quoted where it has to be. A text that a spreadsheet would take for a formula gets a space in front.
std::string quoted(const std::string& text) {
  std::string result;
  if (!text.empty() && std::string("=+-@").find(text.front()) != std::string::npos) {
    result += ' ';
  }
  for (const char c : text) {
    result += c;
    result += c == '"' ? "\"" : "";
  }
  return result.find_first_of(",\"\r\n") == std::string::npos ? result : "\"" + result + "\"";
}

/// Decision points with what their glides need. @param guaranteed  the first that has a glide
void addPoints(const mission::Plan& plan, const std::vector<mission::DecisionPoint>& points, const char* kind, int guaranteed, std::string& text) {
  const geo::LocalFrame frame(plan.frameOrigin);
  double distance = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const mission::DecisionPoint& point = points[i];
    const geo::LatLon place = frame.toLatLon(point.pose.point());
    const std::string site = point.witness.site >= 0 ? plan.sites[static_cast<std::size_t>(point.witness.site)].site.id : "";
    const std::string name = point.target >= 0 ? plan.targets[static_cast<std::size_t>(point.target)].target.name : "";
    const bool isGuaranteed = static_cast<int>(i) >= guaranteed;
    const std::string glide = isGuaranteed ? fmt::format("{:.2f},{:.2f}", point.safeAltitude, point.altitude - point.safeAltitude) : ",";
    text +=
        fmt::format("{},{},{},{:.7f},{:.7f},{:.1f},{:.2f},{:.1f},,{},{},{}\r\n", kind, i + 1, quoted(name), place.latitude_deg, place.longitude_deg,
                    point.altitude / kMetresPerFoot, point.altitude, distance, glide, quoted(site), isGuaranteed ? "" : "no gliding guarantee yet");
    distance += point.onward.length;
  }
}

}  // namespace

Result<std::string> csv(const ExportInput& input) {
  const mission::Plan& plan = input.plan;
  std::string text =
      "kind,number,name,latitude_deg,longitude_deg,altitude_msl_ft,altitude_msl_m,distance_m,turn_deg,safe_altitude_msl_m,margin_m,landing_site,"
      "note\r\n";
  int number = 0;
  for (const mission::RouteWaypoint* point : pointsOf(input)) {
    const bool isLast = number > 0 && point == &input.route->waypoints.front();
    const char* kind = point->site >= 0 ? "runway" : point->target >= 0 ? "target" : "waypoint";
    text += fmt::format("{},{},{},{:.6f},{:.6f},{},{:.4f},{:.1f},{:.2f},,,,{}\r\n", kind, ++number, quoted(point->name), point->place.latitude_deg,
                        point->place.longitude_deg, feetOf(point->altitude), point->altitude, isLast ? input.route->length : point->distance,
                        point->turn_deg, quoted(point->note));
  }
  addPoints(plan, plan.tour, "decisionPoint", 0, text);
  if (plan.departure && plan.arrival) {
    addPoints(plan, plan.departure->points, "departurePoint", plan.departure->guaranteed, text);
    addPoints(plan, plan.arrival->points, "arrivalPoint", 0, text);
  }
  return text;
}

}  // namespace vp::formats::exports
