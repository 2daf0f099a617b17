#pragma once

#include "core/base/result.h"
#include "core/mission/plan.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace vp::cli {

/** Options for air, pilot, engine and approach, the same in all commands that have them. What is not given leaves the mission's value. */
struct SettingOptions {
  std::optional<std::string> reaction;
  std::optional<std::string> reactionLoss;
  std::optional<double> dragFactor;
  std::optional<std::string> air;
  std::optional<double> qnh;
  std::optional<std::string> approach;
  std::optional<std::string> surface;
  bool hold = false;
  bool noHold = false;
  std::optional<std::string> propeller;
  std::optional<std::string> power;
};

/** Adds the options to a command, in a group of their own in its help. @pre `options` lives as long as the command */
void addSettingOptions(CLI::App& command, SettingOptions& options);

/** Gives a mission the values of the options, and refuses what its aircraft does not allow.
 *  @errors OutOfRange, with the option as its place where the value came from one */
Result<void> applySettings(const SettingOptions& options, mission::Mission& mission);

/** What a mission says of air, pilot, engine and approach, one line each; none where it is as in the source papers. */
std::vector<std::string> settingWords(const mission::Mission& mission);

/** How long the flight takes, how much it climbs, and what it takes of what is usable: "flight 0:42 h, 430 m of climb, 18.4 l of 151 l usable". */
std::string flightWords(const mission::Plan& plan);

}  // namespace vp::cli
