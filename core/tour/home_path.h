#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/landing/roadmap.h"
#include "core/landing/world.h"
#include "core/mission/plan.h"
#include "core/tour/segment.h"

namespace vp::tour {

/** Least height over the ground on the part of a climb-out that has no gliding guarantee yet, per metre flown from the far end of the
 *  runway, until the clearance of the mission is reached: the minimum obstacle clearance of departures, 0.8 %.
 *  @source ICAO Doc 8168 (PANS-OPS) volume II, part I, section 3, chapter 2 */
inline constexpr double kDepartureClearancePerMetre = 0.008;

/** Cells of the terrain are upper bounds and reach over the flat ground of the airfield, so the first metres of a climb-out are
 *  below them everywhere; ground counts from this distance on. The checker warns about what lies before. */
inline constexpr double kAirfieldEnvironment = 1000.0;  // m flown from the far end of the runway

/** Adds the ways from and to the home runway to a planned tour (Plan::departure and arrival).
 *
 *  Departure: climbing circles of the tour's radius over the far end of the runway, to the side of lower ground, then a safe segment as
 *  between targets to the tour. Circling keeps the runway near, so that the guarantee begins after the least height; a straight climb
 *  would leave it behind, as no aircraft climbs as steeply as it glides. Arrival: a safe segment from the tour to the threshold, on the landing
 *  course. Where they meet the tour is chosen among evenly spaced decision points and all visits so that least is flown in all:
 *  a part of the loop without targets may be left out between arrival and departure.
 *  @param roadmap  of the plan; its area must hold the runway
 *  @errors OutOfRange (no such landing site), NoSolution (which way, and why), Cancelled
 *  @pre plan.tour is complete; plan.mission.home is set */
Result<void> addHomePaths(const landing::World& world, const landing::Roadmap& roadmap, const SegmentSettings& settings, mission::Plan& plan,
                          const Job& job);

}  // namespace vp::tour
