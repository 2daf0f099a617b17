#include "core/terrain/elevation_grid.h"

#include "core/base/expect.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::terrain {
namespace {

/// floor(u) held to [-1, count]; -1 for what is no number. The test comes before the conversion, which would else be undefined.
int indexOf(double u, int count) {
  if (!(u >= 0.0)) {
    return -1;
  }
  return u < count ? static_cast<int>(u) : count;
}

}  // namespace

ElevationGrid::ElevationGrid(double originX, double originY, double cell, int columns, int rows, std::vector<float> values)
    : originX_(originX), originY_(originY), cell_(cell), columns_(columns), rows_(rows), values_(std::move(values)) {
  VP_EXPECT(std::isfinite(originX) && std::isfinite(originY) && std::isfinite(cell));
  VP_EXPECT(cell > 0.0 && columns > 0 && rows > 0);
  VP_EXPECT(values_.size() == static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (float& value : values_) {
    value = value > std::numeric_limits<float>::lowest() ? value : kUnknownUpper;
  }
}

geo::Box ElevationGrid::extent() const {
  return {originX_, originY_, originX_ + columns_ * cell_, originY_ + rows_ * cell_};
}

int ElevationGrid::columnOf(double x) const {
  return indexOf((x - originX_) / cell_, columns_);
}

int ElevationGrid::rowOf(double y) const {
  return indexOf((y - originY_) / cell_, rows_);
}

double ElevationGrid::upperAt(geo::Point p) const {
  const double u = (p.x - originX_) / cell_;
  const double v = (p.y - originY_) / cell_;
  const int i = indexOf(u, columns_);
  const int j = indexOf(v, rows_);
  float upper = upperInCell(i, j);
  const bool onColumn = u == static_cast<double>(i);
  const bool onRow = v == static_cast<double>(j);
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
