#include "core/emergency/octree_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vp::emergency {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();
/// A cell this near counts as touched [cells], as LinearOctree has it.
constexpr double kTouch = 1e-9;

/// Which columns (or rows) of the octree a column (or row) of terrain touches; last < first: none.
struct Range {
  int first = 0;
  int last = -1;
};

std::vector<Range> touched(double terrainLow, double terrainCell, int terrainCount, double low, double cell, int count) {
  std::vector<Range> ranges;
  for (int i = 0; i < terrainCount; ++i) {
    const double west = (terrainLow + i * terrainCell - low) / cell - kTouch;
    const double east = (terrainLow + (i + 1) * terrainCell - low) / cell + kTouch;
    ranges.push_back({static_cast<int>(std::clamp(std::floor(west), 0.0, static_cast<double>(count))),
                      static_cast<int>(std::clamp(std::floor(east), -1.0, count - 1.0))});
  }
  return ranges;
}

/// Highest of each value and its neighbours up to `reach` to either side, along a row: van Herk 1992, three comparisons a value.
void widen(const float* row, std::size_t count, std::size_t reach, float* widened, std::vector<float>& scratch) {
  const std::size_t window = 2 * reach + 1;
  const std::size_t padded = (count + 2 * reach + window - 1) / window * window;
  scratch.assign(3 * padded, -kInfinite);
  float* const values = scratch.data();
  float* const ahead = values + padded;
  float* const behind = ahead + padded;
  std::copy(row, row + count, values + reach);
  for (std::size_t block = 0; block < padded; block += window) {
    std::partial_sum(values + block, values + block + window, ahead + block, [](float a, float b) { return std::max(a, b); });
    float most = -kInfinite;
    for (std::size_t i = block + window; i-- > block;) {
      most = std::max(most, values[i]);
      behind[i] = most;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    widened[i] = std::max(behind[i], ahead[i + 2 * reach]);
  }
}

/// Each column as high as any that comes nearer than `enlarge` to it.
void enlargeBy(double enlarge, const CellBox& box, std::vector<float>& heights) {
  const auto columns = static_cast<std::size_t>(box.count[0]);
  const auto rows = static_cast<std::size_t>(box.count[1]);
  const std::vector<float> given = heights;
  std::vector<float> widened(given.size());
  std::vector<float> scratch;
  const auto gap = [](std::size_t apart, double cell) { return apart == 0 ? 0.0 : static_cast<double>(apart - 1) * cell; };
  for (std::size_t up = 0; up < rows && gap(up, box.cell.y) < enlarge; ++up) {
    std::size_t reach = 0;
    while (reach < columns && std::hypot(gap(reach + 1, box.cell.x), gap(up, box.cell.y)) < enlarge) {
      ++reach;
    }
    for (std::size_t row = 0; row < rows; ++row) {
      widen(given.data() + row * columns, columns, reach, widened.data() + row * columns, scratch);
    }
    for (std::size_t row = 0; row + up < rows; ++row) {
      for (std::size_t i = 0; i < columns; ++i) {
        float& south = heights[row * columns + i];
        float& north = heights[(row + up) * columns + i];
        south = std::max(south, widened[(row + up) * columns + i]);
        north = std::max(north, widened[row * columns + i]);
      }
    }
  }
}

}  // namespace

CellBox cellsOver(const OctreeGround& ground) {
  const double width = ground.area.maxX - ground.area.minX;
  const double depth = ground.area.maxY - ground.area.minY;
  const double cell = std::max({ground.leastCell, width / ground.mostCells[0], depth / ground.mostCells[1], 1e-3});
  CellBox box;
  box.low = {ground.area.minX, ground.area.minY, ground.lowest};
  box.cell = {cell, cell, (ground.highest - ground.lowest) / ground.mostCells[2]};
  // rounding must not add a column that the limit does not allow
  box.count = {std::clamp(static_cast<int>(std::ceil(width / cell - kTouch)), 1, ground.mostCells[0]),
               std::clamp(static_cast<int>(std::ceil(depth / cell - kTouch)), 1, ground.mostCells[1]), ground.mostCells[2]};
  return box;
}

std::vector<float> blockedHeights(const terrain::ElevationGrid& terrain, const CellBox& box, double clearance, double enlarge) {
  const auto columns = static_cast<std::size_t>(box.count[0]);
  const geo::Box known = terrain.extent();
  std::vector<float> heights(columns * static_cast<std::size_t>(box.count[1]), kInfinite);
  for (int row = 0; row < box.count[1]; ++row) {
    for (int column = 0; column < box.count[0]; ++column) {
      const geo::Point southWest{box.low.x + column * box.cell.x, box.low.y + row * box.cell.y};
      const geo::Point northEast{southWest.x + box.cell.x, southWest.y + box.cell.y};
      if (known.grown(kTouch * terrain.cellSize()).contains(southWest) && known.grown(kTouch * terrain.cellSize()).contains(northEast)) {
        heights[static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column)] = -kInfinite;
      }
    }
  }
  const std::vector<Range> east = touched(terrain.originX(), terrain.cellSize(), terrain.columns(), box.low.x, box.cell.x, box.count[0]);
  const std::vector<Range> north = touched(terrain.originY(), terrain.cellSize(), terrain.rows(), box.low.y, box.cell.y, box.count[1]);
  for (int j = 0; j < terrain.rows(); ++j) {
    const Range rows = north[static_cast<std::size_t>(j)];
    for (int i = 0; rows.first <= rows.last && i < terrain.columns(); ++i) {
      const Range range = east[static_cast<std::size_t>(i)];
      // to the next float up: rounding must not lower it
      const float height = std::nextafter(static_cast<float>(static_cast<double>(terrain.upperInCell(i, j)) + clearance), kInfinite);
      for (int row = rows.first; row <= rows.last; ++row) {
        for (int column = range.first; column <= range.last; ++column) {
          float& most = heights[static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column)];
          most = std::max(most, height);
        }
      }
    }
  }
  if (enlarge > 0.0) {
    enlargeBy(enlarge, box, heights);
  }
  return heights;
}

Result<LinearOctree> octreeOver(const terrain::ElevationGrid& terrain, const OctreeGround& ground, const Job& job) {
  const CellBox box = cellsOver(ground);
  return LinearOctree::build(box, blockedHeights(terrain, box, ground.clearance, ground.enlarge), {}, job);
}

}  // namespace vp::emergency
