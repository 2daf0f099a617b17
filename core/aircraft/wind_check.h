#pragma once

#include "core/air/wind_layer.h"
#include "core/aircraft/aircraft_profile.h"
#include "core/aircraft/glide_conditions.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace vp::aircraft {

/// Strongest wind that a forecast may hold [m/s]: 200 kt. The strongest jet streams blow at about this; more is a slip of the pen.
inline constexpr double kMostWind = 200.0 * kMpsPerKnot;
/// Where a layer may lie [m above mean sea level], as all altitudes of a mission.
inline constexpr double kLowestWind = -500.0;
inline constexpr double kHighestWind = 20000.0;

/** What is wrong with a forecast. */
struct WindFault {
  enum class Value { Altitude, From, Spread, LeastSpeed, MostSpeed };
  std::size_t layer = 0;  ///< whose
  Value value = Value::Altitude;
  std::string sentence;  ///< names the value and the limit, in knots, feet and degrees; without a final stop
};

/** The first value out of its limits: altitude, direction in [0, 360], spread in [0, 180], speeds in [0, 200 kt] with the least not above
 *  the most, layers ascending without two at one altitude. Values that are no numbers are out of all limits.  @threads pure */
std::optional<WindFault> windFault(const std::vector<air::WindLayer>& winds);

/** The same, and the first layer whose strongest wind is not below the least gliding airspeed: against it the aircraft makes no way, so no
 *  glide can be promised. Who plans, reads a file or takes a wind from a pilot asks this one.
 *  @param air  that airspeeds range over, as in GlideConditions; they range over the masses of the profile without it too   @threads pure */
std::optional<WindFault> windFault(const std::vector<air::WindLayer>& winds, const AircraftProfile& aircraft,
                                   const std::optional<AirRange>& air = {});

/** The same for who plans: also the first layer against which the aircraft makes no way in its steepest turn without engine, along the tour
 *  included, as drag, propeller, air and the speed of the tour make it. Every loss of a GlideModel of these conditions is finite in turns of
 *  the profile's banks, but of those that are so steep that no glide exists in still air.
 *  @pre the profile is one that GlideModel takes   @threads pure */
std::optional<WindFault> windFault(const AircraftProfile& aircraft, const GlideConditions& conditions);

}  // namespace vp::aircraft
