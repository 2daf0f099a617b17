// What the benchmark programs share: missions, clocks, result lines, and the checker's word on every plan.
#pragma once

#include "core/tour/planner.h"

#include <chrono>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vp::bench {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start);

/** Processor seconds of the calling thread: the steadier figure on a machine that others use too. */
double cpuSeconds();

/** Largest memory that this process has had so far [MiB]. */
double peakMemory();

/** Writes one result line (README.md). A `reference` that is not finite is left out. */
void print(const std::string& bench, std::string_view metric, double value, std::string_view unit = "", std::string_view note = "",
           double reference = NAN);

/** A mission file with all that it names. @errors of the readers */
Result<tour::PlanInput> load(const std::string& missionFile);

/** Folder with real terrain, airfields and tour instances: VOLPLANE_DATA, or data beside the checkout. Empty: there is none. */
std::string dataFolder();

/** Missions over real terrain by name, those of tests/app/tst_real_missions.cpp; a sentence on stderr and none without the data folder. */
std::vector<std::pair<std::string, mission::Mission>> realMissions();

/** 46 x 67 km around Davos with the Swiss landables, for its roadmap. @pre dataFolder() is not empty */
mission::Mission davos();
/** 20 M cells of the Victorian Alps with the airfields inside. @pre dataFolder() is not empty */
mission::Mission victorianAlps();

/** Loads such a mission. @errors of the readers */
Result<tour::PlanInput> load(const mission::Mission& mission, const std::string& folder = "");

/** Has core/safety judge a plan over the terrain that it was planned on, counts it, and says on stderr what is wrong with it. */
bool verify(const std::string& name, const tour::PlanInput& input, const mission::Plan& plan);

/** Counts a plan that should have been made and was not; says why on stderr. */
void countFailure(const std::string& name, const Error& error);

/** Writes how many plans the program made and how many the checker certified. @return the exit status: 1 if one was refused or is missing */
int verdict(const std::string& program);

}  // namespace vp::bench
