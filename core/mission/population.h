#pragma once

#include "core/geo/local_frame.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::mission {

/** A polygon with holes; rings are not closed, sides between corners straight in the local frame. */
struct PopulatedPolygon {
  std::vector<geo::LatLon> outline;  ///< three or more corners
  std::vector<std::vector<geo::LatLon>> holes;
  bool operator==(const PopulatedPolygon&) const = default;
};

/** An area of a census and how many people live there, evenly spread over all of it. One of the two numbers is set. */
struct PopulationArea {
  std::string name;                     ///< for messages: "feature 12 (36103110101)"
  std::string source;                   ///< file that it came from
  std::vector<PopulatedPolygon> parts;  ///< one or more
  std::optional<double> people;         ///< in all parts together
  std::optional<double> perSquareKm;    ///< people
  bool operator==(const PopulationArea&) const = default;
};

}  // namespace vp::mission
