#pragma once

#include <optional>

namespace vp::map {

/** What the map shows beside terrain, runways, targets and tour. */
struct MapOptions {
  bool contours = true;  ///< thin lines of equal terrain height

  bool safeAltitude = false;                 ///< lowest safe altitude as tint and contours; needs Situation::safeAltitudes
  std::optional<double> safeAltitudeCourse;  ///< true course flown [deg]; nothing: the worst of all
  std::optional<double> reachableFrom;       ///< m MSL: marks where a runway is reachable from, with the course as above
  bool tourMargin = false;                   ///< the tour coloured and patterned by its glide margin
  bool decisionPoints = false;
  bool allGlides = false;  ///< the glide of every decision point

  bool weather = true;     ///< cells of the mission
  bool population = true;  ///< density of the mission's files

  bool targetHeights = true;  ///< below the names of targets
  bool excludedSites = true;
  bool legend = true;
  bool operator==(const MapOptions&) const = default;
};

}  // namespace vp::map
