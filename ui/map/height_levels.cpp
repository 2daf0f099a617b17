#include "ui/map/height_levels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::map {
namespace {

constexpr int kCoarsestSide = 8;

/// Mean of the known ones of four cells; unknown if fewer than two are known.
float meanOf(float a, float b, float c, float d) {
  const float sum = a + b + c + d;
  if (std::isfinite(sum)) {
    return 0.25F * sum;
  }
  float known = 0.0F;
  int count = 0;
  for (const float value : {a, b, c, d}) {
    if (std::isfinite(value)) {
      known += value;
      ++count;
    }
  }
  return count >= 2 ? known / static_cast<float>(count) : std::numeric_limits<float>::infinity();
}

}  // namespace

void HeightLevels::build() const {
  const float* finer = grid_->values().data();
  int columns = grid_->columns();
  int rows = grid_->rows();
  while (std::max(columns, rows) > kCoarsestSide) {
    Level level{(columns + 1) / 2, (rows + 1) / 2, {}};
    level.values.resize(static_cast<std::size_t>(level.columns) * static_cast<std::size_t>(level.rows));
    for (int r = 0; r < level.rows; ++r) {
      if (abandoned_) {
        return;
      }
      const float* south = finer + static_cast<std::ptrdiff_t>(2 * r) * columns;
      const float* north = 2 * r + 1 < rows ? south + columns : south;
      float* to = level.values.data() + static_cast<std::ptrdiff_t>(r) * level.columns;
      for (int c = 0; c < level.columns; ++c) {
        const int west = 2 * c;
        const int east = std::min(west + 1, columns - 1);
        to[c] = meanOf(south[west], south[east], north[west], north[east]);
      }
    }
    columns = level.columns;
    rows = level.rows;
    coarser_.push_back(std::move(level));
    finer = coarser_.back().values.data();
  }
}

Raster HeightLevels::levelFor(double metresPerPixel) const {
  std::call_once(built_, [this] { build(); });
  const double cell = grid_->cellSize();
  const int wanted = static_cast<int>(std::lround(std::log2(std::max(metresPerPixel / cell, 1.0))));
  const int level = std::min(wanted, static_cast<int>(coarser_.size()));
  if (level == 0) {
    return {grid_->originX(), grid_->originY(), cell, grid_->columns(), grid_->rows(), grid_->values().data()};
  }
  const Level& coarse = coarser_[static_cast<std::size_t>(level) - 1];
  return {grid_->originX(), grid_->originY(), std::ldexp(cell, level), coarse.columns, coarse.rows, coarse.values.data()};
}

}  // namespace vp::map
