#pragma once

#include "core/mission/plan.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::mission {

/** Landing distance that the mission's aircraft needs at a site in the mission's air and wind (aircraft::landingDistance).
 *  @param sites  among which the other end of the runway is looked for, whose elevation gives the slope; level where it is not there
 *  @return none where the profile has no landing distance, or the surface is water   @threads pure */
std::optional<Length> landingNeed(const Mission& mission, const LandingSite& site, const std::vector<SiteInFrame>& sites);

/** Why the runway is too short for the mission's aircraft, as part of a sentence ("450 m long, 612 m needed"); empty if it is long enough, or if
 *  its length or what the aircraft needs is not known.  @threads pure */
std::string tooShort(const Mission& mission, const LandingSite& site, const std::vector<SiteInFrame>& sites);

}  // namespace vp::mission
