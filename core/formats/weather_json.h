#pragma once

#include "core/formats/json_reader.h"
#include "core/mission/weather.h"

#include <vector>

namespace vp::formats {

/** Member "weather" of a mission: a list of {name, outline, floor_m, top_m, success, perDistance_m}; outline as [longitude, latitude] in degrees,
 * name, floor and top left out where there are none. */
JsonValue weatherToJson(const std::vector<mission::WeatherCell>& cells);

/** The same back, bit for bit; empty if there is no such member. Faults go to the reader's context. Whether the sides cross is not looked at here:
 *  risk::Weather::from, where cells are put to use. */
std::vector<mission::WeatherCell> readWeatherMember(ObjectReader& reader);

}  // namespace vp::formats
