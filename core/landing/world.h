#pragma once

#include "core/aircraft/glide_model.h"
#include "core/mission/plan.h"
#include "core/terrain/terrain_pyramid.h"

#include <vector>

namespace vp::landing {

/** Everything a glide depends on: ground, aircraft, runways, and how far to stay away from the ground.
 *  Lengths in metres, frame as in geo::LocalFrame. A value snapshot; share it between threads as const. */
struct World {
  terrain::TerrainPyramid terrain;
  aircraft::GlideModel glide;
  std::vector<mission::SiteInFrame> sites;
  double clearance = 100.0;    ///< above terrain everywhere
  double arrivalMargin = 0.0;  ///< above a site's elevation on arrival
};

}  // namespace vp::landing
