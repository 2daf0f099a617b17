#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/tour/gtsp.h"

#include <chrono>
#include <cstdint>
#include <optional>

namespace vp::tour {

struct BoundEffort {
  int rounds = 300;                 ///< steps of prices at first, and four times as many as between cuts
  std::int64_t arcs = 100'000'000;  ///< that may be looked at for cuts
  std::optional<std::chrono::steady_clock::time_point> deadline;
};

/** A lower bound on the cost of every tour; kForbidden if it proves that none avoids forbidden arcs.
 *  Lagrangian relaxation: sets become vertices joined by the cheapest arc between their nodes, tours become
 *  1-arborescences; multipliers price what that forgets, namely that a set is left once and by the node that was entered.
 *  Every multiplier gives a valid bound; subgradient steps look for good ones. Then passes of cuts through sets
 *  (gtsp_cuts.h) and more steps, until they gain little. Integer costs round the bound up.
 *  @param upperBound  cost of a known tour or kForbidden; only steers the steps
 *  @source Held, Karp 1971 (1-trees); Noon, Bean 1991, "A Lagrangian based approach for the asymmetric generalized
 *  traveling salesman problem" (node prices)      @pre two sets or more      @errors Cancelled */
Result<double> lowerBound(const GtspProblem& problem, double upperBound, const BoundEffort& effort, const Job& job);

}  // namespace vp::tour
