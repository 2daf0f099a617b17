#include "core/emergency/weather/altitude_intervals.h"

#include <algorithm>
#include <utility>

namespace vp::emergency {
namespace {

constexpr double kSame = 1e-6;  // m of altitude: intervals that overlap by less touch only

/// Altitudes between two neighbouring floors or tops, and what a metre there costs.
struct Band {
  double low = 0.0;
  double high = 0.0;
  double rate = 0.0;
};

std::vector<Band> bandsOf(const AltitudeSlice& slice) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  std::vector<double> levels{slice.lowest};
  for (const SliceLayer& layer : slice.layers) {
    for (const double level : {layer.floor, layer.top}) {
      if (level > slice.lowest && level < kInfinite) {
        levels.push_back(level);
      }
    }
  }
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  std::vector<Band> bands;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    Band band{levels[i], i + 1 < levels.size() ? levels[i + 1] : kInfinite, 0.0};
    for (const SliceLayer& layer : slice.layers) {
      band.rate += layer.floor <= band.low && layer.top >= band.high ? layer.rate : 0.0;
    }
    bands.push_back(band);
  }
  return bands;
}

/// Adds the parts of a candidate that nothing cheaper covers. @param covered  disjoint
void addUncovered(const AltitudeInterval& candidate, std::vector<AltitudeInterval>& covered) {
  std::vector<std::pair<double, double>> parts{{candidate.low, candidate.high}};
  for (const AltitudeInterval& other : covered) {
    std::vector<std::pair<double, double>> left;
    for (const auto& [low, high] : parts) {
      if (high <= other.low - kSame || low >= other.high + kSame) {
        left.emplace_back(low, high);
        continue;
      }
      if (low < other.low - kSame) {
        left.emplace_back(low, other.low);
      }
      if (high > other.high + kSame) {
        left.emplace_back(other.high, high);
      }
    }
    parts = std::move(left);
  }
  for (const auto& [low, high] : parts) {
    covered.push_back(candidate);
    covered.back().low = low;
    covered.back().high = high;
  }
}

}  // namespace

std::vector<AltitudeInterval> throughSlice(const std::vector<AltitudeInterval>& from, const AltitudeSlice& slice) {
  const std::vector<Band> bands = bandsOf(slice);
  std::vector<AltitudeInterval> candidates;
  for (std::size_t i = 0; i < from.size(); ++i) {
    for (std::size_t entry = 0; entry < bands.size(); ++entry) {
      const double low = std::max(from[i].low, bands[entry].low);
      const double high = std::min(from[i].high, bands[entry].high);
      if (low > high) {
        continue;
      }
      double rate = 0.0;
      for (std::size_t exit = entry + 1; exit-- > 0;) {
        rate = std::max(rate, bands[exit].rate);
        const double outLow = std::max(low - slice.most * slice.length, bands[exit].low);
        const double outHigh = std::min(high - slice.least * slice.length, bands[exit].high);
        if (outLow > outHigh + kSame) {
          continue;
        }
        candidates.push_back({std::min(outLow, outHigh), outHigh, from[i].cost + rate * slice.length, static_cast<int>(i), low, high});
      }
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const AltitudeInterval& a, const AltitudeInterval& b) { return a.cost < b.cost; });
  std::vector<AltitudeInterval> covered;
  for (const AltitudeInterval& candidate : candidates) {
    addUncovered(candidate, covered);
  }
  std::sort(covered.begin(), covered.end(), [](const AltitudeInterval& a, const AltitudeInterval& b) { return a.low < b.low; });
  return covered;
}

std::optional<std::vector<double>> cheapestAltitudes(double start, const std::vector<AltitudeSlice>& slices, double end) {
  std::vector<std::vector<AltitudeInterval>> steps{{{start, start, 0.0, -1, 0.0, 0.0}}};
  for (const AltitudeSlice& slice : slices) {
    steps.push_back(throughSlice(steps.back(), slice));
    if (steps.back().empty()) {
      return std::nullopt;
    }
  }
  const AltitudeInterval* best = nullptr;
  for (const AltitudeInterval& last : steps.back()) {  // ascending: of two that cost the same the higher
    if (last.high >= end && (best == nullptr || last.cost <= best->cost)) {
      best = &last;
    }
  }
  if (best == nullptr) {
    return std::nullopt;
  }
  std::vector<double> altitudes(slices.size());
  double altitude = best->high;
  for (std::size_t i = slices.size(); i-- > 0;) {
    altitudes[i] = altitude;
    // as high as the slice may be entered
    altitude = std::min(best->parentHigh, altitude + slices[i].most * slices[i].length);
    altitude = std::max(altitude, altitudes[i] + slices[i].least * slices[i].length);
    best = &steps[i][static_cast<std::size_t>(best->parent)];
  }
  return altitudes;
}

}  // namespace vp::emergency
