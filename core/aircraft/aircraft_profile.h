#pragma once

#include "core/base/quantity.h"
#include "core/geo/height.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::aircraft {

/** One aircraft as the planner and the checker see it: the inputs of the glide model and the limits of flight.
 *  Read from resources/aircraft/NAME.json or from the mission itself (see core/formats/aircraft_file.h).
 *  The polar (zeroLiftDrag, inducedDrag) is the input that matters most for safety: every metre of the guarantee
 *  scales with it. */
struct AircraftProfile {
  std::string id;    ///< file name without ending, for example "cessna172-elasp"
  std::string name;  ///< as shown to a pilot

  double mass_kg = 0.0;
  double wingArea_m2 = 0.0;
  double zeroLiftDrag = 0.0;              ///< C_D0 [-]
  double inducedDrag = 0.0;               ///< L in C_D = C_D0 + L C_L^2 [-]
  double airDensity_kgm3 = 0.0;           ///< density that the polar is used at
  Speed bestGlideSpeed;                   ///< true airspeed held in the glide and on the tour
  std::vector<Angle> glideBanks;          ///< bank angles that a glide may use in turns, ascending, > 0
  Angle tourBank;                         ///< bank angle of turns on the tour
  Angle maxClimb;                         ///< steepest climb on the tour, > 0
  Angle maxDescent;                       ///< steepest descent on the tour, > 0 (psi_min of [1] is its negative)
  std::optional<Speed> stallSpeed;        ///< unaccelerated stall speed in the glide configuration, wings level
  std::optional<double> maxLoadFactor;    ///< structural limit [-]
  std::optional<geo::HeightMsl> ceiling;  ///< highest altitude of the tour
  std::optional<Speed> maxTailwind;       ///< on landing; runways that a forecast may bring more to are not landed on
  std::optional<Speed> maxCrosswind;      ///< on landing, likewise
  std::vector<std::string> sources;       ///< where the numbers come from, one sentence each

  /** Steepest bank that any part of a plan may use. */
  [[nodiscard]] Angle maxBank() const;
  bool operator==(const AircraftProfile&) const = default;
};

/** What a pilot should be told about a profile, for example a bank angle that stalls the aircraft at glide speed.
 *  Empty if there is nothing to say. Stall: n = 1/cos(bank) > (v/v_s)^2. */
std::vector<std::string> profileWarnings(const AircraftProfile& profile);

}  // namespace vp::aircraft
