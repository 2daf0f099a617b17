#pragma once

#include "core/geo/pose.h"
#include "core/mission/weather.h"
#include "ui/style/units.h"

#include <QString>
#include <QStringList>

#include <cstddef>
#include <string>
#include <vector>

namespace vp::document {

/** A weather cell as shown, its outline in the frame. */
struct ShownWeather {
  mission::WeatherCell cell;
  std::vector<geo::Point> outline;
  geo::Box box;
};

/** @threads pure */
ShownWeather shownWeather(mission::WeatherCell cell, const geo::LocalFrame& frame);
/** Whether a place is within the outline, whatever the altitude. */
bool isInside(const ShownWeather& shown, geo::Point place);
/** Index of the smallest cell over a place, the last of equal ones; -1: none. */
int weatherAt(const std::vector<ShownWeather>& cells, geo::Point place);

/** Why a cell cannot be put to use, in a sentence with its stop; empty if it can. Sides that cross, a floor above the top. */
std::string weatherProblem(const mission::WeatherCell& cell, const geo::LocalFrame& frame);

/** Its name, or "Weather 3". @param index  in the mission */
QString weatherTitle(const mission::WeatherCell& cell, std::size_t index);
/** "GND to 9 800 ft MSL", "5 000 ft MSL to UNL". */
QString weatherAltitudes(const mission::WeatherCell& cell, const style::Units& units);
/** Probability of coming through one unit of distance of it, NM or km [0..1]. */
double weatherSuccess(const mission::WeatherCell& cell, const style::Units& units);
/** "90 % per NM". */
QString weatherSuccessText(const mission::WeatherCell& cell, const style::Units& units);
/** A probability in percent with its sign, rounded down to a tenth: "98.5 %"; above 99.9 % without reaching it "99.9 %". */
QString percentText(double probability);

}  // namespace vp::document
