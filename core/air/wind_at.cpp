#include "core/air/wind_at.h"

#include <algorithm>
#include <cmath>

namespace vp::air {
namespace {

Wind middleOf(const WindSector& sector) {
  if (sector.spread_deg >= 180.0) {
    return {};  // from anywhere
  }
  const double speed = 0.5 * (sector.leastSpeed + sector.mostSpeed);
  return {speed * std::cos(sector.towards()), speed * std::sin(sector.towards())};
}

}  // namespace

Wind middleWind(const std::vector<WindLayer>& layers, geo::HeightMsl altitude) {
  if (layers.empty()) {
    return {};
  }
  const auto above = std::find_if(layers.begin(), layers.end(), [&](const WindLayer& layer) { return layer.altitude > altitude; });
  if (above == layers.begin() || above == layers.end()) {
    return middleOf(above == layers.end() ? layers.back().wind : layers.front().wind);
  }
  const auto below = above - 1;
  const Wind low = middleOf(below->wind);
  const Wind high = middleOf(above->wind);
  const double part = (altitude.metres() - below->altitude.metres()) / (above->altitude.metres() - below->altitude.metres());
  return {low.east + part * (high.east - low.east), low.north + part * (high.north - low.north)};
}

double groundSpeed(double airspeed, Wind wind, double course) {
  const double along = wind.east * std::cos(course) + wind.north * std::sin(course);
  const double across = wind.east * std::sin(course) - wind.north * std::cos(course);
  const double ahead = airspeed * airspeed - across * across;
  return ahead > 0.0 ? std::sqrt(ahead) + along : 0.0;
}

}  // namespace vp::air
