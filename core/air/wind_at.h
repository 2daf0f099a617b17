#pragma once

#include "core/air/wind.h"
#include "core/air/wind_layer.h"

#include <vector>

namespace vp::air {

/** The wind in the middle of a forecast at a height: what flight times under power are counted with. Linear between layers.
 *  @param layers  ascending; empty: calm */
Wind middleWind(const std::vector<WindLayer>& layers, geo::HeightMsl altitude);

/** Ground speed on a course that is kept by crabbing [m/s]; zero or below: the course cannot be flown.
 *  @param airspeed  true, horizontal, m/s   @param course  rad from East, counter-clockwise */
double groundSpeed(double airspeed, Wind wind, double course);

}  // namespace vp::air
