#include "core/aircraft/runway_wind.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::aircraft {
namespace {

/// @param course  of landing, rad from East, counter-clockwise
RunwayWind worstOf(const air::WindSector& sector, double course) {
  const double off = std::abs(wrapPi(sector.towards() - course));
  const double nearest = std::max(0.0, off - sector.spread());
  const double farthest = std::min(Angle::kPi, off + sector.spread());
  const double cosine = std::cos(nearest);
  const bool isBeside = nearest <= 0.5 * Angle::kPi && farthest >= 0.5 * Angle::kPi;
  const double sine = isBeside ? 1.0 : std::max(std::sin(nearest), std::sin(farthest));
  return {(cosine > 0.0 ? sector.mostSpeed : sector.leastSpeed) * cosine, sector.mostSpeed * sine};
}

}  // namespace

RunwayWind runwayWind(const std::vector<air::WindLayer>& winds, geo::HeightMsl elevation, Angle course) {
  if (winds.empty()) {
    return {};
  }
  const double heading = 0.5 * Angle::kPi - course.radians();
  const auto above = std::find_if(winds.begin(), winds.end(), [&](const air::WindLayer& layer) { return layer.altitude > elevation; });
  const auto below = above == winds.begin() ? above : above - 1;
  RunwayWind worst{-std::numeric_limits<double>::infinity(), 0.0};
  for (auto layer = below; layer != winds.end() && layer <= above; ++layer) {  // both parts are convex in the wind
    const RunwayWind one = worstOf(layer->wind, heading);
    worst = {std::max(worst.tailwind, one.tailwind), std::max(worst.crosswind, one.crosswind)};
  }
  return worst;
}

std::string againstLanding(const AircraftProfile& profile, const RunwayWind& wind) {
  const auto over = [](const char* what, double value, Speed limit) {
    return fmt::format("{} of up to {:.0f} kt, the aircraft's limit is {:.0f} kt", what, std::ceil(value / kMpsPerKnot - 1e-6),
                       limit.si() / kMpsPerKnot);
  };
  if (profile.maxTailwind && wind.tailwind > profile.maxTailwind->si()) {
    return over("tailwind", wind.tailwind, *profile.maxTailwind);
  }
  if (profile.maxCrosswind && wind.crosswind > profile.maxCrosswind->si()) {
    return over("crosswind", wind.crosswind, *profile.maxCrosswind);
  }
  return {};
}

}  // namespace vp::aircraft
