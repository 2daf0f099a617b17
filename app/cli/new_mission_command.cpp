// volplane-cli new-mission: a mission file from terrain, airfields and targets.
#include "app/cli/commands.h"
#include "app/cli/json_text.h"
#include "app/cli/settings.h"
#include "app/cli/values.h"
#include "core/fetch/airfield_fetch.h"
#include "core/formats/aircraft_file.h"
#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/formats/mission_paths.h"
#include "core/mission/settings_check.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>

namespace vp::cli {
namespace {

struct NewMissionArguments {
  std::vector<std::string> terrain;
  std::string airports;
  std::string runways;
  std::string cache;
  std::vector<std::string> targets;
  std::string name;
  std::string aircraft = formats::kDefaultAircraft;
  double height = 100.0;
  std::optional<double> clearance;
  std::optional<double> ceiling;
  std::vector<std::string> wind;
  SettingOptions settings;
  std::string output;
  bool replace = false;
};

std::string absolute(const std::string& path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

/// "LAT,LON[,NAME[,HEIGHT]]"
Result<mission::Target> targetFrom(const std::string& text, std::size_t number, double height) {
  const std::vector<std::string> parts = partsOf(text);
  const auto wrong = [&](const std::string& why) {
    return fail(Errc::OutOfRange, why + "; give LATITUDE,LONGITUDE[,NAME[,HEIGHT]]", "--target " + text);
  };
  if (parts.size() < 2 || parts.size() > 4) {
    return wrong("this is no target");
  }
  const Result<std::vector<double>> place = numbersIn(parts[0] + "," + parts[1], 2);
  if (!place) {
    return wrong(place.error().what);
  }
  const Result<geo::LatLon> position = placeFrom((*place)[0], (*place)[1], "--target " + text);
  if (!position) {
    return forward(position);
  }
  mission::Target target;
  target.position = *position;
  target.name = parts.size() > 2 && !parts[2].empty() ? parts[2] : fmt::format("T{}", number);
  target.height_m = height;
  if (parts.size() == 4) {
    const Result<std::vector<double>> own = numbersIn(parts[3], 1);
    if (!own) {
      return wrong(own.error().what);
    }
    target.height_m = own->front();
  }
  return target;
}

/// The airfields named, else those that fetch-airfields fetched.
Result<mission::AirfieldSource> airfieldsOf(const NewMissionArguments& arguments) {
  if (!arguments.airports.empty()) {
    return mission::AirfieldSource{absolute(arguments.airports), arguments.runways.empty() ? "" : absolute(arguments.runways)};
  }
  fetch::AirfieldRequest request;
  request.cache = arguments.cache;
  const Result<std::optional<fetch::AirfieldFiles>> cached = fetch::cachedAirfields(request);
  if (!cached) {
    return forward(cached);
  }
  if (!*cached) {
    return fail(Errc::BadFile, "no airfields are here yet; run `volplane-cli fetch-airfields` first, or name files with --airports and --runways");
  }
  return mission::AirfieldSource{absolute((*cached)->airports), absolute((*cached)->runways)};
}

/// @param notes  receives what was ignored
Result<mission::Mission> missionFrom(const NewMissionArguments& arguments, std::vector<std::string>& notes) {
  mission::Mission made;
  made.name = arguments.name.empty() ? std::filesystem::path(arguments.output).stem().string() : arguments.name;
  for (const std::string& file : arguments.terrain) {
    made.terrain.push_back(absolute(file));
  }
  const Result<mission::AirfieldSource> airfields = airfieldsOf(arguments);
  if (!airfields) {
    return forward(airfields);
  }
  made.airfields = {*airfields};
  Result<aircraft::AircraftProfile> profile = formats::findAircraft(arguments.aircraft, ".");
  if (!profile) {
    return forward(profile);
  }
  made.aircraft = std::move(*profile);
  made.aircraftReference = arguments.aircraft;
  for (const std::string& text : arguments.targets) {
    Result<mission::Target> target = targetFrom(text, made.targets.size() + 1, arguments.height);
    if (!target) {
      return forward(target);
    }
    made.targets.push_back(std::move(*target));
  }
  if (arguments.clearance) {
    made.safety.clearance = Length::fromSi(*arguments.clearance);
  }
  if (arguments.ceiling) {
    made.ceiling = geo::HeightMsl::fromMetres(*arguments.ceiling);
  }
  if (const Result<void> applied = applyWind(arguments.wind, made, notes); !applied) {
    return forward(applied);
  }
  made.safety.reactionTime = Duration::fromSi(mission::kUsualReaction);
  if (const Result<void> applied = applySettings(arguments.settings, made); !applied) {
    return forward(applied);
  }
  return made;
}

int runNewMission(const NewMissionArguments& arguments, const Common& common) {
  std::error_code code;
  if (std::filesystem::exists(arguments.output, code) && !arguments.replace) {
    return report({Errc::OutputFailed, "the file is there already; choose another name, or give --replace", arguments.output}, common.json);
  }
  std::vector<std::string> notes;
  Result<mission::Mission> made = missionFrom(arguments, notes);
  if (!made) {
    return report(made.error(), common.json);
  }
  Console console(!common.quiet && !common.json);
  const Result<formats::LoadedMission> loaded = formats::loadMission(*made, "", console.job());
  console.finishProgress();
  if (!loaded) {
    return report(loaded.error(), common.json);
  }
  notes.insert(notes.end(), loaded->notes.begin(), loaded->notes.end());
  const std::vector<mission::AirfieldSource> airfields = made->airfields;
  formats::makePathsRelative(*made, absolute(folderOf(arguments.output)));
  if (arguments.airports.empty()) {
    made->airfields = airfields;  // the cache stays where it is when the mission moves
  }
  if (const Result<void> written = formats::writeMission(*made, arguments.output); !written) {
    return report(written.error(), common.json);
  }
  if (common.json) {
    fmt::print("{}",
               jsonText(nlohmann::ordered_json{
                   {"mission", arguments.output}, {"targets", loaded->targets.size()}, {"landingSites", loaded->sites.size()}, {"notes", notes}}));
  } else if (!common.quiet) {
    for (const std::string& note : notes) {
      fmt::print("note: {}\n", note);
    }
    fmt::print("wrote {}: {} targets, {} landing sites, aircraft {}\n", arguments.output, loaded->targets.size(), loaded->sites.size(),
               made->aircraft.name);
    const std::string plan = std::filesystem::path(arguments.output).replace_extension(".vpp").string();
    fmt::print("next: volplane-cli plan {} -o {}\n", arguments.output, plan);
  }
  return kDone;
}

}  // namespace

void addNewMissionCommand(CLI::App& app, Common& common, int& status) {
  auto arguments = std::make_shared<NewMissionArguments>();
  CLI::App* command = app.add_subcommand("new-mission", "Make a mission file from terrain, airfields and targets");
  command->add_option("--terrain", arguments->terrain, "Terrain file; give it once for each")->required()->allow_extra_args(false);
  command->add_option("--airports", arguments->airports, "airports.csv of OurAirports or a .cup; default: what fetch-airfields fetched");
  command->add_option("--runways", arguments->runways, "runways.csv of OurAirports");
  command->add_option("--cache", arguments->cache, "Folder that fetch-airfields fetched into");
  command->add_option("--target", arguments->targets, "LATITUDE,LONGITUDE[,NAME[,HEIGHT above ground in m]]; give it once for each")
      ->required()
      ->allow_extra_args(false);
  command->add_option("--height", arguments->height, "Height of targets above ground, m")->check(CLI::Range(0.0, 20000.0));
  command->add_option("--name", arguments->name, "Name of the mission; default: that of the file");
  command->add_option("--aircraft", arguments->aircraft, "Aircraft profile: a bundled name or a file")->capture_default_str();
  command->add_option("--clearance", arguments->clearance, "Height above terrain to keep everywhere, m")->check(CLI::Range(0.0, 5000.0));
  command->add_option("--ceiling", arguments->ceiling, "Highest altitude of the tour, m MSL")->check(CLI::Range(-500.0, 20000.0));
  command->add_option("--wind", arguments->wind, kWindHelp)->allow_extra_args(false);
  addSettingOptions(*command, arguments->settings);
  command->get_option("--reaction")->description("Time after the engine stops in which nothing is done, 0s to 60s; default: 4s");
  command->add_option("-o,--output", arguments->output, "Mission file to write (*.vpm)")->required();
  command->add_flag("--replace", arguments->replace, "Replace the file if there is one");
  command->callback([arguments, &common, &status] { status = runNewMission(*arguments, common); });
}

}  // namespace vp::cli
