#pragma once

#include "core/geo/pose.h"

#include <vector>

namespace vp::landing {

/** Points in square buckets: insertion O(1), neighbours within a radius in the order of insertion per bucket, so that
 *  results do not depend on addresses. Grows with the points' extent. */
class SpatialIndex {
public:
  SpatialIndex() = default;
  /** @param extent  where most points will lie  @param bucket  side of a bucket [m] */
  SpatialIndex(const geo::Box& extent, double bucket);

  void insert(geo::Point p, int id);
  /** Appends the ids of all points within `radius` of p. */
  void within(geo::Point p, double radius, std::vector<int>& found) const;
  /** Id of the nearest point, -1 if there is none. */
  [[nodiscard]] int nearest(geo::Point p) const;

private:
  struct Entry {
    geo::Point point;
    int id = -1;
  };
  [[nodiscard]] int columnOf(double x) const;
  [[nodiscard]] int rowOf(double y) const;
  [[nodiscard]] const std::vector<Entry>& bucketAt(int column, int row) const;

  double originX_ = 0.0;
  double originY_ = 0.0;
  double bucket_ = 1.0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::vector<Entry>> buckets_;
};

}  // namespace vp::landing
