#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/landing/world.h"
#include "core/mission/mission.h"
#include "core/tour/segment.h"

#include <cstdint>
#include <vector>

namespace vp::tour {

struct RefineOptions {
  mission::LowTargets lowTargets = mission::LowTargets::PassAbove;
  std::uint64_t seed = 1;
  std::int64_t queriesPerTarget = 700;  ///< safe-altitude queries after which it ends, times the number of targets (more for long legs)
  std::vector<VisitPose> insert = {};   ///< targets that the tour lacks; each goes where it costs least, before refinement
};

/** A tour that is no dearer than the one it came from, and how it was found. */
struct RefineResult {
  std::vector<VisitPose> visits;  ///< in flying order
  double costBefore = 0.0;        ///< m, of the closed loop over the given visits and the inserted ones; infinite if it cannot be flown
  double cost = 0.0;              ///< m, of the closed loop over the refined ones
  std::int64_t movesTried = 0;
  std::int64_t movesAccepted = 0;
};

/** Improves a tour on what the closed loop really costs (loop_cost.h), where the tour solver adds up legs, and over all
 *  headings, where it has k of each target ([1] (12)): turns headings by steps that shrink, tries other Dubins words, moves
 *  targets to other places of the order and turns stretches round, then does the same from changed orders and keeps the best.
 *
 *  A change is first costed with legs over no ground at all, then with bounds of the safe segments, and only if those bounds allow a
 *  gain with safe segments; it is kept if all legs are safe and the loop is cheaper.
 *  Deterministic: ends by counts. @param visits  of a tour that is safe   @errors Cancelled   @threads pure */
Result<RefineResult> refineTour(const landing::World& world, SegmentBuilder& builder, const std::vector<VisitPose>& visits,
                                const SegmentSettings& settings, const RefineOptions& options, const Job& job);

}  // namespace vp::tour
