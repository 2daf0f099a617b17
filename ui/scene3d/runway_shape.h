#pragma once

#include "ui/scene3d/scene_data.h"
#include "ui/style/chart_colors.h"

#include <vector>

namespace vp::scene3d {

/** A runway as triangles on the ground: outline, surface, and at each usable end an arrow in landing direction. Those that
 *  may not be used are hollow and have none. Metres MSL, no exaggeration. */
struct RunwayShape {
  struct Corner {
    ScenePoint place;
    QColor color;
  };
  std::vector<Corner> triangles;  ///< in the order that they are drawn over each other
  ScenePoint centre;
  double width = 0.0;  ///< m, outline included
};

/** @param terrain  that the runway is draped on where it is higher than its elevation; may be null */
RunwayShape runwayShape(const SceneRunway& runway, const TerrainModel* terrain, const style::ChartColors& colors);

}  // namespace vp::scene3d
