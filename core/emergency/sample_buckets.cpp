#include "core/emergency/sample_buckets.h"

#include "core/base/quantity.h"

#include <algorithm>
#include <cmath>

namespace vp::emergency {
namespace {

/// Buckets for each point at most: a space that is far wider than the reach gets larger buckets.
constexpr double kMostBuckets = 8.0;

}  // namespace

SampleBuckets::SampleBuckets(const std::vector<Point3>& points, double reach) : reach_(reach), bucket_(reach) {
  if (points.empty()) {
    first_.assign(2, 0);
    return;
  }
  low_ = points.front();
  Point3 high = low_;
  for (const Point3& p : points) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const auto along = [this](double length) { return std::floor(length / bucket_) + 1.0; };
  while (along(high.x - low_.x) * along(high.y - low_.y) * along(high.z - low_.z) > kMostBuckets * static_cast<double>(points.size()) + 64.0) {
    bucket_ *= 1.5;
  }
  count_ = {static_cast<int>((high.x - low_.x) / bucket_) + 1, static_cast<int>((high.y - low_.y) / bucket_) + 1,
            static_cast<int>((high.z - low_.z) / bucket_) + 1};
  first_.assign(numberOf(0, 0, count_[2]) + 1, 0);
  for (const Point3& p : points) {
    const auto [x, y, z] = bucketOf(p);
    ++first_[numberOf(x, y, z) + 1];
  }
  for (std::size_t i = 1; i < first_.size(); ++i) {
    first_[i] += first_[i - 1];
  }
  points_.resize(points.size());
  ids_.resize(points.size());
  place_.resize(points.size());
  std::vector<std::size_t> next = first_;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [x, y, z] = bucketOf(points[i]);
    const std::size_t at = next[numberOf(x, y, z)]++;
    points_[at] = points[i];
    ids_[at] = static_cast<int>(i);
    place_[i] = at;
  }
}

std::array<int, 3> SampleBuckets::bucketOf(const Point3& p) const {
  return {static_cast<int>((p.x - low_.x) / bucket_), static_cast<int>((p.y - low_.y) / bucket_), static_cast<int>((p.z - low_.z) / bucket_)};
}

std::size_t SampleBuckets::numberOf(int x, int y, int z) const {
  return (static_cast<std::size_t>(z) * static_cast<std::size_t>(count_[1]) + static_cast<std::size_t>(y)) * static_cast<std::size_t>(count_[0]) +
         static_cast<std::size_t>(x);
}

void SampleBuckets::near(int point, std::vector<int>& found) const {
  const std::size_t own = place_[static_cast<std::size_t>(point)];
  const Point3 p = points_[own];
  const auto [x, y, z] = bucketOf(p);
  const double reach = reach_ * reach_;
  for (int k = std::max(0, z - 1); k <= std::min(z + 1, count_[2] - 1); ++k) {
    for (int j = std::max(0, y - 1); j <= std::min(y + 1, count_[1] - 1); ++j) {
      const std::size_t last = first_[numberOf(std::min(x + 1, count_[0] - 1), j, k) + 1];
      for (std::size_t at = first_[numberOf(std::max(0, x - 1), j, k)]; at < last; ++at) {
        const double dx = points_[at].x - p.x;
        const double dy = points_[at].y - p.y;
        const double dz = points_[at].z - p.z;
        if (dx * dx + dy * dy + dz * dz <= reach && at != own) {
          found.push_back(ids_[at]);
        }
      }
    }
  }
}

double fmtRadius(int dimensions, double measure, std::size_t samples) {
  constexpr double kMore = 1.1;
  const double d = dimensions;
  const double unitBall = dimensions == 2 ? Angle::kPi : 4.0 / 3.0 * Angle::kPi;
  const double n = static_cast<double>(std::max<std::size_t>(samples, 2));
  return kMore * 2.0 * std::pow(1.0 / d * measure / unitBall * std::log(n) / n, 1.0 / d);
}

}  // namespace vp::emergency
