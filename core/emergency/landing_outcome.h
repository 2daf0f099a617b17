#pragma once

#include "core/emergency/landing_answer.h"
#include "core/emergency/landing_goals.h"
#include "core/emergency/landing_request.h"

#include <string>
#include <string_view>
#include <vector>

namespace vp::emergency {

/// Name of the term that tells how likely a path comes through the weather; [4] ranks by it.
/// Terms in metres along the ground; the others in metres are heights.
inline constexpr const char* kDistance = "distance";
inline constexpr const char* kHowFar = "how far away it ends";
inline constexpr const char* kWeatherSuccess = "success probability in weather";

/** Length over ground [m]. */
double lengthOf(const mission::LandingPath& path);

/** Turns and straights that a pilot flies: legs that go on with the same turn count once. */
int manoeuvresOf(const mission::LandingPath& path);

/** What a manoeuvre costs beside the height that its curve loses [m]: rolling, which the point mass does not. A simulation with six degrees of
 * freedom ended glides of three manoeuvres 4 to 15 m lower at 20 to 30 degrees of bank (DESIGN section 2); this is about half the middle of that for
 * each, so that a metre in hand is not bought by another turn. */
inline constexpr double kPerManoeuvre = 2.0;

/** How far away in a straight line its end is from its start [m]. */
double reachOf(const mission::LandingPath& path);

/** Risk of a whole path; 0 without a risk. */
double riskOf(const LandingRequest& request, const mission::LandingPath& path);

/** What a path meets in weather: -log of the probability of coming through; 0 without weather. */
double weatherOf(const LandingRequest& request, const mission::LandingPath& path);

/** Height that a path to a site has left when it arrives, beyond what it has that comes to the approach as low as it may [m].
 *  @pre path.site >= 0, and the site has an approach (else 0) */
double heightInHand(const landing::World& world, const mission::LandingPath& path);

/** Terms, cost, bound and height in hand of a path to a runway. Cost without a risk: height lost on the way to the approach, and how much
 *  higher that approach begins than the lowest one in range [m]; together that is least where most height is left in hand. Then kPerManoeuvre for
 * each manoeuvre. With a risk: the risk. With weather: that alone,
 * as risks of other units cannot be added; its success probability is told. Distance and time are told with weight 0.
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
