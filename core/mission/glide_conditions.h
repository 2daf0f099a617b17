#pragma once

#include "core/aircraft/glide_conditions.h"
#include "core/mission/plan.h"

#include <vector>

namespace vp::mission {

/// Highest altitude of a tour in an atmosphere if neither mission nor aircraft name a ceiling [m MSL]: 20,000 ft.
inline constexpr double kCeilingWithoutOne = 6096.0;

/** The lower of the two ceilings of mission and aircraft; none if neither has one and no atmosphere is given, in which airspeed would
 *  grow without end. */
std::optional<geo::HeightMsl> ceilingOf(const Mission& mission);

/** What the glides of a mission depend on beside the aircraft. Altitudes range from the lowest site to the ceiling.
 *  @param sites  that glides may end at */
aircraft::GlideConditions glideConditionsOf(const Mission& mission, const std::vector<SiteInFrame>& sites);

/** True airspeed of the mission's tour at an altitude [m/s]: the power setting's, or best glide speed at the profile's mass. */
double tourAirspeedAt(const Mission& mission, geo::HeightMsl altitude);

/** Whether wind, air, approach, propeller and power setting are the same: glides of one mission then are those of the other, as far as aircraft,
 *  sites, safety settings and terrain are. */
bool sameConditions(const Mission& a, const Mission& b);

/// Higher than the plan's highest point by this, the aircraft must still climb as steeply as it does in the plan [m]: waypoints in whole feet, flown
/// by another program, rise above it (by up to 187 m, tst_route).
inline constexpr double kClimbReserve = 200.0;

/** Highest altitude of tour, spirals and ways from and to home [m MSL]. @pre the plan has a tour */
double highestAltitude(const Plan& plan);

/** The power setting that the mission names; null if it names none, or one that its aircraft lacks. */
const aircraft::PowerSetting* powerSettingOf(const Mission& mission);

}  // namespace vp::mission
