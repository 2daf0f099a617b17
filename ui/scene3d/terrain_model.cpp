#include "ui/scene3d/terrain_model.h"

#include "core/base/expect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace vp::scene3d {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::infinity();

int coarserCount(int count) {
  return count / 2 + 1;  // ceil((count - 1) / 2) + 1
}

int tilesFor(int posts) {
  return std::max(1, (posts - 1 + TerrainModel::kTileQuads - 1) / TerrainModel::kTileQuads);
}

/// The binomial filter 1 4 6 4 1 along a row, over known cells only; unknown ones stay unknown.
void smoothLine(const float* from, float* to, int count) {
  for (int i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (!(from[at] < kUnknown)) {
      to[at] = kUnknown;
      continue;
    }
    float sum = 0.0F;
    float weights = 0.0F;
    for (int k = std::max(-2, -i); k <= std::min(2, count - 1 - i); ++k) {
      const float value = from[static_cast<std::size_t>(i + k)];
      if (value < kUnknown) {
        const float weight = k == 0 ? 6.0F : std::abs(k) == 1 ? 4.0F : 1.0F;
        sum += weight * value;
        weights += weight;
      }
    }
    to[at] = sum / weights;
  }
}

/// The grid's upper bounds step up and down where the source's posts do not fall on its cells; that is not ground, so it is
/// smoothed away.
std::vector<float> smoothed(const terrain::ElevationGrid& grid, const std::stop_token& stop) {
  const auto columns = static_cast<std::size_t>(grid.columns());
  const auto rows = static_cast<std::size_t>(grid.rows());
  std::vector<float> alongRows(columns * rows);
  for (std::size_t row = 0; row < rows && !stop.stop_requested(); ++row) {
    smoothLine(grid.values().data() + row * columns, alongRows.data() + row * columns, grid.columns());
  }
  // down the columns row by row, so that memory is read in order
  std::vector<float> result(columns * rows);
  constexpr std::array<float, 5> kWeights{1.0F, 4.0F, 6.0F, 4.0F, 1.0F};
  for (std::size_t row = 0; row < rows && !stop.stop_requested(); ++row) {
    const std::size_t first = row < 2 ? 0 : row - 2;
    const std::size_t last = std::min(row + 2, rows - 1);
    for (std::size_t column = 0; column < columns; ++column) {
      float sum = 0.0F;
      float weights = 0.0F;
      for (std::size_t j = first; j <= last; ++j) {
        const float value = alongRows[j * columns + column];
        const float weight = value < kUnknown ? kWeights[j + 2 - row] : 0.0F;
        sum += value < kUnknown ? weight * value : 0.0F;
        weights += weight;
      }
      result[row * columns + column] = alongRows[row * columns + column] < kUnknown ? sum / weights : kUnknown;
    }
  }
  return result;
}

}  // namespace

std::shared_ptr<const TerrainModel> TerrainModel::build(std::shared_ptr<const document::TerrainData> terrain, const std::stop_token& stop) {
  VP_EXPECT(terrain != nullptr && terrain->grid->columns() >= 2 && terrain->grid->rows() >= 2);
  std::shared_ptr<TerrainModel> model(new TerrainModel);
  const terrain::ElevationGrid& grid = *terrain->grid;
  model->terrain_ = std::move(terrain);
  Level finest;
  finest.columns = grid.columns();
  finest.rows = grid.rows();
  finest.storage = smoothed(grid, stop);
  finest.heights = finest.storage.data();
  model->levels_.push_back(std::move(finest));
  while (tilesFor(model->levels_.back().columns) > 1 || tilesFor(model->levels_.back().rows) > 1) {
    model->levels_.push_back(coarser(model->levels_.back(), stop));
    if (stop.stop_requested()) {
      return nullptr;
    }
  }
  model->extent_.add({model->xOf(0, 0), model->yOf(0, 0)});
  model->extent_.add({model->xOf(0, grid.columns() - 1), model->yOf(0, grid.rows() - 1)});
  model->unknown_ = UnknownRegions(grid, stop);
  model->addTileRanges(stop);
  const double side = std::max(model->extent_.maxX - model->extent_.minX, model->extent_.maxY - model->extent_.minY);
  model->base_ = model->lowest() - 0.012 * side;
  return stop.stop_requested() ? nullptr : model;
}

TerrainModel::Level TerrainModel::coarser(const Level& fine, const std::stop_token& stop) {
  Level level;
  level.columns = coarserCount(fine.columns);
  level.rows = coarserCount(fine.rows);
  const auto count = static_cast<std::size_t>(level.columns) * static_cast<std::size_t>(level.rows);
  level.storage.resize(count);
  level.unknown.resize(count);
  for (int row = 0; row < level.rows && !stop.stop_requested(); ++row) {
    const int middleRow = std::min(2 * row, fine.rows - 1);
    for (int column = 0; column < level.columns; ++column) {
      const int middle = std::min(2 * column, fine.columns - 1);
      float sum = 0.0F;
      float weights = 0.0F;
      bool unknown = false;
      for (int dj = -1; dj <= 1; ++dj) {
        const int j = std::clamp(middleRow + dj, 0, fine.rows - 1);
        const std::size_t start = static_cast<std::size_t>(j) * static_cast<std::size_t>(fine.columns);
        for (int di = -1; di <= 1; ++di) {
          const std::size_t at = start + static_cast<std::size_t>(std::clamp(middle + di, 0, fine.columns - 1));
          const float value = fine.heights[at];
          const bool isKnown = value < kUnknown;
          const int steps = std::abs(dj) + std::abs(di);
          const float weight = !isKnown ? 0.0F : steps == 0 ? 4.0F : steps == 1 ? 2.0F : 1.0F;
          sum += isKnown ? weight * value : 0.0F;
          weights += weight;
          unknown = unknown || !isKnown || (!fine.unknown.empty() && fine.unknown[at] != 0);
        }
      }
      const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(level.columns) + static_cast<std::size_t>(column);
      const float here =
          fine.heights[static_cast<std::size_t>(middleRow) * static_cast<std::size_t>(fine.columns) + static_cast<std::size_t>(middle)];
      level.storage[at] = here < kUnknown ? sum / weights : kUnknown;
      level.unknown[at] = unknown ? 1 : 0;
    }
  }
  level.heights = level.storage.data();
  return level;
}

void TerrainModel::addTileRanges(const std::stop_token& stop) {
  constexpr std::pair<float, float> kNothing{kUnknown, -kUnknown};
  Level& finest = levels_.front();
  const int tilesEast = tilesFor(finest.columns);
  finest.z.assign(static_cast<std::size_t>(tilesEast) * static_cast<std::size_t>(tilesFor(finest.rows)), kNothing);
  const auto widen = [](std::pair<float, float>& range, float low, float high) {
    range = {std::min(range.first, low), std::max(range.second, high)};
  };
  int knownWest = finest.columns;
  int knownEast = -1;
  int knownSouth = finest.rows;
  int knownNorth = -1;
  for (int row = 0; row < finest.rows && !stop.stop_requested(); ++row) {
    for (int column = 0; column < finest.columns; ++column) {
      float value = finest.heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(finest.columns) + static_cast<std::size_t>(column)];
      if (value < kUnknown) {
        knownWest = std::min(knownWest, column);
        knownEast = std::max(knownEast, column);
        knownSouth = std::min(knownSouth, row);
        knownNorth = row;
      } else if (const auto lid = unknown_.lidOver(column, row)) {
        value = static_cast<float>(*lid);  // drawn too
      } else {
        continue;
      }
      // a post on the edge of a tile belongs to its neighbour too
      for (int tileRow = std::max(0, (row - 1) / kTileQuads); tileRow <= std::min(row / kTileQuads, tilesFor(finest.rows) - 1); ++tileRow) {
        for (int tile = std::max(0, (column - 1) / kTileQuads); tile <= std::min(column / kTileQuads, tilesEast - 1); ++tile) {
          widen(finest.z[static_cast<std::size_t>(tileRow) * static_cast<std::size_t>(tilesEast) + static_cast<std::size_t>(tile)], value, value);
        }
      }
    }
  }
  if (knownEast >= 0) {
    knownArea_.add({xOf(0, knownWest), yOf(0, knownSouth)});
    knownArea_.add({xOf(0, knownEast), yOf(0, knownNorth)});
  }
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    const Level& fine = levels_[l - 1];
    Level& level = levels_[l];
    const int fineEast = tilesFor(fine.columns);
    const int east = tilesFor(level.columns);
    level.z.assign(static_cast<std::size_t>(east) * static_cast<std::size_t>(tilesFor(level.rows)), kNothing);
    for (std::size_t i = 0; i < fine.z.size(); ++i) {
      const int column = static_cast<int>(i) % fineEast / 2;
      const int row = static_cast<int>(i) / fineEast / 2;
      widen(level.z[static_cast<std::size_t>(row) * static_cast<std::size_t>(east) + static_cast<std::size_t>(column)], fine.z[i].first,
            fine.z[i].second);
    }
  }
}

float TerrainModel::post(int level, int column, int row) const {
  const Level& l = levels_[static_cast<std::size_t>(level)];
  if (column < 0 || row < 0 || column >= l.columns || row >= l.rows) {
    return kUnknown;
  }
  return l.heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(l.columns) + static_cast<std::size_t>(column)];
}

bool TerrainModel::touchesUnknown(int level, int column, int row) const {
  const Level& l = levels_[static_cast<std::size_t>(level)];
  if (column < 0 || row < 0 || column >= l.columns || row >= l.rows) {
    return true;
  }
  const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(l.columns) + static_cast<std::size_t>(column);
  return l.unknown.empty() ? !(l.heights[at] < kUnknown) : l.unknown[at] != 0;
}

double TerrainModel::xOf(int level, int column) const {
  const terrain::ElevationGrid& grid = *terrain_->grid;
  const auto post = std::min<std::int64_t>(static_cast<std::int64_t>(column) << level, grid.columns() - 1);
  return grid.originX() + (static_cast<double>(post) + 0.5) * grid.cellSize();
}

double TerrainModel::yOf(int level, int row) const {
  const terrain::ElevationGrid& grid = *terrain_->grid;
  const auto post = std::min<std::int64_t>(static_cast<std::int64_t>(row) << level, grid.rows() - 1);
  return grid.originY() + (static_cast<double>(post) + 0.5) * grid.cellSize();
}

std::optional<double> TerrainModel::heightAt(geo::Point p) const {
  const terrain::ElevationGrid& grid = *terrain_->grid;
  const double u = (p.x - grid.originX()) / grid.cellSize() - 0.5;
  const double v = (p.y - grid.originY()) / grid.cellSize() - 0.5;
  if (!(u >= 0.0 && v >= 0.0 && u <= grid.columns() - 1 && v <= grid.rows() - 1)) {
    return std::nullopt;
  }
  const int i = std::min(static_cast<int>(u), grid.columns() - 2);
  const int j = std::min(static_cast<int>(v), grid.rows() - 2);
  const double s = u - i;
  const double t = v - j;
  const double sw = static_cast<double>(post(0, i, j));
  const double se = static_cast<double>(post(0, i + 1, j));
  const double nw = static_cast<double>(post(0, i, j + 1));
  const double ne = static_cast<double>(post(0, i + 1, j + 1));
  const double height = (1.0 - t) * ((1.0 - s) * sw + s * se) + t * ((1.0 - s) * nw + s * ne);
  return std::isfinite(height) ? std::optional(height) : std::nullopt;
}

double TerrainModel::surfaceAt(geo::Point p) const {
  if (const auto height = heightAt(p)) {
    return *height;
  }
  const terrain::ElevationGrid& grid = *terrain_->grid;
  const int column = grid.columnOf(p.x);
  const int row = grid.rowOf(p.y);
  // between a known and an unknown post there is no surface; the nearest post decides
  const float here = grid.upperInCell(column, row);
  return here < kUnknown ? static_cast<double>(here) : unknown_.lidOver(column, row).value_or(base_);
}

bool TerrainModel::hasLid(int level, int column, int row) const {
  if (column < 0 || row < 0 || column >= columns(level) || row >= rows(level)) {
    return false;
  }
  const int span = 1 << level;
  return unknown_.lidOver(std::min(column * span, columns(0) - 1), std::min(row * span, rows(0) - 1)).has_value();
}

double TerrainModel::floorAt(int level, int column, int row) const {
  if (column < 0 || row < 0 || column >= columns(level) || row >= rows(level)) {
    return base_;
  }
  const int span = 1 << level;
  return unknown_.lidOver(std::min(column * span, columns(0) - 1), std::min(row * span, rows(0) - 1)).value_or(base_);
}

std::optional<double> TerrainModel::meets(Vec3 eye, Vec3 direction, double exaggeration, double reach, double leastStep) const {
  const double top = std::max(highest(), base_) * exaggeration;
  double t = 0.0;
  if (eye.z > top) {
    if (direction.z >= 0.0) {
      return std::nullopt;
    }
    t = (top - eye.z) / direction.z;
  }
  double before = t;
  while (t <= reach) {
    const Vec3 p = eye + t * direction;
    if (direction.z > 0.0 && p.z > top) {
      return std::nullopt;
    }
    const double above = p.z - surfaceAt(p.ground()) * exaggeration;
    if (above <= 0.0) {
      for (int i = 0; i < 24; ++i) {
        const double middle = 0.5 * (before + t);
        const Vec3 m = eye + middle * direction;
        (m.z <= surfaceAt(m.ground()) * exaggeration ? t : before) = middle;
      }
      return t;
    }
    before = t;
    t += std::max(leastStep, 0.35 * above / exaggeration);
  }
  return std::nullopt;
}

std::optional<Vec3> TerrainModel::hit(Vec3 eye, Vec3 direction, double exaggeration, double reach) const {
  const auto t = meets(eye, direction, exaggeration, reach, 0.5 * terrain_->grid->cellSize());
  return t ? std::optional(eye + *t * direction) : std::nullopt;
}

bool TerrainModel::isClear(Vec3 from, Vec3 to, double exaggeration) const {
  const double away = length(to - from);
  const double margin = std::max(terrain_->grid->cellSize(), 0.01 * away);  // the target itself stands on the ground
  constexpr double kSamples = 400.0;                                        // enough for what hides a label
  const double step = std::max(0.5 * terrain_->grid->cellSize(), away / kSamples);
  return away <= margin || !meets(from, normalized(to - from), exaggeration, away - margin, step);
}

int TerrainModel::tileColumns(int level) const {
  return tilesFor(columns(level));
}

int TerrainModel::tileRows(int level) const {
  return tilesFor(rows(level));
}

Bounds TerrainModel::boundsOf(TileId tile) const {
  const auto east = static_cast<std::size_t>(tileColumns(tile.level));
  const std::size_t at = static_cast<std::size_t>(tile.row) * east + static_cast<std::size_t>(tile.column);
  const auto [low, high] = levels_[static_cast<std::size_t>(tile.level)].z[at];
  Bounds bounds;
  if (low <= high) {
    bounds.add({xOf(tile.level, tile.column * kTileQuads), yOf(tile.level, tile.row * kTileQuads), static_cast<double>(low)});
    bounds.add({xOf(tile.level, (tile.column + 1) * kTileQuads), yOf(tile.level, (tile.row + 1) * kTileQuads), static_cast<double>(high)});
  }
  return bounds;
}

}  // namespace vp::scene3d
