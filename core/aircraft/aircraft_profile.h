#pragma once

#include "core/base/quantity.h"
#include "core/geo/height.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::aircraft {

/** A way to fly the tour: what the engine is set to, and what that gives and takes in level flight. */
struct PowerSetting {
  enum class Unit { Litres, Kilograms, WattHours };
  std::string name;      ///< unique in a profile, for example "65 %"
  Speed trueAirspeed;    ///< held on the tour
  double perHour = 0.0;  ///< used per hour, in `unit`
  Unit unit = Unit::Litres;
  bool operator==(const PowerSetting&) const = default;
};

/** What the propeller does after the engine has stopped. */
enum class Propeller {
  AsInPolar,    ///< what the polar of the profile holds for
  Windmilling,  ///< turned by the air
  Stopped,
};

/** One aircraft as the planner and the checker see it: the inputs of the glide model and the limits of flight.
 *  Read from resources/aircraft/NAME.json or from the mission itself (see core/formats/aircraft_file.h).
 *  The polar (zeroLiftDrag, inducedDrag) is the input that matters most for safety: every metre of the guarantee
 *  scales with it. */
struct AircraftProfile {
  std::string id;    ///< file name without ending, for example "cessna172-elasp"
  std::string name;  ///< as shown to a pilot

  double mass_kg = 0.0;
  double wingArea_m2 = 0.0;
  double zeroLiftDrag = 0.0;                     ///< C_D0 [-]
  double inducedDrag = 0.0;                      ///< L in C_D = C_D0 + L C_L^2 [-]
  double airDensity_kgm3 = 0.0;                  ///< density that the polar is used at
  Speed bestGlideSpeed;                          ///< true airspeed held in the glide and on the tour
  std::vector<Angle> glideBanks;                 ///< bank angles that a glide may use in turns, ascending, > 0
  Angle tourBank;                                ///< bank angle of turns on the tour
  Angle maxClimb;                                ///< steepest climb on the tour, > 0
  Angle maxDescent;                              ///< steepest descent on the tour, > 0 (psi_min of [1] is its negative)
  std::optional<Speed> stallSpeed;               ///< unaccelerated stall speed in the glide configuration, wings level
  std::optional<double> maxLoadFactor;           ///< structural limit [-]
  std::optional<geo::HeightMsl> ceiling;         ///< highest altitude of the tour
  std::optional<Speed> maxTailwind;              ///< on landing; runways that a forecast may bring more to are not landed on
  std::optional<Speed> maxCrosswind;             ///< on landing, likewise
  std::optional<double> leastMass_kg;            ///< masses that the guarantee holds for, mass_kg among them; the pilot holds the best
  std::optional<double> mostMass_kg;             ///< glide speed of the day's mass, which goes with its root. Absent: mass_kg alone
  std::optional<double> windmillingDrag;         ///< C_D0 in place of zeroLiftDrag with the propeller turned by the air
  std::optional<double> stoppedDrag;             ///< C_D0 in place of zeroLiftDrag with the propeller stopped
  std::optional<Speed> maxSpeed;                 ///< true airspeed never to be exceeded
  std::optional<Angle> steepestDescent;          ///< steepest steady descent through the air without engine: flaps, brakes or slip
  std::optional<double> rollRate_dps;            ///< degrees of bank per second that it rolls by at least, into turns and out of them
  std::optional<Length> landingDistance;         ///< over an obstacle of 15 m to standstill: greatest mass, sea level in the standard
                                                 ///< atmosphere, no wind, level dry hard runway
  std::optional<Speed> climbRate;                ///< best rate of climb at sea level in the standard atmosphere, greatest mass
  std::optional<geo::HeightMsl> serviceCeiling;  ///< density altitude at which 100 ft/min (0.508 m/s) of it are left
  std::vector<PowerSetting> powerSettings;       ///< to choose from; none: the tour is flown at best glide speed
  std::optional<double> usableEnergy;            ///< fuel or charge that a flight may use, in the unit of the power settings
  std::vector<std::string> sources;              ///< where the numbers come from, one sentence each

  /** Steepest bank that any part of a plan may use. */
  [[nodiscard]] Angle maxBank() const;
  bool operator==(const AircraftProfile&) const = default;
};

/** What a pilot should be told about a profile, for example a bank angle that stalls the aircraft at glide speed.
 *  Empty if there is nothing to say. Stall: n = 1/cos(bank) > (v/v_s)^2. */
std::vector<std::string> profileWarnings(const AircraftProfile& profile);

}  // namespace vp::aircraft
