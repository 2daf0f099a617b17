#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/tour/gtsp.h"
#include "core/tour/segment.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vp::tour {

/** A round of the lazy search, for watching: the tour that the solver proposes and which of its legs are proved already. */
struct SearchRound {
  int round = 0;            ///< from 1
  double cost = 0.0;        ///< m; a lower bound of no tour in particular until all legs are safe
  double lowerBound = 0.0;  ///< m, of this round's problem
  const std::vector<VisitPose>* visits = nullptr;
  const std::vector<int>* tour = nullptr;  ///< indices into visits
  std::vector<char> isSafe;                ///< leg i, from tour[i] to the next
};

struct SearchOptions {
  mission::Method method = mission::Method::Lazy;
  mission::TourSolver solver = mission::TourSolver::Builtin;
  std::string lkhProgram = "LKH";
  std::uint64_t seed = 1;
  int threads = 1;
  std::shared_ptr<const landing::AltitudeFloor> floor;  ///< of the same world, if there is one already
  std::function<void(const SearchRound&)> roundDone;    ///< called from the working thread after each round; may not change anything
};

/** Order and headings of the visits, and how much work it was ([1] Tables 2 and 3). */
struct SearchResult {
  std::vector<int> tour;    ///< indices into the visit poses, in flying order
  double cost = 0.0;        ///< m, sum of the safe segments' costs
  double lowerBound = 0.0;  ///< m, no tour over these poses and this roadmap costs less (WHY.md, 5)
  bool optimal = false;
  std::int64_t tourSolutions = 0;
  std::int64_t safeSegments = 0;
  std::int64_t safeQueries = 0;
  std::int64_t boundSegments = 0;
  double terrainSeconds = 0.0;
  double safeSeconds = 0.0;
  double solverSeconds = 0.0;
  std::shared_ptr<const landing::AltitudeFloor> floor;  ///< that segments were bounded by
};

/** Finds the best closed tour over visit poses, one pose per target.
 *
 *  Base ([1] Algorithm 3): all k^2 (n^2 - n) safe segments, one generalized TSP.
 *  Lazy (after [1] Algorithm 4): lower bounds of all segments (segment_bound.h), solve, replace the segments of the tour by safe
 *  ones, choose its headings anew, and so on until that order is safe; then solve again, around what changed, until the
 *  solver's tour holds only safe segments. Both end with the same cost when the tour solver is exact.
 *  @param visits  grouped by target: visits of target t are consecutive, k of each
 *  @errors NoSolution, Cancelled, Unsupported (no LKH program) */
Result<SearchResult> searchTour(const landing::World& world, const landing::Roadmap& roadmap, const Detours& detours,
                                const std::vector<VisitPose>& visits, const SegmentSettings& settings, const SearchOptions& options, const Job& job);

}  // namespace vp::tour
