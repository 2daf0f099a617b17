#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/mission/plan.h"
#include "core/safety/checker.h"

#include <string>

namespace vp::cli {

/** Reads the plan's terrain afresh and lets core/safety judge the plan. @param planFolder  where relative terrain paths start */
Result<safety::SafetyReport> verify(const mission::Plan& plan, const std::string& planFolder, const Job& job);

/** Prints verdict, margins, warnings and findings for a person. */
void printReport(const mission::Plan& plan, const safety::SafetyReport& report);

/** The same for a program: a JSON object as text with a newline at its end. */
std::string reportToJson(const mission::Plan& plan, const safety::SafetyReport& report);

}  // namespace vp::cli
