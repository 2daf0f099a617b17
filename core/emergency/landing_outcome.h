#pragma once

#include "core/emergency/landing_answer.h"
#include "core/emergency/landing_goals.h"
#include "core/emergency/landing_request.h"

#include <string>
#include <string_view>
#include <vector>

namespace vp::emergency {

/** Length over ground [m]. */
double lengthOf(const mission::LandingPath& path);

/** How far away in a straight line its end is from its start [m]. */
double reachOf(const mission::LandingPath& path);

/** Risk of a whole path; 0 without a risk. */
double riskOf(const LandingRequest& request, const mission::LandingPath& path);

/** Height that a path to a site has left when it arrives, beyond what it has that comes to the approach as low as it may [m].
 *  @pre path.site >= 0, and the site has an approach (else 0) */
double heightInHand(const landing::World& world, const mission::LandingPath& path);

/** Terms, cost, bound and height in hand of a path to a runway. Cost without a risk: height lost on the way to the approach, and how much
 *  higher that approach begins than the lowest one in range [m]; together that is least where most height is left in hand. With a risk: the risk.
 *  Distance and time are told with weight 0.
 *  @pre path.site >= 0 */
LandingAnswer answerWith(const LandingRequest& request, const LandingGoals& goals, std::string_view planner, mission::LandingPath path);

/** Where no runway can be reached: why, and the longest glide that stays clear of the ground, if there is one. */
LandingAnswer answerWithout(const LandingRequest& request, std::string_view planner, std::string why, double missing, const Countdown& countdown);

/** A request that makes no sense. */
LandingAnswer answerToFault(const LandingRequest& request, std::string_view planner, std::string fault);

/** The approach behind a glide to its gate: the whole path, if it arrives high enough.
 *  @param way  legs from the request's pose to the gate   @param altitude  at the gate, m MSL */
std::optional<mission::LandingPath> withApproach(const LandingRequest& request, const landing::Approach& approach,
                                                 std::vector<mission::LandingLeg> way, double altitude);

}  // namespace vp::emergency
