#pragma once

#include "core/geo/pose.h"
#include "core/terrain/elevation_grid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace vp::terrain {

/** Max and min pyramids over an ElevationGrid: bounds over any box in O(1). Level 0 is the grid itself; a cell of
 *  level l covers 2^l x 2^l cells. The planner's fast bound; the checker never uses it.
 *  @threads const members are pure */
class TerrainPyramid {
public:
  TerrainPyramid() = default;
  explicit TerrainPyramid(std::shared_ptr<const ElevationGrid> grid);

  [[nodiscard]] const ElevationGrid& grid() const { return *grid_; }

  /** Upper bound of the terrain over a closed box [m MSL]: at least the value of every cell that the box touches (a
   *  cell nearer than 1e-9 of its size counts as touched), infinity if any of them is unknown or outside, if the box is
   *  empty or if a side is no number. May look at a few cells around the box: at most twice its larger side beyond it,
   *  none beyond the touched cells if the box touches at most 2 x 2 cells. @cost O(1), at most 4 cells */
  [[nodiscard]] double upperIn(const geo::Box& box) const {
    const double west = (box.minX - originX_) * perCell_ - kTouch;
    const double south = (box.minY - originY_) * perCell_ - kTouch;
    const double east = (box.maxX - originX_) * perCell_ + kTouch;
    const double north = (box.maxY - originY_) * perCell_ + kTouch;
    // One test for outside, empty and not-a-number; past it every value fits an int and truncation is floor.
    const bool isInside = (west >= 0.0) & (south >= 0.0) & (east < columns_) & (north < rows_) & (west <= east) & (south <= north);
    if (!isInside) {
      return std::numeric_limits<double>::infinity();
    }
    return static_cast<double>(upperOfCells(static_cast<int>(west), static_cast<int>(south), static_cast<int>(east), static_cast<int>(north)));
  }

  /** Lower bound of the known cell values over a closed box [m MSL]; -infinity if none is known. The part of the box
   *  outside the grid does not count. Looks around the box as upperIn does. @cost O(1), at most 4 cells */
  [[nodiscard]] double lowerIn(const geo::Box& box) const;

  /** Number of levels, level 0 included; 0 without a grid. */
  [[nodiscard]] int levels() const { return levelCount_; }

  /// One level of the max pyramid: its cells row by row from the south-west.
  struct Upper {
    const float* values = nullptr;  ///< m MSL, infinity for unknown
    std::size_t columns = 0;
  };

  /** For those who walk the cells themselves. @pre 0 <= level < levels() */
  [[nodiscard]] Upper upperLevel(int level) const {
    const Level& found = levels_[static_cast<std::size_t>(level)];
    return {found.upper, found.columns};
  }

private:
  struct Level {
    const float* upper = nullptr;
    const float* lower = nullptr;
    std::size_t columns = 0;
  };
  static constexpr double kTouch = 1e-9;  ///< of a cell: rounding noise of the index arithmetic, far below a millimetre
  static constexpr int kMaxLevels = 33;   ///< level 0 and one for each bit of an int

  /// Least level on which the cells [column0, column1] x [row0, row1] lie in at most 2 x 2 cells: 2^level >= both differences.
  static int levelFor(int column0, int row0, int column1, int row1) {
    const int reach = std::max({column1 - column0, row1 - row0, 1});
    return std::bit_width((static_cast<unsigned>(reach - 1) << 1U) | 1U) - 1;  // the lowest bit spares a test for zero
  }

  [[nodiscard]] float upperOfCells(int column0, int row0, int column1, int row1) const {
    const int l = levelFor(column0, row0, column1, row1);
    const Level& level = levels_[static_cast<std::size_t>(l)];
    const float* south = level.upper + static_cast<std::size_t>(row0 >> l) * level.columns;
    const float* north = level.upper + static_cast<std::size_t>(row1 >> l) * level.columns;
    const std::size_t west = static_cast<std::size_t>(column0 >> l);
    const std::size_t east = static_cast<std::size_t>(column1 >> l);
    return std::max(std::max(south[west], south[east]), std::max(north[west], north[east]));
  }

  double originX_ = 0.0;
  double originY_ = 0.0;
  double perCell_ = 1.0;
  double columns_ = 0.0;
  double rows_ = 0.0;
  std::array<Level, kMaxLevels> levels_;  ///< views of grid_ and of storage_, which copies of the pyramid share
  int levelCount_ = 0;
  std::shared_ptr<const ElevationGrid> grid_;
  std::shared_ptr<const std::vector<float>> storage_;
};

}  // namespace vp::terrain
