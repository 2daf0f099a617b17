#include "ui/document/terrain_data.h"

#include <algorithm>
#include <cmath>

namespace vp::document {

std::shared_ptr<const TerrainData> makeTerrainData(const geo::LocalFrame& frame, std::shared_ptr<const terrain::ElevationGrid> grid,
                                                   std::vector<mission::TerrainReference> files) {
  auto data = std::make_shared<TerrainData>();
  data->frame = frame;
  data->pyramid = terrain::TerrainPyramid(grid);
  bool known = false;
  for (const float value : grid->values()) {
    if (std::isfinite(value)) {
      const auto height = static_cast<double>(value);
      data->lowest = known ? std::min(data->lowest, height) : height;
      data->highest = known ? std::max(data->highest, height) : height;
      known = true;
    }
  }
  data->grid = std::move(grid);
  data->files = std::move(files);
  return data;
}

}  // namespace vp::document
