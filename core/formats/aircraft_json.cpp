#include "core/formats/aircraft_json.h"

#include "core/aircraft/glide_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace vp::formats {
namespace {

constexpr Range kBank{0.0, 80.0, "degrees", true};  // a level turn at 80 degrees pulls 5.8 g
constexpr Range kPitch{0.0, 45.0, "degrees", true};
constexpr Range kSpeed{1.0, 200.0, "m/s"};  // model aircraft to jets well below transonic speed
constexpr Range kRunwayWind{0.0, 50.0, "m/s"};
constexpr Range kMaxSpeed{1.0, 350.0, "m/s"};
constexpr Range kEnergy{0.0, 1e6, ""};  // litres, kilograms or watt hours
constexpr Range kCeiling{-500.0, 20000.0, "m"};

constexpr Range kMass{0.0, 600000.0, "kg", true};
constexpr Range kDrag{0.0, 1.0, "", true};
constexpr Range kRollRate{1.0, 360.0, "degrees per second"};  // an airliner rolls by 10 or more, an aerobatic aircraft by 360

const std::vector<std::string> kEnergyUnits{"l", "kg", "Wh"};

JsonValue powerSettingsToJson(const std::vector<aircraft::PowerSetting>& settings) {
  JsonValue json = JsonValue::array();
  for (const aircraft::PowerSetting& setting : settings) {
    JsonValue one = JsonValue::object();
    one.set("name", setting.name);
    one.set("trueAirspeed_mps", setting.trueAirspeed.si());
    one.set("perHour", setting.perHour);
    one.set("unit", kEnergyUnits.at(static_cast<std::size_t>(setting.unit)));
    json.push(std::move(one));
  }
  return json;
}

std::vector<aircraft::PowerSetting> readPowerSettings(ObjectReader& reader) {
  std::vector<aircraft::PowerSetting> settings;
  for (const auto& [value, pointer] : reader.elements("powerSettings")) {
    ObjectReader inner(*value, pointer, reader.context());
    aircraft::PowerSetting setting;
    setting.name = inner.text("name");
    setting.trueAirspeed = Speed::fromSi(inner.number("trueAirspeed_mps", kSpeed));
    setting.perHour = inner.number("perHour", kEnergy);
    setting.unit = static_cast<aircraft::PowerSetting::Unit>(inner.word("unit", kEnergyUnits, -1));
    inner.finish();
    settings.push_back(std::move(setting));
  }
  return settings;
}

/// What a profile need not say.
void writeOptional(JsonValue& json, const aircraft::AircraftProfile& profile) {
  const auto set = [&json](const char* name, const auto& value, auto numberOf) {
    if (value) {
      json.set(name, numberOf(*value));
    }
  };
  const auto plain = [](double value) { return value; };
  const auto si = [](auto quantity) { return quantity.si(); };
  const auto metres = [](geo::HeightMsl height) { return height.metres(); };
  set("stallSpeed_mps", profile.stallSpeed, si);
  set("maxLoadFactor", profile.maxLoadFactor, plain);
  set("ceiling_m", profile.ceiling, metres);
  set("maxTailwind_mps", profile.maxTailwind, si);
  set("maxCrosswind_mps", profile.maxCrosswind, si);
  set("leastMass_kg", profile.leastMass_kg, plain);
  set("mostMass_kg", profile.mostMass_kg, plain);
  set("windmillingDrag", profile.windmillingDrag, plain);
  set("stoppedDrag", profile.stoppedDrag, plain);
  set("maxSpeed_mps", profile.maxSpeed, si);
  if (profile.steepestDescent) {
    writeAngle(json, "steepestDescent", *profile.steepestDescent);
  }
  set("rollRate_dps", profile.rollRate_dps, plain);
  set("landingDistance_m", profile.landingDistance, si);
  set("climbRate_mps", profile.climbRate, si);
  set("serviceCeiling_m", profile.serviceCeiling, metres);
  if (!profile.powerSettings.empty()) {
    json.set("powerSettings", powerSettingsToJson(profile.powerSettings));
  }
  set("usableEnergy", profile.usableEnergy, plain);
}

void readOptional(ObjectReader& reader, aircraft::AircraftProfile& profile) {
  const auto speed = [&reader](const char* name, const Range& range) {
    const std::optional<double> value = reader.maybeNumber(name, range);
    return value ? std::optional(Speed::fromSi(*value)) : std::nullopt;
  };
  const auto altitude = [&reader](const char* name) {
    const std::optional<double> value = reader.maybeNumber(name, kCeiling);
    return value ? std::optional(geo::HeightMsl::fromMetres(*value)) : std::nullopt;
  };
  profile.stallSpeed = speed("stallSpeed_mps", kSpeed);
  profile.maxLoadFactor = reader.maybeNumber("maxLoadFactor", {1.0, 20.0});
  profile.ceiling = altitude("ceiling_m");
  profile.maxTailwind = speed("maxTailwind_mps", kRunwayWind);
  profile.maxCrosswind = speed("maxCrosswind_mps", kRunwayWind);
  profile.leastMass_kg = reader.maybeNumber("leastMass_kg", kMass);
  profile.mostMass_kg = reader.maybeNumber("mostMass_kg", kMass);
  profile.windmillingDrag = reader.maybeNumber("windmillingDrag", kDrag);
  profile.stoppedDrag = reader.maybeNumber("stoppedDrag", kDrag);
  profile.maxSpeed = speed("maxSpeed_mps", kMaxSpeed);
  if (reader.has("steepestDescent_deg") || reader.has("steepestDescent_rad")) {
    profile.steepestDescent = reader.angle("steepestDescent", kPitch);
  }
  profile.rollRate_dps = reader.maybeNumber("rollRate_dps", kRollRate);
  if (const auto distance = reader.maybeNumber("landingDistance_m", {0.0, 10000.0, "m", true})) {
    profile.landingDistance = Length::fromSi(*distance);
  }
  profile.climbRate = speed("climbRate_mps", {0.0, 100.0, "m/s", true});
  profile.serviceCeiling = altitude("serviceCeiling_m");
  profile.powerSettings = readPowerSettings(reader);
  profile.usableEnergy = reader.maybeNumber("usableEnergy", kEnergy);
}

/// A member and what is wrong with it; "" if nothing is.
struct Contradiction {
  std::string member;
  std::string sentence;
};

Contradiction massContradiction(const aircraft::AircraftProfile& profile) {
  if (profile.leastMass_kg && *profile.leastMass_kg > profile.mass_kg) {
    return {"leastMass_kg", fmt::format("the least mass of {} kg is above the mass of the polar, {} kg", *profile.leastMass_kg, profile.mass_kg)};
  }
  if (profile.mostMass_kg && *profile.mostMass_kg < profile.mass_kg) {
    return {"mostMass_kg", fmt::format("the greatest mass of {} kg is below the mass of the polar, {} kg", *profile.mostMass_kg, profile.mass_kg)};
  }
  return {};
}

Contradiction speedContradiction(const aircraft::AircraftProfile& profile) {
  if (profile.maxSpeed && *profile.maxSpeed <= profile.bestGlideSpeed) {
    return {"maxSpeed_mps", fmt::format("the speed never to be exceeded, {} m/s, is not above the speed of best glide, {} m/s",
                                        profile.maxSpeed->si(), profile.bestGlideSpeed.si())};
  }
  // Flaps, brakes and slips only add drag.
  if (profile.steepestDescent && tan(*profile.steepestDescent) < aircraft::GlideModel(profile).straightLoss()) {
    return {"steepestDescent_deg",
            fmt::format("the steepest descent of {:.2f} degrees is shallower than the glide, {:.2f} degrees", profile.steepestDescent->degrees(),
                        Angle::radians(std::atan(aircraft::GlideModel(profile).straightLoss())).degrees())};
  }
  return {};
}

Contradiction powerContradiction(const aircraft::AircraftProfile& profile) {
  for (std::size_t i = 0; i < profile.powerSettings.size(); ++i) {
    const aircraft::PowerSetting& one = profile.powerSettings[i];
    const auto member = [i](const char* name) { return fmt::format("powerSettings/{}/{}", i, name); };
    const auto sameName = [&one](const aircraft::PowerSetting& other) { return other.name == one.name; };
    if (std::find_if(profile.powerSettings.begin(), profile.powerSettings.end(), sameName) !=
        profile.powerSettings.begin() + static_cast<std::ptrdiff_t>(i)) {
      return {member("name"), fmt::format("{} is given twice; names must differ", quoteJson(one.name))};
    }
    if (one.unit != profile.powerSettings.front().unit) {
      return {member("unit"), "all power settings of an aircraft must count in the same unit"};
    }
    if (profile.stallSpeed && one.trueAirspeed <= *profile.stallSpeed) {
      return {member("trueAirspeed_mps"), fmt::format("the airspeed of {}, {} m/s, is not above the stall speed of {} m/s", quoteJson(one.name),
                                                      one.trueAirspeed.si(), profile.stallSpeed->si())};
    }
    if (profile.maxSpeed && one.trueAirspeed > *profile.maxSpeed) {
      return {member("trueAirspeed_mps"), fmt::format("the airspeed of {}, {} m/s, is above the speed never to be exceeded, {} m/s",
                                                      quoteJson(one.name), one.trueAirspeed.si(), profile.maxSpeed->si())};
    }
  }
  if (profile.usableEnergy && profile.powerSettings.empty()) {
    return {"usableEnergy", "fuel or charge is counted in the unit of the power settings, and there are none; add one, or leave it out"};
  }
  return {};
}

/// Drag above weight with the propeller windmilling or stopped.
Contradiction propellerContradiction(const aircraft::AircraftProfile& profile) {
  const auto glides = [&profile](aircraft::Propeller propeller) {
    aircraft::GlideConditions conditions;
    conditions.propeller = propeller;
    const aircraft::GlideModel model(profile, conditions);
    return std::isfinite(model.straightLoss()) && std::all_of(profile.glideBanks.begin(), profile.glideBanks.end(),
                                                              [&model](Angle bank) { return std::isfinite(model.lossAt(model.radiusOf(bank))); });
  };
  if (profile.windmillingDrag && !glides(aircraft::Propeller::Windmilling)) {
    return {"windmillingDrag", "with the propeller windmilling drag exceeds weight, no glide exists; check it against zeroLiftDrag"};
  }
  if (profile.stoppedDrag && !glides(aircraft::Propeller::Stopped)) {
    return {"stoppedDrag", "with the propeller stopped drag exceeds weight, no glide exists; check it against zeroLiftDrag"};
  }
  return {};
}

void checkOptional(const aircraft::AircraftProfile& profile, ObjectReader& reader) {
  for (const auto& check : {massContradiction, speedContradiction, powerContradiction, propellerContradiction}) {
    if (const Contradiction found = check(profile); !found.member.empty()) {
      reader.report(Errc::OutOfRange, found.member, found.sentence);
      return;
    }
  }
}

/// Numbers that only together make sense.
void checkConsistency(const aircraft::AircraftProfile& profile, ObjectReader& reader) {
  if (reader.context().error()) {
    return;
  }
  if (profile.glideBanks.empty()) {
    reader.report(Errc::OutOfRange, "glideBanks_deg", "at least one bank angle is needed, a glide must be able to turn");
    return;
  }
  for (std::size_t i = 1; i < profile.glideBanks.size(); ++i) {
    if (profile.glideBanks[i] <= profile.glideBanks[i - 1]) {
      reader.report(Errc::OutOfRange, "glideBanks_deg", "bank angles must ascend and none be given twice");
      return;
    }
  }
  if (profile.stallSpeed && *profile.stallSpeed >= profile.bestGlideSpeed) {
    reader.report(Errc::OutOfRange, "stallSpeed_mps", "must be below bestGlideSpeed_mps, or the aircraft stalls in its glide");
    return;
  }
  const aircraft::GlideModel model(profile);
  if (!std::isfinite(model.straightLoss())) {
    reader.report(Errc::OutOfRange, "bestGlideSpeed_mps",
                  "at this speed drag exceeds weight, no glide exists; check speed, mass, wing area and polar");
    return;
  }
  for (const Angle bank : profile.glideBanks) {
    if (!std::isfinite(model.lossAt(model.radiusOf(bank)))) {
      reader.report(Errc::OutOfRange, "glideBanks_deg",
                    fmt::format("at {:.1f} degrees of bank drag exceeds weight, no glide exists; leave this bank angle out", bank.degrees()));
      return;
    }
  }
  checkOptional(profile, reader);
}

}  // namespace

JsonValue aircraftToJson(const aircraft::AircraftProfile& profile) {
  JsonValue json = JsonValue::object();
  json.set("id", profile.id);
  json.set("name", profile.name);
  json.set("mass_kg", profile.mass_kg);
  json.set("wingArea_m2", profile.wingArea_m2);
  json.set("zeroLiftDrag", profile.zeroLiftDrag);
  json.set("inducedDrag", profile.inducedDrag);
  json.set("airDensity_kgm3", profile.airDensity_kgm3);
  json.set("bestGlideSpeed_mps", profile.bestGlideSpeed.si());
  writeAngles(json, "glideBanks", profile.glideBanks);
  writeAngle(json, "tourBank", profile.tourBank);
  writeAngle(json, "maxClimb", profile.maxClimb);
  writeAngle(json, "maxDescent", profile.maxDescent);
  writeOptional(json, profile);
  json.set("sources", JsonValue::strings(profile.sources));
  return json;
}

aircraft::AircraftProfile readAircraftObject(const JsonValue& value, const std::string& pointer, ReadContext& context, bool isFile) {
  aircraft::AircraftProfile profile;
  ObjectReader reader(value, pointer, context);
  if (isFile || reader.has("format") || reader.has("version")) {
    if (!checkHeader(reader, kAircraftFormat, 1)) {
      return profile;
    }
  }
  profile.id = reader.text("id", std::string());
  profile.name = reader.text("name");
  profile.mass_kg = reader.number("mass_kg", kMass);
  profile.wingArea_m2 = reader.number("wingArea_m2", {0.0, 1000.0, "m2", true});
  profile.zeroLiftDrag = reader.number("zeroLiftDrag", kDrag);
  profile.inducedDrag = reader.number("inducedDrag", kDrag);
  profile.airDensity_kgm3 = reader.number("airDensity_kgm3", {0.1, 1.6, "kg/m3"});
  profile.bestGlideSpeed = Speed::fromSi(reader.number("bestGlideSpeed_mps", kSpeed));
  profile.glideBanks = reader.angles("glideBanks", kBank);
  profile.tourBank = reader.angle("tourBank", kBank);
  profile.maxClimb = reader.angle("maxClimb", kPitch);
  profile.maxDescent = reader.angle("maxDescent", kPitch);
  readOptional(reader, profile);
  profile.sources = reader.texts("sources");
  reader.finish();
  checkConsistency(profile, reader);
  return profile;
}

}  // namespace vp::formats
