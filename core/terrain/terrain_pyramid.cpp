#include "core/terrain/terrain_pyramid.h"

#include "core/base/expect.h"

#include <cmath>
#include <utility>

namespace vp::terrain {
namespace {

struct Size {
  std::size_t columns = 0;
  std::size_t rows = 0;
  [[nodiscard]] std::size_t count() const { return columns * rows; }
  [[nodiscard]] Size halved() const { return {(columns + 1) / 2, (rows + 1) / 2}; }
};

/// One level from the one below: each cell takes the best of up to 2 x 2; cells outside do not count.
template <typename Best>
void reduce(const float* fine, Size fineSize, float* coarse, Best best) {
  const Size size = fineSize.halved();
  for (std::size_t row = 0; row < size.rows; ++row) {
    const float* south = fine + 2 * row * fineSize.columns;
    const float* north = 2 * row + 1 < fineSize.rows ? south + fineSize.columns : south;
    float* out = coarse + row * size.columns;
    const std::size_t pairs = fineSize.columns / 2;
    for (std::size_t column = 0; column < pairs; ++column) {
      out[column] = best(best(south[2 * column], south[2 * column + 1]), best(north[2 * column], north[2 * column + 1]));
    }
    if (pairs < size.columns) {
      out[pairs] = best(south[2 * pairs], north[2 * pairs]);
    }
  }
}

}  // namespace

TerrainPyramid::TerrainPyramid(std::shared_ptr<const ElevationGrid> grid) : grid_(std::move(grid)) {
  VP_EXPECT(grid_ != nullptr && grid_->columns() > 0 && grid_->rows() > 0);
  originX_ = grid_->originX();
  originY_ = grid_->originY();
  perCell_ = 1.0 / grid_->cellSize();
  columns_ = grid_->columns();
  rows_ = grid_->rows();

  const Size base{static_cast<std::size_t>(grid_->columns()), static_cast<std::size_t>(grid_->rows())};
  std::size_t stored = 0;
  for (Size size = base; size.count() > 1;) {
    size = size.halved();
    stored += 2 * size.count();
  }
  auto storage = std::make_shared<std::vector<float>>(stored);
  // Unknown is plus infinity, so it wins every maximum and loses every minimum: the same numbers serve both pyramids.
  levels_[0] = {grid_->values().data(), grid_->values().data(), base.columns};
  levelCount_ = 1;
  float* next = storage->data();
  for (Size size = base; size.count() > 1; size = size.halved()) {
    const Level& fine = levels_[static_cast<std::size_t>(levelCount_ - 1)];
    float* upper = next;
    float* lower = upper + size.halved().count();
    next = lower + size.halved().count();
    reduce(fine.upper, size, upper, [](float a, float b) { return a > b ? a : b; });
    reduce(fine.lower, size, lower, [](float a, float b) { return a < b ? a : b; });
    levels_[static_cast<std::size_t>(levelCount_)] = {upper, lower, size.halved().columns};
    ++levelCount_;
  }
  storage_ = std::move(storage);
}

double TerrainPyramid::lowerIn(const geo::Box& box) const {
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  const double west = (box.minX - originX_) * perCell_ - kTouch;
  const double south = (box.minY - originY_) * perCell_ - kTouch;
  const double east = (box.maxX - originX_) * perCell_ + kTouch;
  const double north = (box.maxY - originY_) * perCell_ + kTouch;
  const bool meetsGrid = west < columns_ && south < rows_ && east >= 0.0 && north >= 0.0;
  if (!(meetsGrid && west <= east && south <= north)) {
    return kNone;
  }
  const int column0 = static_cast<int>(std::max(west, 0.0));
  const int row0 = static_cast<int>(std::max(south, 0.0));
  const int column1 = static_cast<int>(std::min(east, columns_ - 1.0));
  const int row1 = static_cast<int>(std::min(north, rows_ - 1.0));
  const int l = levelFor(column0, row0, column1, row1);
  const Level& level = levels_[static_cast<std::size_t>(l)];
  const auto lowerOf = [&level, l](int column, int row) {
    return level.lower[static_cast<std::size_t>(row >> l) * level.columns + static_cast<std::size_t>(column >> l)];
  };
  const float lower = std::min({lowerOf(column0, row0), lowerOf(column1, row0), lowerOf(column0, row1), lowerOf(column1, row1)});
  return lower < kUnknownUpper ? static_cast<double>(lower) : kNone;
}

}  // namespace vp::terrain
