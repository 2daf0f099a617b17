#include "core/formats/settings_json.h"

#include <utility>
#include <vector>

namespace vp::formats {
namespace {

using mission::ApproachSettings;
using mission::Mission;
using Value = mission::SettingFault::Value;

const std::vector<std::string> kApproaches{"threshold", "straight", "overhead"};
const std::vector<std::string> kPropellers{"asInPolar", "windmilling", "stopped"};
constexpr Range kClearance{0.0, 5000.0, "m"};

constexpr Range rangeOf(const mission::Limits& limits, const char* unit, bool aboveLow = false) {
  return {limits.least, limits.most, unit, aboveLow};
}

template <typename Enum>
std::string wordOf(Enum value, const std::vector<std::string>& words) {
  return words.at(static_cast<std::size_t>(value));
}

JsonValue approachToJson(const ApproachSettings& approach) {
  const ApproachSettings usual;
  JsonValue json = JsonValue::object();
  json.set("kind", wordOf(approach.kind, kApproaches));
  if (approach.kind == mission::ApproachKind::Straight || approach.finalLength != usual.finalLength) {
    json.set("finalLength_m", approach.finalLength.si());
  }
  if (approach.slope) {
    writeAngle(json, "slope", *approach.slope);
  }
  if (approach.surfaceSlope) {
    json.set("surfaceSlope", *approach.surfaceSlope);
  }
  if (approach.surfaceSlope || approach.surfaceStart != usual.surfaceStart) {
    json.set("surfaceStart_m", approach.surfaceStart.si());
  }
  if (approach.keyHeight) {
    json.set("keyHeight_m", approach.keyHeight->si());
  }
  if (approach.hold) {
    json.set("hold", true);
  }
  return json;
}

ApproachSettings readApproach(ObjectReader reader) {
  ApproachSettings approach;
  approach.kind = static_cast<mission::ApproachKind>(reader.word("kind", kApproaches, static_cast<int>(approach.kind)));
  approach.finalLength = Length::fromSi(reader.number("finalLength_m", rangeOf(mission::kFinalLength, "m", true), approach.finalLength.si()));
  if (reader.has("slope_deg") || reader.has("slope_rad")) {
    approach.slope = reader.angle("slope", rangeOf(mission::kApproachSlope, "degrees", true));
  }
  approach.surfaceSlope = reader.maybeNumber("surfaceSlope", rangeOf(mission::kSurfaceSlope, "", true));
  approach.surfaceStart = Length::fromSi(reader.number("surfaceStart_m", rangeOf(mission::kSurfaceStart, "m"), approach.surfaceStart.si()));
  if (const auto height = reader.maybeNumber("keyHeight_m", rangeOf(mission::kKeyHeight, "m"))) {
    approach.keyHeight = Length::fromSi(*height);
  }
  approach.hold = reader.flag("hold", approach.hold);
  reader.finish();
  return approach;
}

air::Atmosphere readAtmosphere(ObjectReader reader) {
  air::Atmosphere atmosphere;
  atmosphere.temperatureOffset_K = reader.number("temperatureOffset_K", rangeOf(mission::kTemperatureOffset, "K"), atmosphere.temperatureOffset_K);
  atmosphere.qnh_hPa = reader.number("qnh_hPa", rangeOf(mission::kQnh, "hPa"), atmosphere.qnh_hPa);
  reader.finish();
  return atmosphere;
}

}  // namespace

JsonValue safetyToJson(const mission::SafetySettings& safety) {
  const mission::SafetySettings usual;
  JsonValue json = JsonValue::object();
  json.set("clearance_m", safety.clearance.si());
  json.set("arrivalMargin_m", safety.arrivalMargin.si());
  if (safety.reactionTime != usual.reactionTime) {
    json.set("reactionTime_s", safety.reactionTime.si());
  }
  if (safety.reactionLoss != usual.reactionLoss) {
    json.set("reactionLoss_m", safety.reactionLoss.si());
  }
  if (safety.dragFactor != usual.dragFactor) {
    json.set("dragFactor", safety.dragFactor);
  }
  return json;
}

mission::SafetySettings readSafety(ObjectReader reader) {
  mission::SafetySettings safety;
  safety.clearance = Length::fromSi(reader.number("clearance_m", kClearance, safety.clearance.si()));
  safety.arrivalMargin = Length::fromSi(reader.number("arrivalMargin_m", kClearance, safety.arrivalMargin.si()));
  safety.reactionTime = Duration::fromSi(reader.number("reactionTime_s", rangeOf(mission::kReactionTime, "s"), safety.reactionTime.si()));
  safety.reactionLoss = Length::fromSi(reader.number("reactionLoss_m", rangeOf(mission::kReactionLoss, "m"), safety.reactionLoss.si()));
  safety.dragFactor = reader.number("dragFactor", rangeOf(mission::kDragFactor, ""), safety.dragFactor);
  reader.finish();
  return safety;
}

void writeSettings(JsonValue& json, const Mission& mission) {
  if (mission.atmosphere) {
    JsonValue air = JsonValue::object();
    air.set("temperatureOffset_K", mission.atmosphere->temperatureOffset_K);
    air.set("qnh_hPa", mission.atmosphere->qnh_hPa);
    json.set("atmosphere", std::move(air));
  }
  if (!(mission.approach == ApproachSettings())) {
    json.set("approach", approachToJson(mission.approach));
  }
  if (mission.propeller != aircraft::Propeller::AsInPolar) {
    json.set("propeller", wordOf(mission.propeller, kPropellers));
  }
  if (!mission.powerSetting.empty()) {
    json.set("powerSetting", mission.powerSetting);
  }
}

void readSettings(ObjectReader& reader, Mission& mission) {
  ReadContext& context = reader.context();
  if (const JsonValue* air = reader.find("atmosphere")) {
    mission.atmosphere = readAtmosphere(ObjectReader(*air, reader.pointerTo("atmosphere"), context));
  }
  if (const JsonValue* approach = reader.find("approach")) {
    mission.approach = readApproach(ObjectReader(*approach, reader.pointerTo("approach"), context));
  }
  mission.propeller = static_cast<aircraft::Propeller>(reader.word("propeller", kPropellers, static_cast<int>(mission.propeller)));
  mission.powerSetting = reader.text("powerSetting", std::string());
}

std::string fieldOf(Value value) {
  static const std::vector<std::string> fields{
      "safety/reactionTime_s",   "safety/reactionLoss_m",  "safety/dragFactor",  "atmosphere/temperatureOffset_K",
      "atmosphere/qnh_hPa",      "approach/finalLength_m", "approach/slope_deg", "approach/surfaceSlope",
      "approach/surfaceStart_m", "approach/keyHeight_m",   "propeller",          "powerSetting"};
  return fields.at(static_cast<std::size_t>(value));
}

void checkSettingsAgainstAircraft(const Mission& mission, const std::string& pointer, ReadContext& context) {
  if (context.error()) {
    return;  // of values that stand for those not read nothing more can be said
  }
  if (const auto fault = mission::settingFaultForAircraft(mission)) {
    context.report(Errc::OutOfRange, pointer + "/" + fieldOf(fault->value), fault->sentence);
  }
}

}  // namespace vp::formats
