#pragma once

#include "core/geo/local_frame.h"
#include "core/mission/plan.h"
#include "core/terrain/elevation_grid.h"
#include "core/terrain/terrain_pyramid.h"

#include <memory>
#include <vector>

namespace vp::document {

/** Terrain as loaded: shared between views, jobs and the planner, never changed. */
struct TerrainData {
  geo::LocalFrame frame;
  std::shared_ptr<const terrain::ElevationGrid> grid;  ///< never null
  terrain::TerrainPyramid pyramid;
  std::vector<mission::TerrainReference> files;  ///< absolute paths
  double lowest = 0.0;                           ///< m MSL, of the known cells; both 0 if nothing is known
  double highest = 0.0;
};

/** Adds pyramid and range to a grid. @pre grid is not null */
std::shared_ptr<const TerrainData> makeTerrainData(const geo::LocalFrame& frame, std::shared_ptr<const terrain::ElevationGrid> grid,
                                                   std::vector<mission::TerrainReference> files);

}  // namespace vp::document
