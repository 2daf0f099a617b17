#pragma once

#include "core/aircraft/glide_model.h"
#include "core/mission/plan.h"
#include "core/terrain/terrain_pyramid.h"

#include <optional>
#include <vector>

namespace vp::landing {

/** Everything a glide depends on: ground, aircraft, runways, how far to stay away from the ground, how late it begins and how it ends.
 *  Lengths in metres, frame as in geo::LocalFrame. A value snapshot; share it between threads as const. */
struct World {
  terrain::TerrainPyramid terrain;
  aircraft::GlideModel glide;
  std::vector<mission::SiteInFrame> sites;
  double clearance = 100.0;              ///< above terrain everywhere
  double arrivalMargin = 0.0;            ///< above a site's elevation on arrival
  double reactionLength = 0.0;           ///< flown over ground after the engine stops before a glide may turn, upper bound
  double reactionLoss = 0.0;             ///< lost at once when the engine stops, beyond what gliding loses
  mission::ApproachSettings approach;    ///< how glides end
  std::optional<Angle> steepestDescent;  ///< of the aircraft through the air without engine, as in its profile
  std::optional<double> rollRate_dps;    ///< degrees of bank per second, as in its profile; none: rolling is not counted
};

/** The world of a mission over a terrain. @param sites  that glides may end at   @threads pure */
World worldOf(const mission::Mission& mission, std::vector<mission::SiteInFrame> sites, terrain::TerrainPyramid terrain);

}  // namespace vp::landing
