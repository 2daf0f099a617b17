#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/geo/local_frame.h"
#include "core/geo/pose.h"
#include "core/terrain/post_mosaic.h"

#include <cstddef>
#include <vector>

namespace vp::terrain::detail {

/// Place and size of a grid of the local frame; see ElevationGrid.
struct GridLayout {
  double originX = 0.0;
  double originY = 0.0;
  double cell = 1.0;
  int columns = 0;
  int rows = 0;
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
};

/** The local frame as a target for CrsTransform. */
Result<Crs> crsOf(const geo::LocalFrame& frame);

/** Posts along the edge of a raster in post coordinates, closed, dense enough for its outline in another projection. */
std::vector<geo::Point> outline(int columns, int rows);

/** Raises `grid` to the posts of a mosaic: each cell becomes at least the highest post that surrounds any point of the
 *  cell; cells of which any point has an unknown post around it or lies outside the mosaic stay as they are. Cells that
 *  were known keep the higher value.
 *
 *  The map from the frame to post coordinates is taken on a lattice of patches and interpolated bilinearly in between.
 *  A bilinear map has its extremes over a cell at the cell's corners, so the corners bound the cell exactly; what the
 *  true map deviates from it is bounded per patch by second differences with double safety, and added.
 *  @param posts as of readMosaic; used up as work space   @errors Unsupported, Cancelled */
Result<void> warpInto(const Mosaic& mosaic, std::vector<float>& posts, const Crs& frame, const GridLayout& layout, std::vector<float>& grid,
                      const Job& job);

}  // namespace vp::terrain::detail
