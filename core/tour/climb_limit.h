#pragma once

#include "core/base/result.h"
#include "core/landing/world.h"
#include "core/mission/plan.h"
#include "core/tour/profile.h"

#include <functional>

namespace vp::tour {

/** Plans with no more climb than the aircraft has left at the highest point of the plan.
 *
 *  The higher, the less it climbs, and how high a tour goes is known afterwards only: where it goes higher than its climb was good for, it is
 *  planned again with what is left a little above its highest point. With less climb a tour rises earlier, so it may get higher yet.
 *  Climbing lower down could be steeper; one limit for all keeps every bound of the search what it is.
 *  @param pitch  in: what the profile allows everywhere; out: what the plan was made with
 *  @param once   plans with `pitch` as it then is
 *  @errors those of `once`; NoSolution where the aircraft hardly climbs as high as the tour has to go */
Result<mission::Plan> planWithinClimb(const mission::Mission& mission, const landing::World& world, PitchLimits& pitch,
                                      const std::function<Result<mission::Plan>()>& once);

}  // namespace vp::tour
