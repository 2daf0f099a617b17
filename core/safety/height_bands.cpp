#include "core/safety/height_bands.h"

#include "core/safety/limits.h"
#include "core/safety/wind_shear.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vp::safety {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<double> edgesOf(const PlanConditions& conditions) {
  std::vector<double> edges;
  const std::vector<air::WindLayer>& layers = conditions.winds;
  const bool isAnyWind = std::any_of(layers.begin(), layers.end(), [](const air::WindLayer& layer) { return !layer.wind.isCalm(); });
  for (std::size_t i = 0; isAnyWind && layers.size() > 1 && i < layers.size(); ++i) {
    edges.push_back(layers[i].altitude.metres());
  }
  if (conditions.air) {
    for (double count = std::floor(conditions.lowest / kBandHeight) + 1.0; count * kBandHeight < conditions.highest; count += 1.0) {
      edges.push_back(count * kBandHeight);
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// The layers whose winds count between two altitudes with no layer between them.
std::vector<air::WindLayer> windsBetween(const std::vector<air::WindLayer>& layers, double bottom, double top) {
  if (layers.size() < 2) {
    return layers;
  }
  std::vector<air::WindLayer> winds;
  const auto above = std::find_if(layers.begin(), layers.end(), [&](const air::WindLayer& layer) { return layer.altitude.metres() >= top; });
  if (above != layers.begin() && (above - 1)->altitude.metres() <= bottom) {
    winds.push_back(*(above - 1));
  }
  if (above != layers.end()) {
    winds.push_back(*above);
  }
  return winds;
}

}  // namespace

HeightBands heightBands(const PlanConditions& conditions, const aircraft::AircraftProfile& profile) {
  HeightBands all{edgesOf(conditions), {}};
  if (all.edges.empty()) {
    all.bands = {{conditions.winds, 0.0, conditions.glide}};
    return all;
  }
  for (std::size_t i = 0; i <= all.edges.size(); ++i) {
    const double bottom = i == 0 ? -kInfinity : all.edges[i - 1];
    const double top = i == all.edges.size() ? kInfinity : all.edges[i];
    std::vector<air::WindLayer> winds = windsBetween(conditions.winds, bottom, top);
    const double shear = winds.size() == 2 ? shearBetween(winds[0], winds[1]) : 0.0;
    all.bands.push_back({std::move(winds), shear, glideAirspeeds(conditions, profile, bottom, top)});
  }
  return all;
}

}  // namespace vp::safety
