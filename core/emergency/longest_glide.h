#pragma once

#include "core/emergency/landing_request.h"
#include "core/mission/landing_path.h"

#include <optional>

namespace vp::emergency {

/** Where no runway can be reached: the glide that gets farthest away over known ground and keeps the clearance, of those that turn once, with one
 *  of the glide's radii, and then go straight. It ends where the clearance would be lost, at the latest. Where the request has a risk: of those that
 *  get at least half as far as the farthest the one of least risk, the way straight on from its end down to the ground included.
 *  @return a path without a site; none if not even its beginning keeps the clearance
 *  @accuracy courses every 5 degrees; its end is within 10 m of the farthest on its course   @cost some 10 ms; less when the countdown is over */
std::optional<mission::LandingPath> longestGlide(const LandingRequest& request, const Countdown& countdown);

}  // namespace vp::emergency
