#include "core/formats/aircraft_json.h"

#include "core/aircraft/glide_model.h"

#include <fmt/format.h>

#include <cmath>

namespace vp::formats {
namespace {

constexpr Range kBank{0.0, 80.0, "degrees", true};  // a level turn at 80 degrees pulls 5.8 g
constexpr Range kPitch{0.0, 45.0, "degrees", true};
constexpr Range kSpeed{1.0, 200.0, "m/s"};  // model aircraft to jets well below transonic speed
constexpr Range kRunwayWind{0.0, 50.0, "m/s"};
constexpr Range kCeiling{-500.0, 20000.0, "m"};

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
  if (profile.stallSpeed) {
    json.set("stallSpeed_mps", profile.stallSpeed->si());
  }
  if (profile.maxLoadFactor) {
    json.set("maxLoadFactor", *profile.maxLoadFactor);
  }
  if (profile.ceiling) {
    json.set("ceiling_m", profile.ceiling->metres());
  }
  if (profile.maxTailwind) {
    json.set("maxTailwind_mps", profile.maxTailwind->si());
  }
  if (profile.maxCrosswind) {
    json.set("maxCrosswind_mps", profile.maxCrosswind->si());
  }
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
  profile.mass_kg = reader.number("mass_kg", {0.0, 600000.0, "kg", true});
  profile.wingArea_m2 = reader.number("wingArea_m2", {0.0, 1000.0, "m2", true});
  profile.zeroLiftDrag = reader.number("zeroLiftDrag", {0.0, 1.0, "", true});
  profile.inducedDrag = reader.number("inducedDrag", {0.0, 1.0, "", true});
  profile.airDensity_kgm3 = reader.number("airDensity_kgm3", {0.1, 1.6, "kg/m3"});
  profile.bestGlideSpeed = Speed::fromSi(reader.number("bestGlideSpeed_mps", kSpeed));
  profile.glideBanks = reader.angles("glideBanks", kBank);
  profile.tourBank = reader.angle("tourBank", kBank);
  profile.maxClimb = reader.angle("maxClimb", kPitch);
  profile.maxDescent = reader.angle("maxDescent", kPitch);
  if (const auto speed = reader.maybeNumber("stallSpeed_mps", kSpeed)) {
    profile.stallSpeed = Speed::fromSi(*speed);
  }
  profile.maxLoadFactor = reader.maybeNumber("maxLoadFactor", {1.0, 20.0});
  if (const auto ceiling = reader.maybeNumber("ceiling_m", kCeiling)) {
    profile.ceiling = geo::HeightMsl::fromMetres(*ceiling);
  }
  if (const auto speed = reader.maybeNumber("maxTailwind_mps", kRunwayWind)) {
    profile.maxTailwind = Speed::fromSi(*speed);
  }
  if (const auto speed = reader.maybeNumber("maxCrosswind_mps", kRunwayWind)) {
    profile.maxCrosswind = Speed::fromSi(*speed);
  }
  profile.sources = reader.texts("sources");
  reader.finish();
  checkConsistency(profile, reader);
  return profile;
}

}  // namespace vp::formats
