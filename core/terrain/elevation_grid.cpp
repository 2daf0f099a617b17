#include "core/terrain/elevation_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/expect.h"

namespace vp::terrain {

ElevationGrid::ElevationGrid(double originX, double originY, double cell, int columns, int rows, std::vector<float> values)
    : originX_(originX), originY_(originY), cell_(cell), columns_(columns), rows_(rows), values_(std::move(values)) {
  VP_EXPECT(cell > 0.0 && columns > 0 && rows > 0);
  VP_EXPECT(values_.size() == static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
}

geo::Box ElevationGrid::extent() const { return {originX_, originY_, originX_ + columns_ * cell_, originY_ + rows_ * cell_}; }

int ElevationGrid::columnOf(double x) const { return static_cast<int>(std::floor((x - originX_) / cell_)); }

int ElevationGrid::rowOf(double y) const { return static_cast<int>(std::floor((y - originY_) / cell_)); }

double ElevationGrid::upperAt(geo::Point p) const {
  const double u = (p.x - originX_) / cell_;
  const double v = (p.y - originY_) / cell_;
  const int i = static_cast<int>(std::floor(u));
  const int j = static_cast<int>(std::floor(v));
  float upper = upperInCell(i, j);
  const bool onColumn = u == std::floor(u);
  const bool onRow = v == std::floor(v);
  if (onColumn) {
    upper = std::max(upper, upperInCell(i - 1, j));
  }
  if (onRow) {
    upper = std::max(upper, upperInCell(i, j - 1));
  }
  if (onColumn && onRow) {
    upper = std::max(upper, upperInCell(i - 1, j - 1));
  }
  return static_cast<double>(upper);
}

}  // namespace vp::terrain
