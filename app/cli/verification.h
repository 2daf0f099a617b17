#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/mission/plan.h"
#include "core/safety/checker.h"

#include <memory>
#include <string>
#include <vector>

namespace vp::cli {

/** Terrain of a plan as it is now. */
struct PlanTerrain {
  std::shared_ptr<const terrain::ElevationGrid> grid;
  std::vector<std::string> checksums;
};

/** @param planFolder  where relative terrain paths start   @errors those of formats::readPlanTerrain */
Result<PlanTerrain> readTerrain(const mission::Plan& plan, const std::string& planFolder, const Job& job);

/** Reads the plan's terrain afresh and lets core/safety judge the plan. @param planFolder  where relative terrain paths start */
Result<safety::SafetyReport> verify(const mission::Plan& plan, const std::string& planFolder, const Job& job);

/** Prints verdict, margins, warnings and findings for a person. */
void printReport(const mission::Plan& plan, const safety::SafetyReport& report);

/** The same for a program: a JSON object as text with a newline at its end. */
std::string reportToJson(const mission::Plan& plan, const safety::SafetyReport& report);

}  // namespace vp::cli
