#include "core/formats/airspace/airspace_json.h"

#include <fmt/format.h>

namespace vp::formats {
namespace {

const std::vector<std::string> kUses{"hide", "show", "warn", "forbid"};
const std::vector<std::string> kLimits{"surface", "msl", "aboveGround", "flightLevel", "unlimited", "unknown"};
constexpr Range kMetres{-1000.0, 100000.0, "m"};

JsonValue limitToJson(const mission::AirspaceLimit& limit) {
  JsonValue json = JsonValue::object();
  json.set("kind", kLimits.at(static_cast<std::size_t>(limit.kind)));
  if (limit.metres != 0.0) {
    json.set("metres", limit.metres);
  }
  return json;
}

mission::AirspaceLimit readLimit(ObjectReader& outer, const std::string& name) {
  const JsonValue* value = outer.require(name);
  if (value == nullptr) {
    return {};
  }
  ObjectReader reader(*value, outer.pointerTo(name), outer.context());
  const int kind = reader.word("kind", kLimits, -1);
  const mission::AirspaceLimit limit{static_cast<mission::AirspaceLimit::Kind>(std::max(0, kind)), reader.number("metres", kMetres, 0.0)};
  reader.finish();
  return limit;
}

}  // namespace

JsonValue airspaceSettingsToJson(const mission::AirspaceSettings& settings) {
  JsonValue json = JsonValue::object();
  json.set("files", JsonValue::strings(settings.files));
  JsonValue rules = JsonValue::array();
  for (const mission::AirspaceRule& rule : settings.rules) {
    JsonValue one = JsonValue::object();
    one.set(rule.name.empty() ? "kind" : "name", rule.name.empty() ? rule.kind : rule.name);
    one.set("use", kUses.at(static_cast<std::size_t>(rule.use)));
    rules.push(std::move(one));
  }
  json.set("rules", std::move(rules));
  json.set("otherwise", kUses.at(static_cast<std::size_t>(settings.otherwise)));
  return json;
}

mission::AirspaceSettings readAirspaceSettings(ObjectReader reader) {
  mission::AirspaceSettings settings;
  settings.files = reader.paths("files");
  for (const auto& [value, pointer] : reader.elements("rules")) {
    ObjectReader inner(*value, pointer, reader.context());
    mission::AirspaceRule rule{inner.text("kind", std::string()), inner.text("name", std::string()),
                               static_cast<mission::AirspaceUse>(std::max(0, inner.word("use", kUses, -1)))};
    if (rule.kind.empty() == rule.name.empty()) {
      inner.report(Errc::OutOfRange, "kind", "a rule needs either a kind or a name");
    }
    inner.finish();
    settings.rules.push_back(std::move(rule));
  }
  settings.otherwise = static_cast<mission::AirspaceUse>(reader.word("otherwise", kUses, static_cast<int>(settings.otherwise)));
  reader.finish();
  return settings;
}

JsonValue airspaceToJson(const mission::Airspace& airspace) {
  JsonValue json = JsonValue::object();
  json.set("name", airspace.name);
  json.set("kind", airspace.kind);
  json.set("floor", limitToJson(airspace.floor));
  json.set("ceiling", limitToJson(airspace.ceiling));
  JsonValue outline = JsonValue::array();
  for (const geo::LatLon& corner : airspace.outline) {
    JsonValue place = JsonValue::array();
    place.push(corner.longitude_deg);
    place.push(corner.latitude_deg);
    outline.push(std::move(place));
  }
  json.set("outline", std::move(outline));
  return json;
}

mission::Airspace readAirspace(ObjectReader reader) {
  mission::Airspace airspace;
  airspace.name = reader.text("name", std::string());
  airspace.kind = reader.text("kind", std::string());
  airspace.floor = readLimit(reader, "floor");
  airspace.ceiling = readLimit(reader, "ceiling");
  for (const auto& [corner, pointer] : reader.elements("outline")) {
    const auto* place = corner->as<JsonValue::Array>();
    if (place == nullptr || place->size() != 2) {
      reader.context().report(Errc::BadFormat, pointer, "must be [longitude, latitude] in degrees");
      break;
    }
    const double longitude = readNumber((*place)[0], pointer + "/0", {-180.0, 180.0, "degrees"}, reader.context());
    airspace.outline.push_back({readNumber((*place)[1], pointer + "/1", {-90.0, 90.0, "degrees"}, reader.context()), longitude});
  }
  if (airspace.outline.size() < 3) {
    reader.report(Errc::OutOfRange, "outline", "an airspace needs three corners or more");
  }
  reader.finish();
  return airspace;
}

}  // namespace vp::formats
