#pragma once

#include "core/air/wind_layer.h"
#include "core/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace vp::formats {

/** Wind as a pilot wrote it. */
struct WindReading {
  std::vector<air::WindLayer> layers;  ///< as Mission::wind: ascending; empty = still air
  std::vector<std::string> notes;      ///< what was ignored or taken for granted, one sentence each; to be shown
};

/** Reads wind as pilots and weather services write it; upper and lower case are the same.
 *  - One wind at all heights: 270/15kt, 270/15 (kt), 27015KT, 27015G25KT (15 to 25), 27015KT 240V300, VRB05KT (0 to 5 from anywhere),
 *    270/10-20kt, 270±20/15±5kt (also +- and +/-), 270/8mps, 27008MPS, 270/30km/h, calm, 00000KT.
 *  - Layers, the lowest first, ';' or a line end between them: "0ft 270/15kt; 5000ft 290/25kt", "3000 27015; 6000 29025", "FL100 290/40",
 *    "1500m 270/15kt". Altitudes are above mean sea level; one without a unit is in feet and whole hundreds of them.
 *  - A METAR or SPECI, whole: its wind group.
 *  - Winds aloft of the US (FD, FB): "FT 3000 6000 9000" and the line of one station, "BRL 2715 2725+00 2830-05".
 *  Directions are true. Two numbers are never guessed apart: a direction has three digits.
 *  @errors BadFormat, OutOfRange (direction above 360, spread above 180, speed above 200 kt, layers out of order or twice): a sentence that
 *  quotes the text and says where and what is expected; `where` is empty   @threads pure
 *  @source ICAO Annex 3 (20th ed. 2018) appendix 3, 4.1 and table A3-2; WMO-No. 306 vol. I.1, FM 15-XV METAR, 15.5;
 *  FAA-H-8083-28, Aviation Weather Handbook (2022), wind and temperature aloft forecast (FB) */
Result<WindReading> parseWind(std::string_view text);

/** What wind is written in. */
struct WindUnits {
  enum class Speed { Knots, MetresPerSecond, KilometresPerHour };
  enum class Height { Feet, Metres };
  Speed speed = Speed::Knots;
  Height height = Height::Feet;
};

/** The layers as a text that parseWind reads back to exactly the same value: "270±20/10-20kt", "0ft 270/15kt; 5000ft VRB/0-5kt", "calm".
 *  A value that no short number of the chosen unit gives is written in SI.  @pre aircraft::windFault(layers) is empty */
std::string windText(const std::vector<air::WindLayer>& layers, WindUnits units = {});

/** The layers in words, one line each: "still air", "15 kt from 270 degrees at every height", "5000 ft: 10 to 20 kt from 250 to 290 degrees".
 *  Directions are true, ranges of them clockwise and rounded outwards to whole degrees; speeds are rounded to a tenth. */
std::vector<std::string> windWords(const std::vector<air::WindLayer>& layers, WindUnits units = {});

/** The same as the end of a sentence that begins with "in": "calm air", "a wind of 15 kt from 270 degrees true", "every wind of 10 to 20 kt from 250
 *  to 290 degrees true", "every wind between the layers of the forecast (0 ft: 5 kt from 180 degrees; 5000 ft: ...)". */
std::string airPhrase(const std::vector<air::WindLayer>& layers, WindUnits units = {});

}  // namespace vp::formats
