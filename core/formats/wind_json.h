#pragma once

#include "core/aircraft/aircraft_profile.h"
#include "core/formats/json_reader.h"
#include "core/mission/mission.h"

#include <vector>

namespace vp::formats {

/** Member "wind" of a mission: a list of {altitude_m, from_deg, spread_deg, speed_mps}, the lowest first; leastSpeed_mps and
 *  mostSpeed_mps in place of speed_mps where they differ, spread_deg left out where it is zero. */
JsonValue windToJson(const std::vector<air::WindLayer>& winds);

/** The same back, bit for bit; empty if there is no such member. Faults go to the reader's context.
 *  @param aircraft  that the wind must let glide; null: not looked at, as in drafts, which may be opened to be put right */
std::vector<air::WindLayer> readWindMember(ObjectReader& reader, const aircraft::AircraftProfile* aircraft);

}  // namespace vp::formats
