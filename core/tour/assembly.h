#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/landing/roadmap.h"
#include "core/landing/world.h"
#include "core/mission/plan.h"
#include "core/tour/loop_cost.h"
#include "core/tour/segment.h"

namespace vp::tour {

/** What came of joining a tour. */
struct Assembled {
  double peak = 0.0;      ///< highest altitude of the tour, m MSL
  bool isRaised = false;  ///< above what its segments cost, for the height that rolling may cost its glides
};

/** Joins the safe segments of a tour into one closed loop ([1] AssurePitchLimits): at each target the higher of the two
 *  ends counts, pitch limits are passed around the loop, then each segment gets its least concave majorant; where that enters
 *  forbidden airspace from below it is raised over it, and so on until it enters none. Fills
 *  plan.tour, plan.spirals and the length, penalty and cost of plan.metrics.
 *  Glides are straightened (landing/glide_straightener.h), and the loop is raised where rolling asks for more height than it has.
 *  @param visits  the chosen visit poses in flying order
 *  @errors Cancelled, NoSolution (no way over an airspace) */
Result<Assembled> assembleTour(const landing::World& world, SegmentBuilder& builder, const std::vector<VisitPose>& visits,
                               const SegmentSettings& settings, mission::LowTargets lowTargets, mission::Plan& plan, const Job& job);

/** Where a spiral at a visit may go down to, on the side where the ground lets it go lower. */
SpiralGround spiralGround(const landing::World& world, const ForbiddenAirspace* forbidden, const geo::Pose& pose, double targetAltitude);

}  // namespace vp::tour
