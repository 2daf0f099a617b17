#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/mission/plan.h"
#include "core/safety/checker.h"

namespace vp::cli {

/** Reads the plan's terrain afresh and lets core/safety judge the plan. @param planFolder  where relative terrain paths start */
Result<safety::SafetyReport> verify(const mission::Plan& plan, const std::string& planFolder, const Job& job);

/** Prints verdict, margins, warnings and findings for a person. */
void printReport(const mission::Plan& plan, const safety::SafetyReport& report);

/** The same for a program. */
nlohmann::ordered_json reportToJson(const mission::Plan& plan, const safety::SafetyReport& report);

/** A JSON value as text; bytes that are no UTF-8 are replaced. */
std::string jsonText(const nlohmann::ordered_json& value);

}  // namespace vp::cli
