#pragma once

#include "core/mission/airspace.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vp::formats {

/** A line of an OpenAir file: its code in capitals and what stands behind it. */
struct OpenAirLine {
  explicit OpenAirLine(std::string_view line);
  std::string code;
  std::string_view value;
};

/** Degrees of "01:30:30 N 001:30:30 W", "46:30.5N 009:45.0E", "46.5 N 9.75 E"; nothing if it is no place on Earth. */
std::optional<geo::LatLon> parseOpenAirPlace(std::string_view text);

/** "FL 95", "4500ft MSL", "1000 ft AGL", "300 m GND", "SFC", "UNL", "NOTAM". Never fails: what is no height is Unknown. */
mission::AirspaceLimit parseOpenAirLimit(std::string_view text, bool isFloor);

/** The parts between commas, blanks around them dropped. */
std::vector<std::string_view> splitAtCommas(std::string_view text);

}  // namespace vp::formats
