#include "core/landing/spatial_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::landing {

SpatialIndex::SpatialIndex(const geo::Box& extent, double bucket)
    : originX_(extent.minX),
      originY_(extent.minY),
      bucket_(bucket),
      columns_(1 + static_cast<int>((extent.maxX - extent.minX) / bucket)),
      rows_(1 + static_cast<int>((extent.maxY - extent.minY) / bucket)),
      buckets_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

int SpatialIndex::columnOf(double x) const {
  return static_cast<int>(std::clamp(std::floor((x - originX_) / bucket_), 0.0, columns_ - 1.0));
}

int SpatialIndex::rowOf(double y) const {
  return static_cast<int>(std::clamp(std::floor((y - originY_) / bucket_), 0.0, rows_ - 1.0));
}

const std::vector<SpatialIndex::Entry>& SpatialIndex::bucketAt(int column, int row) const {
  return buckets_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
}

void SpatialIndex::insert(geo::Point p, int id) {
  // points outside the extent go to the border buckets, which searches clamp to as well
  buckets_[static_cast<std::size_t>(rowOf(p.y)) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(columnOf(p.x))].push_back({p, id});
}

void SpatialIndex::within(geo::Point p, double radius, std::vector<int>& found) const {
  const double square = radius * radius;
  for (int row = rowOf(p.y - radius); row <= rowOf(p.y + radius); ++row) {
    for (int column = columnOf(p.x - radius); column <= columnOf(p.x + radius); ++column) {
      for (const Entry& entry : bucketAt(column, row)) {
        const double dx = entry.point.x - p.x;
        const double dy = entry.point.y - p.y;
        if (dx * dx + dy * dy <= square) {
          found.push_back(entry.id);
        }
      }
    }
  }
}

int SpatialIndex::nearest(geo::Point p) const {
  int best = -1;
  double bestSquare = std::numeric_limits<double>::infinity();
  const int column = columnOf(p.x);
  const int row = rowOf(p.y);
  for (int ring = 0; ring < std::max(columns_, rows_); ++ring) {
    // once something is found, rings whose nearest edge is farther cannot improve it
    const double edge = (ring - 1) * bucket_;
    if (best >= 0 && ring > 1 && edge * edge > bestSquare) {
      break;
    }
    for (int r = std::max(0, row - ring); r <= std::min(rows_ - 1, row + ring); ++r) {
      const bool border = r == row - ring || r == row + ring;
      const int step = border || ring == 0 ? 1 : 2 * ring;
      for (int c = column - ring; c <= column + ring; c += step) {
        if (c < 0 || c >= columns_) {
          continue;
        }
        for (const Entry& entry : bucketAt(c, r)) {
          const double dx = entry.point.x - p.x;
          const double dy = entry.point.y - p.y;
          const double square = dx * dx + dy * dy;
          if (square < bestSquare) {
            bestSquare = square;
            best = entry.id;
          }
        }
      }
    }
  }
  return best;
}

}  // namespace vp::landing
