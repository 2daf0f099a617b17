#pragma once

#include "core/air/wind_layer.h"
#include "core/aircraft/aircraft_profile.h"

#include <string>
#include <vector>

namespace vp::aircraft {

/** Greatest wind on a runway that a forecast may bring [m/s]. */
struct RunwayWind {
  double tailwind = 0.0;   ///< from behind a landing aircraft; below zero where every wind is a headwind
  double crosswind = 0.0;  ///< from either side, >= 0
};

/** @param winds      as in Mission::wind; empty: still air
 *  @param elevation  of the runway: the layers around it count, and everything between them
 *  @param course     of landing, true */
RunwayWind runwayWind(const std::vector<air::WindLayer>& winds, geo::HeightMsl elevation, Angle course);

/** Why the aircraft may not land there in that wind, as part of a sentence ("tailwind of up to 12 kt, the aircraft's limit is
 *  10 kt"); empty if it may, or if the profile names no limits. */
std::string againstLanding(const AircraftProfile& profile, const RunwayWind& wind);

}  // namespace vp::aircraft
