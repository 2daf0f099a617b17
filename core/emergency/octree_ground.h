#pragma once

#include "core/emergency/linear_octree.h"
#include "core/geo/pose.h"
#include "core/terrain/elevation_grid.h"

#include <vector>

namespace vp::emergency {

/** What the ground blocks of the space over a part of the terrain. */
struct OctreeGround {
  geo::Box area;                                  ///< not empty
  double lowest = 0.0;                            ///< m MSL, bottom of the space
  double highest = 0.0;                           ///< m MSL, its top; above lowest
  std::array<int, 3> mostCells{1200, 1200, 500};  ///< along east, north and up: those of [5] section 5.5
  double leastCell = 0.0;                         ///< m: cells on the ground need not be smaller
  double clearance = 0.0;                         ///< m that the ground is raised by
  double enlarge = 0.0;                           ///< m: ground this near counts too, as in [5] section 4.1
};

/** The cells of that space: squares on the ground, as small as they may be. */
CellBox cellsOver(const OctreeGround& ground);

/** Up to where each column of these cells is blocked [m MSL], rows from the south-west: the highest cell of the terrain that touches the column or
 *  comes nearer to it than `enlarge`, and the clearance. Infinity where any of it is unknown; beyond the terrain everything is.
 *  @cost O(cells of terrain in the area + columns * enlarge / cell)   @threads pure */
std::vector<float> blockedHeights(const terrain::ElevationGrid& terrain, const CellBox& box, double clearance, double enlarge);

/** The free space over the ground. @errors Cancelled */
Result<LinearOctree> octreeOver(const terrain::ElevationGrid& terrain, const OctreeGround& ground, const Job& job);

}  // namespace vp::emergency
