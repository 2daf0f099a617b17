#pragma once

#include "core/formats/wind_text.h"

#include <string_view>

namespace vp::formats {

/** Whether a text begins as a METAR or SPECI does: with that word, or with a place and the time of an observation. */
bool isWeatherReport(std::string_view text);
/** Its wind group. @errors as parseWind */
Result<WindReading> readWeatherReport(std::string_view text);

/** Whether a text is a winds-aloft forecast of the US: a line begins with FT. */
bool isWindsAloft(std::string_view text);
/** The winds of its one station. @errors as parseWind */
Result<WindReading> readWindsAloft(std::string_view text);

}  // namespace vp::formats
