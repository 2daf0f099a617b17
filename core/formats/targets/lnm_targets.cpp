// Waypoints of a Little Navmap flight plan; its airports are where the flight begins and ends, not targets.
#include "core/base/quantity.h"
#include "core/formats/targets/found_targets.h"
#include "core/formats/targets/xml_text.h"

#include <fmt/format.h>

namespace vp::formats {

Result<void> findLnmTargets(const std::string& path, const std::string& text, FoundTargets& found) {
  const Result<XmlText> xml = XmlText::parse(path, text);
  if (!xml) {
    return forward(xml);
  }
  const pugi::xml_node waypoints = childOf(childOf(xml->root(), "Flightplan"), "Waypoints");
  if (localName(xml->root()) != "LittleNavmap" || !waypoints) {
    return fail(Errc::BadFormat, "this is no Little Navmap flight plan: LittleNavmap/Flightplan/Waypoints is missing", path);
  }
  for (const pugi::xml_node node : waypoints.children("Waypoint")) {
    const std::string where = fmt::format("line {}", xml->lineOf(node));
    const std::string ident = textOf(node, "Ident");
    if (textOf(node, "Type") == "AIRPORT") {
      found.leftOut.add("airport of the flight plan", ident);
      continue;
    }
    const pugi::xml_node pos = childOf(node, "Pos");
    const std::optional<geo::LatLon> position = placeOfDegrees(pos.attribute("Lat").value(), pos.attribute("Lon").value());
    if (!position) {
      found.leftOut.add("Pos is no place in degrees", where);
      continue;
    }
    const std::optional<double> feet = parseNumber(pos.attribute("Alt").value());
    const std::string name = textOf(node, "Name");
    found.places.push_back({name.empty() ? ident : name, *position, feet ? std::optional(*feet * kMetresPerFoot) : std::nullopt, {}});
  }
  return {};
}

}  // namespace vp::formats
