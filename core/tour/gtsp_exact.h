#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/tour/gtsp.h"

#include <optional>
#include <vector>

namespace vp::tour {

/** Whether dynamic programming over sets fits into memory (half a gigabyte) for this problem. */
bool fitsExactSearch(const GtspProblem& problem);

/** The cheapest tour by dynamic programming over subsets of sets (Held, Karp 1962, with a node per set), the loop closed
 *  once for every node of the smallest set. Empty if every closed tour has a forbidden arc: this is a proof.
 *  @param upperBound  cost of a known tour, or kForbidden: partial tours that cannot beat it are dropped, so a tour of
 *                     exactly this cost is still found
 *  @pre two sets or more      @errors Cancelled      @cost O(2^sets * nodes^2 * smallest set) */
Result<std::optional<std::vector<int>>> solveExactly(const GtspProblem& problem, double upperBound, const Job& job);

}  // namespace vp::tour
