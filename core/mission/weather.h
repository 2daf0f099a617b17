#pragma once

#include "core/geo/local_frame.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::mission {

/** Bad weather over an area: flown through where there is no better way, at a risk. A soft obstacle of [4] section 2.
 *  Its outline is not closed; sides are straight in the local frame and do not cross. */
struct WeatherCell {
  std::string name;                  ///< "storm west of Chur"; for messages and on maps, may be empty
  std::vector<geo::LatLon> outline;  ///< three or more corners
  std::optional<double> floor;       ///< m MSL; none: down to the ground
  std::optional<double> top;         ///< m MSL, above the floor; none: as high as anybody flies
  /** Probability of coming through `perDistance` metres of it, in (0, 1]; of d metres: success^(d / perDistance). 1: no risk, drawn only. */
  double success = 0.9;
  double perDistance = 1852.0;  ///< m, > 0
  bool operator==(const WeatherCell&) const = default;
};

}  // namespace vp::mission
