#include "core/formats/weather_json.h"

#include <string>
#include <utility>

namespace vp::formats {
namespace {

constexpr Range kLatitude{-90.0, 90.0, "degrees"};
constexpr Range kLongitude{-180.0, 180.0, "degrees"};
constexpr Range kAltitude{-1000.0, 100000.0, "m"};  // as limits of airspaces
constexpr Range kSuccess{0.0, 1.0, "", true};
constexpr Range kPerDistance{0.0, 1e7, "m", true};

std::vector<geo::LatLon> readOutline(ObjectReader& reader) {
  std::vector<geo::LatLon> outline;
  reader.require("outline");
  for (const auto& [corner, pointer] : reader.elements("outline")) {
    const auto* place = corner->as<JsonValue::Array>();
    if (place == nullptr || place->size() != 2) {
      reader.context().report(Errc::BadFormat, pointer, "must be [longitude, latitude] in degrees");
      break;
    }
    const double longitude = readNumber((*place)[0], pointer + "/0", kLongitude, reader.context());
    outline.push_back({readNumber((*place)[1], pointer + "/1", kLatitude, reader.context()), longitude});
  }
  if (outline.size() < 3) {
    reader.report(Errc::OutOfRange, "outline", "a weather cell needs three corners or more");
  }
  return outline;
}

}  // namespace

JsonValue weatherToJson(const std::vector<mission::WeatherCell>& cells) {
  JsonValue json = JsonValue::array();
  for (const mission::WeatherCell& cell : cells) {
    JsonValue one = JsonValue::object();
    if (!cell.name.empty()) {
      one.set("name", cell.name);
    }
    JsonValue outline = JsonValue::array();
    for (const geo::LatLon& corner : cell.outline) {
      JsonValue place = JsonValue::array();
      place.push(corner.longitude_deg);
      place.push(corner.latitude_deg);
      outline.push(std::move(place));
    }
    one.set("outline", std::move(outline));
    if (cell.floor) {
      one.set("floor_m", *cell.floor);
    }
    if (cell.top) {
      one.set("top_m", *cell.top);
    }
    one.set("success", cell.success);
    one.set("perDistance_m", cell.perDistance);
    json.push(std::move(one));
  }
  return json;
}

std::vector<mission::WeatherCell> readWeatherMember(ObjectReader& reader) {
  std::vector<mission::WeatherCell> cells;
  for (const auto& [value, pointer] : reader.elements("weather")) {
    ObjectReader inner(*value, pointer, reader.context());
    mission::WeatherCell cell;
    cell.name = inner.text("name", std::string());
    cell.outline = readOutline(inner);
    cell.floor = inner.maybeNumber("floor_m", kAltitude);
    cell.top = inner.maybeNumber("top_m", kAltitude);
    cell.success = inner.number("success", kSuccess);
    cell.perDistance = inner.number("perDistance_m", kPerDistance, cell.perDistance);
    if (cell.floor && cell.top && !(*cell.floor < *cell.top)) {
      inner.report(Errc::OutOfRange, "top_m", "the top must be above the floor");
    }
    inner.finish();
    cells.push_back(std::move(cell));
  }
  return cells;
}

}  // namespace vp::formats
