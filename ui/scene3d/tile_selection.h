#pragma once

#include "ui/scene3d/camera_state.h"
#include "ui/scene3d/terrain_model.h"

#include <functional>
#include <vector>

namespace vp::scene3d {

/** How fine the terrain is drawn. */
struct TerrainDetail {
  int tiles = 90;         ///< most tiles in a picture, some 640 triangles each
  double quadSize = 8.0;  ///< px that a quad may take before its tile is split
};

/** Which tiles to draw, and which would be better but are not there yet, most wanted first. */
struct TileChoice {
  std::vector<TileId> shown;
  std::vector<TileId> wanted;
};

/** Chooses tiles for a camera: from the coarsest, the tile with the largest quads on the picture is split first, until all
 *  are small enough or the budget is spent. A tile is split only when all its parts within view are there, so there is never
 *  a hole; tiles out of view are left out.
 *  @param isThere  whether a tile can be drawn now; the one tile of the coarsest level must be */
TileChoice chooseTiles(const TerrainModel& model, const CameraState& camera, double exaggeration, const TerrainDetail& detail,
                       const std::function<bool(TileId)>& isThere);

}  // namespace vp::scene3d
