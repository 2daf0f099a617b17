#pragma once

#include "core/air/atmosphere.h"
#include "core/air/wind_layer.h"
#include "core/aircraft/aircraft_profile.h"

#include <optional>
#include <vector>

namespace vp::aircraft {

/** The air that glides must hold for, and between which altitudes. The pilot holds an indicated airspeed, so true airspeed, and with it
 *  turns and the part of the wind, change with density; all of it counts together, whatever the height of a glide. */
struct AirRange {
  air::Atmosphere atmosphere;
  geo::HeightMsl lowest;   ///< where the lowest glide can end
  geo::HeightMsl highest;  ///< where the highest can begin
  bool operator==(const AirRange&) const = default;
};

/** What a glide depends on beside the aircraft. The defaults are those of the source papers: still air of one density, the polar as it
 *  is, the tour at best glide speed. */
struct GlideConditions {
  std::vector<air::WindLayer> winds = {};  ///< as in Mission::wind; none, or calm ones only: still air
  std::optional<AirRange> air = {};        ///< none: the density of the profile at every height
  double dragFactor = 1.0;                 ///< of the whole polar, >= 1: what a pilot's flying costs more than the profile says
  Propeller propeller = Propeller::AsInPolar;
  std::optional<Speed> tourSpeed = {};  ///< true airspeed of the tour; none: best glide speed
  bool operator==(const GlideConditions&) const = default;
};

/** True airspeeds of the best glide over all masses of the profile and all densities between the two altitudes. */
struct SpeedRange {
  double least = 0.0;  ///< m/s
  double most = 0.0;   ///< m/s
};

/** v sqrt(m / m_ref) sqrt(rho_ref / rho): the same lift coefficient, so the same glide angle.  @threads pure
 *  @param range  none: the profile's own density */
SpeedRange glideSpeeds(const AircraftProfile& profile, const std::optional<AirRange>& range);

/** True airspeed of the tour at an altitude [m/s]: the power setting's, or best glide speed at the profile's mass.  @threads pure */
double tourAirspeed(const AircraftProfile& profile, const GlideConditions& conditions, geo::HeightMsl altitude);

/** C_D0 of a glide with that propeller: the profile's zeroLiftDrag where it names no other. @threads pure */
double zeroLiftDragOf(const AircraftProfile& profile, Propeller propeller);

}  // namespace vp::aircraft
