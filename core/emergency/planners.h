#pragma once

#include "core/emergency/landing_planner.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace vp::emergency {

/** Names of the planners that exist, in the order of help texts; "combined", which runs the best of the others, is the last: those before the
 * planners of [4], where there is weather the best of these too. A new planner is added to the table in planners.cpp. */
std::vector<std::string> plannerNames();

/** Those of them that "combined" runs, in the order in which it begins them: with weather the best of [4] first, else none of [4]. */
std::vector<std::string> combinedNames(bool hasWeather);

/** The planner of that name; null if there is none. */
std::unique_ptr<LandingPlanner> makePlanner(std::string_view name);

}  // namespace vp::emergency
