#pragma once

#include "core/base/result.h"
#include "core/safety/checker.h"

#include <optional>

namespace vp::jobs {

/** How planning ended. */
struct PlanningOutcome {
  enum class Kind { Verified, Refused, Failed, Cancelled };
  Kind kind = Kind::Cancelled;
  std::optional<Error> error;   ///< Failed
  safety::SafetyReport report;  ///< Verified, Refused
  double seconds = 0.0;
  bool isTourReused = false;            ///< Verified, Refused: placed what was edited into the tour before, without a search of the whole
  std::optional<double> missingHeight;  ///< Failed for lack of height: m that the ceiling is too low by
  int target = -1;                      ///< Failed: the target it failed at, if it was one
};

}  // namespace vp::jobs
