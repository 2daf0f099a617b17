// Waypoints and survey areas of a QGroundControl .plan.
#include "core/formats/json_value.h"
#include "core/formats/targets/found_targets.h"

#include <fmt/format.h>

#include <cmath>

namespace vp::formats {
namespace {

constexpr int kWaypoint = 16;  // MAV_CMD_NAV_WAYPOINT; 17 to 19 loiter there
constexpr int kLoiterLast = 19;
constexpr int kSplineWaypoint = 82;
constexpr int kFrameMsl = 0;       // MAV_FRAME_GLOBAL
constexpr int kFrameRelative = 3;  // above home
constexpr int kFrameTerrain = 10;

std::optional<double> numberAt(const JsonValue& list, std::size_t place) {
  const auto* values = list.as<JsonValue::Array>();
  if (values == nullptr || place >= values->size() || !(*values)[place].isNumber() || !std::isfinite((*values)[place].number())) {
    return std::nullopt;
  }
  return (*values)[place].number();
}

std::optional<geo::LatLon> placeAt(const JsonValue& list, std::size_t latitude) {
  const std::optional<double> north = numberAt(list, latitude);
  const std::optional<double> east = numberAt(list, latitude + 1);
  if (!north || !east || std::fabs(*north) > 90.0 || std::fabs(*east) > 180.0 || (*north == 0.0 && *east == 0.0)) {
    return std::nullopt;  // 0, 0 stands for "here" in commands without a place
  }
  return geo::LatLon{*north, *east};
}

int intOf(const JsonValue& object, const char* key) {
  const JsonValue* value = object.find(key);
  return value != nullptr && value->isNumber() && std::fabs(value->number()) < 1e6 ? static_cast<int>(value->number()) : -1;
}

void readArea(const JsonValue& item, const std::string& name, FoundTargets& found) {
  const JsonValue* polygon = item.find("polygon");
  const auto* corners = polygon == nullptr ? nullptr : polygon->as<JsonValue::Array>();
  FoundTargets::Area area{name, {}, {}};
  for (std::size_t i = 0; corners != nullptr && i < corners->size(); ++i) {
    if (const std::optional<geo::LatLon> corner = placeAt((*corners)[i], 0)) {
      area.ring.push_back(*corner);
    }
  }
  if (corners == nullptr || area.ring.size() < 3 || area.ring.size() < corners->size()) {
    found.leftOut.add("complex item without a polygon of places", name);
    return;
  }
  found.areas.push_back(std::move(area));
}

void readItem(const JsonValue& item, std::size_t number, std::optional<double> homeAltitude, FoundTargets& found) {
  const std::string name = fmt::format("item {}", number);
  const JsonValue* type = item.find("type");
  const std::string* kind = type == nullptr ? nullptr : type->as<std::string>();
  if (kind != nullptr && *kind == "ComplexItem") {
    readArea(item, name, found);
    return;
  }
  const int command = intOf(item, "command");
  if ((command < kWaypoint || command > kLoiterLast) && command != kSplineWaypoint) {
    found.leftOut.add("no waypoint (take-off, landing or another command)", name);
    return;
  }
  const JsonValue* params = item.find("params");
  const std::optional<geo::LatLon> position = params == nullptr ? std::nullopt : placeAt(*params, 4);
  if (!position) {
    found.leftOut.add("waypoint without a place", name);
    return;
  }
  FoundTargets::Place place{fmt::format("WP {}", number), *position, {}, {}};
  const std::optional<double> height = numberAt(*params, 6);
  const int frame = intOf(item, "frame");
  if (height && frame == kFrameTerrain) {
    place.heightAboveGround_m = height;
  } else if (height && frame == kFrameRelative && homeAltitude) {
    place.heightMsl_m = *homeAltitude + *height;
  } else if (height && frame == kFrameMsl) {
    place.heightMsl_m = height;
  } else {
    found.leftOut.add("height of a waypoint whose reference is unknown; the usual height is taken", name);
  }
  found.places.push_back(std::move(place));
}

}  // namespace

Result<void> findQgcTargets(const std::string& path, const std::string& text, FoundTargets& found) {
  const Result<JsonValue> json = parseJson(text, path);
  if (!json) {
    return forward(json);
  }
  const JsonValue* mission = json->find("mission");
  const JsonValue* items = mission == nullptr ? nullptr : mission->find("items");
  const auto* list = items == nullptr ? nullptr : items->as<JsonValue::Array>();
  if (list == nullptr) {
    return fail(Errc::BadFormat, "this is no QGroundControl plan: mission/items is missing", path);
  }
  const JsonValue* home = mission->find("plannedHomePosition");
  found.heightsAreFlown = true;
  for (std::size_t i = 0; i < list->size(); ++i) {
    readItem((*list)[i], i + 1, home == nullptr ? std::nullopt : numberAt(*home, 2), found);
  }
  return {};
}

}  // namespace vp::formats
