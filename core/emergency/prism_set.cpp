#include "core/emergency/prism_set.h"

#include "core/base/quantity.h"

#include <cmath>

namespace vp::emergency {
namespace {

constexpr double kHalfRootThree = 0.86602540378443865;

/// 16 bits each of layer and course, 16 bits each of column and row: searches are less than 65,536 buckets wide.
std::uint64_t keyOf(std::int64_t layer, std::int64_t course, std::int64_t column, std::int64_t row) {
  constexpr std::uint64_t kMask = 0xFFFF;
  return (static_cast<std::uint64_t>(layer) & kMask) << 48U | (static_cast<std::uint64_t>(course) & kMask) << 32U |
         (static_cast<std::uint64_t>(column) & kMask) << 16U | (static_cast<std::uint64_t>(row) & kMask);
}

std::int64_t cellOf(double value, double size) {
  return static_cast<std::int64_t>(std::floor(value / size));
}

}  // namespace

bool isInHexagon(geo::Point place, geo::Point centre, double circumradius) {
  const double x = std::abs(place.x - centre.x);
  const double y = std::abs(place.y - centre.y);
  // the upright sides, and the slanting ones: x / (2 * apothem) + y / (circumradius) reaches 1 there
  return x <= kHalfRootThree * circumradius && 0.5 * x / kHalfRootThree + y <= circumradius;
}

PrismSet::PrismSet(double layer, double courseStep, double widest) : layer_(layer), courseStep_(courseStep), bucket_(widest) {}

bool PrismSet::add(const geo::Pose& pose, double altitude, double circumradius, double risk) {
  const std::int64_t layer = cellOf(altitude, layer_);
  const auto courses = static_cast<std::int64_t>(std::lround(2.0 * Angle::kPi / courseStep_));
  const std::int64_t course = static_cast<std::int64_t>(std::lround(wrapTwoPi(pose.heading) / courseStep_)) % courses;
  const std::int64_t column = cellOf(pose.x, bucket_);
  const std::int64_t row = cellOf(pose.y, bucket_);
  for (std::int64_t i = column - 1; i <= column + 1; ++i) {
    for (std::int64_t j = row - 1; j <= row + 1; ++j) {
      const auto found = first_.find(keyOf(layer, course, i, j));
      for (std::int32_t k = found == first_.end() ? -1 : found->second; k >= 0; k = places_[static_cast<std::size_t>(k)].next) {
        const Place& known = places_[static_cast<std::size_t>(k)];
        if (known.risk <= risk && isInHexagon(pose.point(), known.centre, known.circumradius)) {
          return false;
        }
      }
    }
  }
  const auto [entry, isNew] = first_.try_emplace(keyOf(layer, course, column, row), -1);
  places_.push_back({pose.point(), circumradius, risk, entry->second});
  entry->second = static_cast<std::int32_t>(places_.size() - 1);
  return true;
}

}  // namespace vp::emergency
