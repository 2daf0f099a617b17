// Why there is no tour, in sentences that name what could be changed. Of planner.cpp only.
#pragma once

#include "core/tour/detour.h"
#include "core/tour/planner.h"
#include "core/tour/segment.h"

#include <optional>
#include <vector>

namespace vp::tour {

/** What the steps of planning one mission share. References into the caller. */
struct PlanTask {
  const PlanInput& input;
  const landing::World& world;
  const landing::Roadmap& roadmap;
  const Detours& detours;
  const SegmentSettings& settings;
  const std::vector<VisitPose>& sampled;  ///< k headings of each target
};

/** No targets, or one without terrain. */
std::optional<Error> checkTargets(const PlanInput& input, PlanFailure& failure);

/** Says before any search which target cannot be part of a safe tour, whatever the order. @errors NoSolution, Cancelled */
std::optional<Error> hopelessTarget(const PlanInput& input, const landing::World& world, const landing::Roadmap& roadmap,
                                    const std::vector<VisitPose>& visits, const SegmentSettings& settings, PlanFailure& failure, const Job& job);

/** After a search without a tour: the target whose legs to its neighbours miss the ceiling by most. Looks at a few
 *  neighbours and headings only, so that the answer comes in seconds and not after all k^2 n^2 safe segments.
 *  @return Cancelled if it was stopped before it knew */
Error explainNoTour(const PlanTask& task, const Job& job, PlanFailure& failure);

/** The joined loop passes above the ceiling. @param peak  of the loop, m MSL */
std::optional<Error> aboveCeiling(double peak, double ceiling, PlanFailure& failure);

}  // namespace vp::tour
