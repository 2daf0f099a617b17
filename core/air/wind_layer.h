#pragma once

#include "core/base/quantity.h"
#include "core/geo/height.h"

namespace vp::air {

/** Winds that may blow: every speed of a range from every direction of a range. One wind is a range of no width; calm is speed
 *  zero. A forecast of 270 +- 20 degrees at 15 +- 5 kt is a sector of 10 to 20 kt and a spread of 20 degrees.
 *  Directions are true, as forecasts and METARs give them, at the middle of the mission. */
struct WindSector {
  double from_deg = 0.0;    ///< middle of the directions that it blows from, true, in [0, 360]
  double spread_deg = 0.0;  ///< to each side of it, in [0, 180]
  double leastSpeed = 0.0;  ///< m/s, >= 0
  double mostSpeed = 0.0;   ///< m/s, >= leastSpeed

  /** Middle of where the air moves to in the local frame: rad from East, counter-clockwise, in [-pi, pi]. */
  [[nodiscard]] double towards() const { return wrapPi(Angle::degrees(270.0 - from_deg).radians()); }
  /** Spread to each side [rad]. */
  [[nodiscard]] double spread() const { return Angle::degrees(spread_deg).radians(); }
  [[nodiscard]] bool isCalm() const { return mostSpeed == 0.0; }
  bool operator==(const WindSector&) const = default;
};

/** The wind at one height. Between two layers the wind is any that lies between one of the lower and one of the upper, and
 *  below the lowest and above the highest layer it is as there. */
struct WindLayer {
  geo::HeightMsl altitude;
  WindSector wind;
  bool operator==(const WindLayer&) const = default;
};

}  // namespace vp::air
