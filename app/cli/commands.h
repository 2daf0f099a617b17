#pragma once

#include "app/cli/console.h"

#include <string>

namespace CLI {
class App;
}

namespace vp::cli {

/** Each command adds itself to the program and, when chosen, sets `status` to its exit status. */
void addPlanCommand(CLI::App& app, Common& common, int& status);
void addVerifyCommand(CLI::App& app, Common& common, int& status);
void addExportCommand(CLI::App& app, Common& common, int& status);
void addRenderCommand(CLI::App& app, Common& common, int& status);
void addBriefCommand(CLI::App& app, Common& common, int& status);
void addInfoCommand(CLI::App& app, Common& common, int& status);
void addFetchTerrainCommand(CLI::App& app, Common& common, int& status);
void addFetchAirfieldsCommand(CLI::App& app, Common& common, int& status);
void addNewMissionCommand(CLI::App& app, Common& common, int& status);
void addSafeAltitudeCommand(CLI::App& app, Common& common, int& status);
void addImportTargetsCommand(CLI::App& app, Common& common, int& status);
void addLandCommand(CLI::App& app, Common& common, int& status);

/** "volplane-cli 0.1.0" */
std::string programVersion();

}  // namespace vp::cli
