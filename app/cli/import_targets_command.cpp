// volplane-cli import-targets MISSION FILE: adds the targets of another program's file to a mission.
#include "app/cli/commands.h"
#include "app/cli/json_text.h"
#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/formats/targets/target_import.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::cli {
namespace {

struct ImportArguments {
  std::string mission;
  std::string file;
  std::string output;
  double spacing = 500.0;
  std::optional<double> heading;
  std::optional<double> heightMsl;
  std::optional<double> heightAgl;
  bool fileHeights = false;
  bool tracks = false;
};

/// Names of the targets that cannot be planned on the mission's terrain, with the reasons.
Result<std::vector<std::string>> misplaced(const mission::Mission& mission, std::size_t first, const std::string& folder, const Job& job) {
  const Result<formats::LoadedTerrain> terrain = formats::loadTerrain(mission.terrain, folder, job);
  if (!terrain) {
    return forward(terrain);
  }
  std::vector<std::string> problems;
  for (std::size_t i = first; i < mission.targets.size(); ++i) {
    if (const auto placed = formats::placeTarget(mission.targets[i], terrain->frame, *terrain->grid); !placed) {
      problems.push_back(placed.error().what);
    }
  }
  return problems;
}

int runImport(const ImportArguments& given, const Common& common) {
  Result<mission::Mission> mission = formats::readMission(given.mission);
  if (!mission) {
    return report(mission.error(), common.json);
  }
  formats::TargetImportOptions options;
  options.spacing = Length::fromSi(given.spacing);
  options.lineCourse = given.heading ? std::optional(Angle::degrees(*given.heading)) : std::nullopt;
  options.heightMsl_m = given.heightMsl;
  options.heightAboveGround_m = given.heightAgl;
  options.fileHeights = given.fileHeights;
  options.tracks = given.tracks;
  const Result<formats::ImportedTargets> imported = formats::importTargets(given.file, options, mission->targets);
  if (!imported) {
    return report(imported.error(), common.json);
  }
  const std::size_t before = mission->targets.size();
  mission->targets.insert(mission->targets.end(), imported->targets.begin(), imported->targets.end());
  Console console(!common.quiet && !common.json);
  const Result<std::vector<std::string>> problems = misplaced(*mission, before, folderOf(given.mission), console.job());
  console.finishProgress();
  if (!problems) {
    return report(problems.error(), common.json);
  }
  const std::string output = given.output.empty() ? given.mission : given.output;
  if (const Result<void> written = formats::writeMission(*mission, output); !written) {
    return report(written.error(), common.json);
  }
  if (common.json) {
    fmt::print("{}", jsonText(nlohmann::ordered_json{{"file", output},
                                                     {"imported", imported->targets.size()},
                                                     {"surveyLines", imported->surveyLines},
                                                     {"notes", imported->notes},
                                                     {"unplannable", *problems}}));
  } else if (!common.quiet) {
    fmt::print("{}: {} targets added, {} in all\n", output, imported->targets.size(), mission->targets.size());
    for (const std::string& note : imported->notes) {
      fmt::print("  note: {}\n", note);
    }
    for (const std::string& problem : *problems) {
      fmt::print("  cannot be planned: {}\n", problem);
    }
  }
  return kDone;
}

}  // namespace

void addImportTargetsCommand(CLI::App& app, Common& common, int& status) {
  auto given = std::make_shared<ImportArguments>();
  CLI::App* command =
      app.add_subcommand("import-targets", "Add targets from SeeYou .cup, GPX, KML/KMZ, CSV, GeoJSON, QGroundControl .plan or Little Navmap .lnmpln");
  command->add_option("mission", given->mission, "The mission (*.vpm)")->required();
  command->add_option("file", given->file, "The file of targets; areas in it become survey lines")->required();
  command->add_option("-o,--output", given->output, "Write the mission there instead of back to its file");
  command->add_option("--spacing", given->spacing, "Metres between survey lines")->check(CLI::Range(1.0, 100000.0))->capture_default_str();
  command->add_option("--heading", given->heading, "True course of survey lines, degrees; otherwise along the longest side")
      ->check(CLI::Range(0.0, 360.0));
  CLI::Option* msl = command->add_option("--height", given->heightMsl, "Metres above sea level for all targets")->check(CLI::Range(-500.0, 20000.0));
  CLI::Option* agl = command->add_option("--agl", given->heightAgl, "Metres above ground for all targets; 100 where the file says nothing")
                         ->check(CLI::Range(0.0, 20000.0));
  msl->excludes(agl);
  command->add_flag("--file-heights", given->fileHeights, "Take elevations of .cup, GPX and .lnmpln as heights to fly at");
  command->add_flag("--tracks", given->tracks, "Take the points of tracks too");
  command->callback([given, &common, &status] { status = runImport(*given, common); });
}

}  // namespace vp::cli
