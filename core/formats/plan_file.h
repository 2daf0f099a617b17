#pragma once

#include "core/base/result.h"
#include "core/mission/plan.h"

#include <string>

namespace vp::formats {

/** Reads a *.vpp plan: JSON, format "volplane-plan", version 1 (resources/schema/plan.schema.json).
 *  Checks structure only: types, finite numbers of a sane size, indices in range, known words. A plan that is well
 *  formed but unsafe, tampered with included, is read as it is: core/safety judges it.
 *  @errors BadFile, BadFormat, OutOfRange, NewerVersion; each names file, line, column and member path */
Result<mission::Plan> readPlan(const std::string& path);

/** The same from text. @param file  name for errors */
Result<mission::Plan> parsePlan(const std::string& text, const std::string& file);

/** Writes planToJson(plan); the file appears whole or not at all.  @errors OutputFailed */
Result<void> writePlan(const mission::Plan& plan, const std::string& path);

/** The plan as JSON text. Every double comes back bit for bit (shortest form that does); the same plan gives the same
 *  bytes (no time, no host). One decision point per line; pieces are ["S", length], ["L" or "R", radius, length].
 *  @pre every number is finite, the radius of straight pieces is 0, the certificate's kinds are text */
std::string planToJson(const mission::Plan& plan);

}  // namespace vp::formats
