#include "app/cli/command_line.h"

#include "app/cli/commands.h"

#include <CLI/CLI.hpp>

#include <utility>

namespace vp::cli {

std::string programVersion() {
  return "volplane-cli " VOLPLANE_VERSION;
}

void defineCommandLine(CLI::App& app, Common& common, int& status, std::function<std::string()> version) {
  app.name("volplane-cli");
  app.description("Plans closed surveillance tours from every point of which the aircraft can glide to a runway.");
  app.set_version_flag("--version", std::move(version), "Print version, commit, libraries and data sources with their licences, and exit");
  app.require_subcommand(1);
  app.fallthrough();
  app.add_flag("--json", common.json, "Print results as JSON");
  app.add_flag("-q,--quiet", common.quiet, "Print errors only");
  addPlanCommand(app, common, status);
  addVerifyCommand(app, common, status);
  addExportCommand(app, common, status);
  addRenderCommand(app, common, status);
  addBriefCommand(app, common, status);
  addInfoCommand(app, common, status);
  addFetchTerrainCommand(app, common, status);
  addFetchAirfieldsCommand(app, common, status);
  addNewMissionCommand(app, common, status);
  addSafeAltitudeCommand(app, common, status);
  addImportTargetsCommand(app, common, status);
  addLandCommand(app, common, status);
}

}  // namespace vp::cli
