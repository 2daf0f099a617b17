#pragma once

#include "core/terrain/elevation_grid.h"
#include "ui/map/raster_sampling.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

namespace vp::map {

/** Terrain at every scale for drawing: level l holds the mean of 2^l x 2^l cells of the grid; unknown where less than half
 *  of them is known. A picture and no bound: heights that count come from the grid and its pyramid.
 *  @threads safe; the first use builds the levels (some 40 ms for 20 million cells), others wait for it */
class HeightLevels {
public:
  /** @pre grid is not null */
  explicit HeightLevels(std::shared_ptr<const terrain::ElevationGrid> grid) : grid_(std::move(grid)) {}

  /** The level whose cells are about as large as `metresPerPixel`, the grid itself when zoomed in further. */
  [[nodiscard]] Raster levelFor(double metresPerPixel) const;
  [[nodiscard]] const terrain::ElevationGrid& grid() const { return *grid_; }
  /** Makes a build under way end early, coarse levels then missing. For shutting down. */
  void abandon() const { abandoned_ = true; }

private:
  struct Level {
    int columns = 0;
    int rows = 0;
    std::vector<float> values;
  };
  void build() const;

  std::shared_ptr<const terrain::ElevationGrid> grid_;
  mutable std::once_flag built_;
  mutable std::vector<Level> coarser_;  ///< level 1 and up
  mutable std::atomic<bool> abandoned_ = false;
};

}  // namespace vp::map
