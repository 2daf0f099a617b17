// volplane-cli info FILE: what a mission, plan, aircraft profile or terrain file holds.
#include "app/cli/commands.h"
#include "app/cli/json_text.h"
#include "app/cli/settings.h"
#include "core/aircraft/glide_model.h"
#include "core/formats/aircraft_file.h"
#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/formats/plan_file.h"
#include "core/formats/wind_text.h"
#include "core/terrain/terrain_reader.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>

namespace vp::cli {
namespace {

using Json = nlohmann::ordered_json;

Json aircraftToJson(const aircraft::AircraftProfile& profile) {
  const aircraft::GlideModel glide(profile);
  Json banks = Json::array();
  for (const Angle bank : profile.glideBanks) {
    banks.push_back({{"bank_deg", bank.degrees()},
                     {"radius_m", glide.radiusOf(bank)},
                     {"descent_deg", Angle::radians(std::atan(glide.lossAt(glide.radiusOf(bank)))).degrees()}});
  }
  return {{"kind", "aircraft"},
          {"id", profile.id},
          {"name", profile.name},
          {"glideSpeed_mps", profile.bestGlideSpeed.si()},
          {"glideRatio", 1.0 / glide.straightLoss()},
          {"turns", banks},
          {"warnings", aircraft::profileWarnings(profile)},
          {"sources", profile.sources}};
}

/// What a profile need not say: masses, propeller, landing, climb, power settings.
void printLimits(const aircraft::AircraftProfile& profile) {
  const auto ratioWith = [&profile](aircraft::Propeller propeller) {
    aircraft::GlideConditions conditions;
    conditions.propeller = propeller;
    return 1.0 / aircraft::GlideModel(profile, conditions).straightLoss();
  };
  if (profile.leastMass_kg || profile.mostMass_kg) {
    const aircraft::SpeedRange speeds = aircraft::glideSpeeds(profile, std::nullopt);
    fmt::print("  masses {:.0f} to {:.0f} kg: best glide at {:.0f} to {:.0f} kt\n", profile.leastMass_kg.value_or(profile.mass_kg),
               profile.mostMass_kg.value_or(profile.mass_kg), speeds.least / kMpsPerKnot, speeds.most / kMpsPerKnot);
  }
  if (profile.windmillingDrag) {
    fmt::print("  propeller windmilling: glides {:.1f} : 1\n", ratioWith(aircraft::Propeller::Windmilling));
  }
  if (profile.stoppedDrag) {
    fmt::print("  propeller stopped: glides {:.1f} : 1\n", ratioWith(aircraft::Propeller::Stopped));
  }
  if (profile.steepestDescent) {
    fmt::print("  steepest descent without engine {:.1f} degrees\n", profile.steepestDescent->degrees());
  }
  if (profile.rollRate_dps) {
    fmt::print("  rolls at {:.1f} degrees per second\n", *profile.rollRate_dps);
  }
  if (profile.landingDistance) {
    fmt::print("  lands in {:.0f} m over 15 m at sea level, no wind, dry hard runway\n", profile.landingDistance->si());
  }
  if (profile.climbRate) {
    fmt::print("  climbs {:.0f} ft/min at sea level{}\n", profile.climbRate->si() * 60.0 / kMetresPerFoot,
               profile.serviceCeiling ? fmt::format(", service ceiling {:.0f} ft", profile.serviceCeiling->feet()) : "");
  }
  mission::Mission flown;
  flown.aircraft = profile;
  for (const aircraft::PowerSetting& power : profile.powerSettings) {
    flown.powerSetting = power.name;
    fmt::print("  {}\n", settingWords(flown).back());
  }
}

void printAircraft(const aircraft::AircraftProfile& profile) {
  const aircraft::GlideModel glide(profile);
  fmt::print("aircraft {}: glides {:.1f} : 1 at {:.1f} m/s ({:.0f} kt), {:.2f} degrees down\n", profile.name, 1.0 / glide.straightLoss(),
             profile.bestGlideSpeed.si(), profile.bestGlideSpeed.si() / kMpsPerKnot, Angle::radians(std::atan(glide.straightLoss())).degrees());
  for (const Angle bank : profile.glideBanks) {
    const double radius = glide.radiusOf(bank);
    fmt::print("  {:2.0f} degrees of bank: radius {:.1f} m, {:.1f} degrees down, {:.0f} m lost in a half turn\n", bank.degrees(), radius,
               Angle::radians(std::atan(glide.lossAt(radius))).degrees(), glide.lossAt(radius) * radius * Angle::kPi);
  }
  printLimits(profile);
  for (const std::string& warning : aircraft::profileWarnings(profile)) {
    fmt::print("  warning: {}\n", warning);
  }
}

Json windToJson(const std::vector<air::WindLayer>& winds) {
  Json layers = Json::array();
  for (const air::WindLayer& layer : winds) {
    layers.push_back({{"altitude_m", layer.altitude.metres()},
                      {"from_deg", layer.wind.from_deg},
                      {"spread_deg", layer.wind.spread_deg},
                      {"leastSpeed_mps", layer.wind.leastSpeed},
                      {"mostSpeed_mps", layer.wind.mostSpeed}});
  }
  return {{"text", formats::windText(winds)}, {"words", formats::windWords(winds)}, {"layers", layers}};
}

/// What the glides have to hold for.
void printConditions(const mission::Mission& mission) {
  for (const std::string& line : formats::windWords(mission.wind)) {
    fmt::print("  wind {}\n", line);
  }
  for (const std::string& line : settingWords(mission)) {
    fmt::print("  {}\n", line);
  }
}

int infoMission(const std::string& path, const Common& common) {
  const Result<mission::Mission> mission = formats::readMission(path);
  if (!mission) {
    return report(mission.error(), common.json);
  }
  Console console(!common.quiet && !common.json);
  const Result<formats::LoadedMission> loaded = formats::loadMission(*mission, folderOf(path), console.job());
  console.finishProgress();
  if (!loaded) {
    return report(loaded.error(), common.json);
  }
  if (common.json) {
    Json json{{"kind", "mission"},
              {"name", mission->name},
              {"targets", Json::array()},
              {"sites", Json::array()},
              {"notes", loaded->notes},
              {"aircraft", aircraftToJson(mission->aircraft)},
              {"wind", windToJson(mission->wind)},
              {"settings", settingWords(*mission)}};
    for (const mission::TargetInFrame& target : loaded->targets) {
      json["targets"].push_back({{"name", target.target.name},
                                 {"latitude_deg", target.target.position.latitude_deg},
                                 {"longitude_deg", target.target.position.longitude_deg},
                                 {"altitude_m", target.altitude}});
    }
    for (const mission::SiteInFrame& site : loaded->sites) {
      json["sites"].push_back({{"id", site.site.id},
                               {"name", site.site.airportName},
                               {"elevation_m", site.site.elevation.metres()},
                               {"landingCourse_deg", site.site.landingCourse.degrees()},
                               {"approximate", site.site.isApproximate()}});
    }
    fmt::print("{}", jsonText(json));
    return kDone;
  }
  fmt::print("mission {}: {} targets, {} landing sites, terrain cells of {:.0f} m\n", mission->name, loaded->targets.size(), loaded->sites.size(),
             loaded->terrain->cellSize());
  for (const mission::TargetInFrame& target : loaded->targets) {
    fmt::print("  target {:<12} {:.5f}, {:.5f}  {:.0f} m MSL\n", target.target.name, target.target.position.latitude_deg,
               target.target.position.longitude_deg, target.altitude);
  }
  for (const mission::SiteInFrame& site : loaded->sites) {
    fmt::print("  site {:<12} {:<28} {:.0f} m MSL, landing course {:03.0f}{}{}\n", site.site.id, site.site.airportName, site.site.elevation.metres(),
               site.site.landingCourse.degrees(), site.site.length ? fmt::format(", {:.0f} m", site.site.length->si()) : "",
               site.site.isApproximate() ? ", approximate" : "");
  }
  printConditions(*mission);
  printAircraft(mission->aircraft);
  for (const std::string& note : loaded->notes) {
    fmt::print("  note: {}\n", note);
  }
  return kDone;
}

int infoPlan(const std::string& path, const Common& common) {
  const Result<mission::Plan> plan = formats::readPlan(path);
  if (!plan) {
    return report(plan.error(), common.json);
  }
  const mission::PlanMetrics& m = plan->metrics;
  if (common.json) {
    fmt::print("{}", jsonText(Json{{"kind", "plan"},
                                   {"name", plan->mission.name},
                                   {"createdBy", plan->createdBy},
                                   {"targets", plan->targets.size()},
                                   {"points", plan->tour.size()},
                                   {"cost_m", m.cost},
                                   {"length_m", m.length},
                                   {"penalty_m", m.penalty},
                                   {"wind", windToJson(plan->mission.wind)},
                                   {"settings", settingWords(plan->mission)},
                                   {"claimsCertificate", plan->certificate.has_value()}}));
    return kDone;
  }
  fmt::print("plan {} by {}: {} targets, {} decision points, length {:.0f} m, cost {:.0f} m\n", plan->mission.name, plan->createdBy,
             plan->targets.size(), plan->tour.size(), m.length, m.cost);
  printConditions(plan->mission);
  fmt::print("  {}\n", flightWords(*plan));
  fmt::print("  {}\n", plan->certificate ? plan->certificate->statement : "UNVERIFIED: no certificate");
  fmt::print("  the certificate is a claim of the file; `volplane-cli verify {}` checks it\n", path);
  return kDone;
}

int infoTerrain(const std::string& path, const Common& common) {
  const Result<terrain::TerrainInfo> info = terrain::inspectTerrain({path});
  if (!info) {
    return report(info.error(), common.json);
  }
  const terrain::TerrainInfo::File& file = info->files.front();
  if (common.json) {
    fmt::print("{}", jsonText(Json{{"kind", "terrain"},
                                   {"driver", file.driver},
                                   {"crs", file.crs},
                                   {"columns", file.columns},
                                   {"rows", file.rows},
                                   {"spacing_m", file.spacing_m},
                                   {"south_deg", file.southWest.latitude_deg},
                                   {"west_deg", file.southWest.longitude_deg},
                                   {"north_deg", file.northEast.latitude_deg},
                                   {"east_deg", file.northEast.longitude_deg}}));
    return kDone;
  }
  fmt::print("terrain {} ({}, {}): {} x {} posts, {:.1f} m apart, latitude {:.4f} to {:.4f}, longitude {:.4f} to {:.4f}\n", path, file.driver,
             file.crs, file.columns, file.rows, file.spacing_m, file.southWest.latitude_deg, file.northEast.latitude_deg,
             file.southWest.longitude_deg, file.northEast.longitude_deg);
  return kDone;
}

int infoAircraft(const std::string& path, const Common& common) {
  const Result<aircraft::AircraftProfile> profile = formats::readAircraft(path);
  if (!profile) {
    return report(profile.error(), common.json);
  }
  if (common.json) {
    fmt::print("{}", jsonText(aircraftToJson(*profile)));
  } else {
    printAircraft(*profile);
  }
  return kDone;
}

int runInfo(const std::string& path, const Common& common) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    return report({Errc::BadFile, "no such file; check the path", path}, common.json);
  }
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".vpm") {
    return infoMission(path, common);
  }
  if (ending == ".vpp") {
    return infoPlan(path, common);
  }
  if (ending == ".json") {
    return infoAircraft(path, common);
  }
  return infoTerrain(path, common);
}

}  // namespace

void addInfoCommand(CLI::App& app, Common& common, int& status) {
  auto path = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("info", "Say what a mission, plan, aircraft profile (*.json) or terrain file holds");
  command->add_option("file", *path, "The file")->required();
  command->callback([path, &common, &status] { status = runInfo(*path, common); });
}

}  // namespace vp::cli
