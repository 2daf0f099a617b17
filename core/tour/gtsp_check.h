#pragma once

#include "core/base/result.h"
#include "core/tour/gtsp.h"

#include <vector>

namespace vp::tour {

/** Whether a problem makes sense: at least one set, none empty, every node in exactly one, costs not negative and not
 *  NaN. @errors OutOfRange */
Result<void> checkProblem(const GtspProblem& problem);

/** Whether options make sense for a problem that does: limits in range, a warm start with one node per set.
 *  @errors OutOfRange */
Result<void> checkOptions(const GtspProblem& problem, const GtspOptions& options);

/** The same closed tour, beginning with its node of set 0. */
std::vector<int> fromSetZero(const GtspProblem& problem, std::vector<int> tour);

}  // namespace vp::tour
