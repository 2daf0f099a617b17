#pragma once

#include "core/base/result.h"
#include "core/tour/gtsp.h"

#include <vector>

namespace vp::tour {

/** Whether problem and options make sense: at least one set, none empty, every node in exactly one, costs not negative
 *  and not NaN, a warm start with one node per set. @errors OutOfRange */
Result<void> checkGtsp(const GtspProblem& problem, const GtspOptions& options);

/** The same closed tour, beginning with its node of set 0. */
std::vector<int> fromSetZero(const GtspProblem& problem, std::vector<int> tour);

}  // namespace vp::tour
