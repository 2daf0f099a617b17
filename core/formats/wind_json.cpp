#include "core/formats/wind_json.h"

#include "core/aircraft/wind_check.h"

#include <fmt/format.h>

#include <utility>

namespace vp::formats {
namespace {

using aircraft::WindFault;

constexpr Range kAltitude{aircraft::kLowestWind, aircraft::kHighestWind, "m"};
constexpr Range kFrom{0.0, 360.0, "degrees"};
constexpr Range kSpread{0.0, 180.0, "degrees"};
constexpr Range kSpeed{0.0, aircraft::kMostWind, "m/s"};

air::WindSector readSector(ObjectReader& reader) {
  air::WindSector wind;
  wind.from_deg = reader.number("from_deg", kFrom);
  wind.spread_deg = reader.number("spread_deg", kSpread, 0.0);
  if (reader.has("speed_mps")) {
    wind.leastSpeed = wind.mostSpeed = reader.number("speed_mps", kSpeed);
    for (const char* name : {"leastSpeed_mps", "mostSpeed_mps"}) {
      if (reader.has(name)) {
        reader.report(Errc::BadFormat, name, "a wind has either speed_mps or leastSpeed_mps and mostSpeed_mps");
      }
    }
  } else if (reader.has("leastSpeed_mps") || reader.has("mostSpeed_mps")) {
    wind.leastSpeed = reader.number("leastSpeed_mps", kSpeed);
    wind.mostSpeed = reader.number("mostSpeed_mps", kSpeed);
  } else {
    reader.number("speed_mps", kSpeed);  // reports that it is missing
  }
  return wind;
}

/// The member that a fault is about.
std::string fieldOf(const WindFault& fault, const air::WindSector& wind) {
  const bool isOneSpeed = wind.leastSpeed == wind.mostSpeed;
  switch (fault.value) {
    case WindFault::Value::Altitude:
      return "altitude_m";
    case WindFault::Value::From:
      return "from_deg";
    case WindFault::Value::Spread:
      return "spread_deg";
    case WindFault::Value::LeastSpeed:
      return isOneSpeed ? "speed_mps" : "leastSpeed_mps";
    case WindFault::Value::MostSpeed:
      break;
  }
  return isOneSpeed ? "speed_mps" : "mostSpeed_mps";
}

void report(const WindFault& fault, const std::vector<air::WindLayer>& winds, const std::string& pointer, ReadContext& context) {
  context.report(Errc::OutOfRange, fmt::format("{}/{}/{}", pointer, fault.layer, fieldOf(fault, winds[fault.layer].wind)), fault.sentence);
}

}  // namespace

JsonValue windToJson(const std::vector<air::WindLayer>& winds) {
  JsonValue json = JsonValue::array();
  for (const air::WindLayer& layer : winds) {
    JsonValue one = JsonValue::object();
    one.set("altitude_m", layer.altitude.metres());
    one.set("from_deg", layer.wind.from_deg);
    if (layer.wind.spread_deg != 0.0) {
      one.set("spread_deg", layer.wind.spread_deg);
    }
    if (layer.wind.leastSpeed == layer.wind.mostSpeed) {
      one.set("speed_mps", layer.wind.mostSpeed);
    } else {
      one.set("leastSpeed_mps", layer.wind.leastSpeed);
      one.set("mostSpeed_mps", layer.wind.mostSpeed);
    }
    json.push(std::move(one));
  }
  return json;
}

std::vector<air::WindLayer> readWindMember(ObjectReader& reader) {
  std::vector<air::WindLayer> winds;
  for (const auto& [value, pointer] : reader.elements("wind")) {
    ObjectReader inner(*value, pointer, reader.context());
    air::WindLayer layer;
    layer.altitude = geo::HeightMsl::fromMetres(inner.number("altitude_m", kAltitude));
    layer.wind = readSector(inner);
    inner.finish();
    winds.push_back(layer);
  }
  if (reader.context().error()) {
    return winds;  // of values that stand for those not read nothing more can be said
  }
  if (const auto fault = aircraft::windFault(winds)) {
    report(*fault, winds, reader.pointerTo("wind"), reader.context());
  }
  return winds;
}

void checkWindAgainstAircraft(const mission::Mission& mission, const std::string& pointer, ReadContext& context) {
  if (context.error()) {
    return;
  }
  if (const auto fault = aircraft::windFault(mission.wind, mission.aircraft)) {
    report(*fault, mission.wind, pointer + "/wind", context);
  }
}

}  // namespace vp::formats
