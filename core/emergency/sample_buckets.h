#pragma once

#include "core/emergency/linear_octree.h"

#include <cstddef>
#include <vector>

namespace vp::emergency {

/** Points in cubic buckets of one edge length, for all that lie within that length of one of them. Built once; the order of what is found depends
 *  on the points alone.  @threads const members are pure */
class SampleBuckets {
public:
  /** @param reach  > 0: that near() is asked for */
  SampleBuckets(const std::vector<Point3>& points, double reach);

  /** Appends the other points at most `reach` from a point. @cost O(points in 27 buckets) */
  void near(int point, std::vector<int>& found) const;

private:
  [[nodiscard]] std::array<int, 3> bucketOf(const Point3& p) const;
  [[nodiscard]] std::size_t numberOf(int x, int y, int z) const;

  double reach_;
  double bucket_ = 1.0;
  Point3 low_;
  std::array<int, 3> count_{1, 1, 1};
  std::vector<Point3> points_;      ///< by bucket
  std::vector<int> ids_;            ///< of points_
  std::vector<std::size_t> first_;  ///< in points_, of each bucket and behind the last
  std::vector<std::size_t> place_;  ///< in points_, by id
};

/** Radius within which FMT* connects n samples: 1.1 times the least for which its cost converges to the optimum.
 *  @param dimensions  2 or 3   @param measure  area or volume of the sampled space
 *  @source Janson, Schmerling, Clark, Pavone 2015, Fast Marching Tree, IJRR 34, Theorem 4.1 with eta = 0.1 */
double fmtRadius(int dimensions, double measure, std::size_t samples);

}  // namespace vp::emergency
