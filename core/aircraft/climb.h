#pragma once

#include "core/aircraft/glide_conditions.h"
#include "core/aircraft/glide_model.h"

namespace vp::aircraft {

/** Best rate of climb at a density altitude [m/s]: straight from the rate at sea level to 100 ft/min at the service ceiling, on below zero;
 *  infinity where the profile names neither.
 *  @source handbooks' climb tables are straight lines in density altitude within a few per cent (172N, section 5, figure 5-6: 720 ft/min at sea
 * level, 400 at 8,000 ft, both at full mass)   @threads pure */
double climbRate(const AircraftProfile& profile, geo::HeightMsl densityAltitude);

/** Steepest climb through the air on the tour at an altitude [-]: the tangent of the profile's limit, or of what the rate of climb leaves at the
 *  tour's airspeed, whichever is less; not above zero where the aircraft cannot climb. Falls with altitude.
 *  Climbing at the slower airspeed of best climb would be steeper.  @threads pure */
double climbSlope(const AircraftProfile& profile, const GlideConditions& conditions, geo::HeightMsl altitude);

/** Steepest climb over ground that never needs more than climbSlope in the air, whichever wind blows [-]. @param glide  of these conditions */
double climbSlopeOverGround(const AircraftProfile& profile, const GlideConditions& conditions, const GlideModel& glide, geo::HeightMsl altitude);

}  // namespace vp::aircraft
