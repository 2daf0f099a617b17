#include "core/air/wind_shear.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vp::air {
namespace {

/// Largest distance between a wind of one sector and one of another [m/s]. At a given angle between them its square is convex in both speeds, so it
/// is greatest at ends of their ranges, and it grows with the angle.
double mostBetween(const WindSector& a, const WindSector& b) {
  const double angle = std::min(Angle::kPi, std::abs(wrapPi(a.towards() - b.towards())) + a.spread() + b.spread());
  double most = 0.0;
  for (const double speedA : {a.leastSpeed, a.mostSpeed}) {
    for (const double speedB : {b.leastSpeed, b.mostSpeed}) {
      const double along = speedA - speedB * std::cos(angle);
      most = std::max(most, std::hypot(along, speedB * std::sin(angle)));
    }
  }
  return most;
}

}  // namespace

double mostShear(std::vector<WindLayer> layers) {
  std::stable_sort(layers.begin(), layers.end(), [](const WindLayer& a, const WindLayer& b) { return a.altitude.metres() < b.altitude.metres(); });
  double most = 0.0;
  for (std::size_t i = 0; i + 1 < layers.size(); ++i) {
    if (const double change = mostBetween(layers[i].wind, layers[i + 1].wind); change > 0.0) {
      most = std::max(most, change / (layers[i + 1].altitude.metres() - layers[i].altitude.metres()));
    }
  }
  return most;
}

}  // namespace vp::air
