#pragma once

#include <memory>
#include <vector>

#include "core/geo/pose.h"
#include "core/terrain/elevation_grid.h"

namespace vp::terrain {

/** Max and min pyramids over an ElevationGrid: bounds over any box in O(1). Level 0 is the grid itself; a cell of
 *  level l covers 2^l x 2^l cells. The planner's fast bound; the checker never uses it.
 *  @threads const members are pure */
class TerrainPyramid {
public:
  TerrainPyramid() = default;
  explicit TerrainPyramid(std::shared_ptr<const ElevationGrid> grid);

  [[nodiscard]] const ElevationGrid& grid() const { return *grid_; }

  /** Upper bound of the terrain over a closed box [m MSL]: at least the value of every cell that the box touches,
   *  infinity if any of them is unknown or outside. May look at a few cells around the box: at most twice its larger
   *  side beyond it, none beyond the touched cells if the box touches at most 2 x 2 cells. @cost O(1), at most 4 cells */
  [[nodiscard]] double upperIn(const geo::Box& box) const;

  /** Lower bound of the known cell values over a closed box [m MSL]; -infinity if none is known. */
  [[nodiscard]] double lowerIn(const geo::Box& box) const;

  [[nodiscard]] int levels() const;

private:
  struct Level {
    int columns = 0;
    int rows = 0;
    std::vector<float> upper;
    std::vector<float> lower;
  };
  std::shared_ptr<const ElevationGrid> grid_;
  std::vector<Level> levels_;  ///< level 1 upwards
};

}  // namespace vp::terrain
