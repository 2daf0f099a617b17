#pragma once

#include "core/base/result.h"
#include "core/formats/wind_text.h"
#include "core/geo/local_frame.h"
#include "core/mission/mission.h"

#include <string>
#include <vector>

namespace vp::cli {

/** Exactly `count` finite numbers with commas between them. @errors OutOfRange */
Result<std::vector<double>> numbersIn(const std::string& text, std::size_t count);

/** A place on earth. @param option  that it was given by, for the sentence   @errors OutOfRange */
Result<geo::LatLon> placeFrom(double latitude, double longitude, const std::string& option);

/** Metres of "30km", "20nm", "500m" or "30" (km). @errors OutOfRange */
Result<double> distanceIn(const std::string& text, const std::string& option);

/** Metres above mean sea level of "2400m", "8000ft" or "2400" (m). @errors OutOfRange */
Result<double> altitudeIn(const std::string& text, const std::string& option);

/** Seconds of "1s", "200ms" or "1" (s); zero too, as whoever asks has more to say about it. @errors OutOfRange */
Result<double> secondsIn(const std::string& text, const std::string& option);

/** What the option --wind means to all commands that have it. */
inline constexpr const char* kWindHelp =
    "Wind that the guarantee shall hold for: 270/15kt, 27015G25KT, 270+-20/10-20kt, a METAR, or layers such as 0ft 270/15kt; 5000ft 290/25kt "
    "(also by repeating the option); calm: still air";

/** Gives a mission the wind of --wind, if it was given, and refuses a wind that the mission's aircraft cannot glide against.
 *  @param texts  one for each time it was given, the lowest layer first
 *  @param notes  receives what was ignored of them
 *  @errors those of formats::parseWind and OutOfRange, with the option as their place */
Result<void> applyWind(const std::vector<std::string>& texts, mission::Mission& mission, std::vector<std::string>& notes);

/** The parts of a text between commas, spaces around them dropped. */
std::vector<std::string> partsOf(const std::string& text);

}  // namespace vp::cli
