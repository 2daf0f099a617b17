#pragma once

#include "core/formats/json_reader.h"
#include "core/mission/mission.h"

#include <string>
#include <vector>

namespace vp::formats {

/** Member "wind" of a mission: a list of {altitude_m, from_deg, spread_deg, speed_mps}, the lowest first; leastSpeed_mps and
 *  mostSpeed_mps in place of speed_mps where they differ, spread_deg left out where it is zero. */
JsonValue windToJson(const std::vector<air::WindLayer>& winds);

/** The same back, bit for bit; empty if there is no such member. Faults go to the reader's context. */
std::vector<air::WindLayer> readWindMember(ObjectReader& reader);

/** Reports a wind that the mission's aircraft cannot glide against. Missions to be planned and plans are checked so; drafts are not: they
 *  may be opened to be put right.  @param pointer  of the mission */
void checkWindAgainstAircraft(const mission::Mission& mission, const std::string& pointer, ReadContext& context);

}  // namespace vp::formats
