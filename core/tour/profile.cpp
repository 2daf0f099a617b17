#include "core/tour/profile.h"

#include <algorithm>
#include <cmath>

namespace vp::tour {

void raiseForPitch(std::span<const double> distance, std::span<double> altitude, PitchLimits limits) {
  for (std::size_t i = 1; i < altitude.size(); ++i) {
    altitude[i] = std::max(altitude[i], altitude[i - 1] - limits.descent * (distance[i] - distance[i - 1]));
  }
  for (std::size_t i = altitude.size(); i-- > 1;) {
    altitude[i - 1] = std::max(altitude[i - 1], altitude[i] - limits.climb * (distance[i] - distance[i - 1]));
  }
}

void raiseForPitchAround(std::span<const double> step, std::span<double> altitude, PitchLimits limits) {
  const std::size_t count = altitude.size();
  // Two rounds: the first carries every raise past the start once, and no raise goes round twice because it only falls.
  for (std::size_t k = 0; k < 2 * count; ++k) {
    const std::size_t i = k % count;
    const std::size_t next = (i + 1) % count;
    altitude[next] = std::max(altitude[next], altitude[i] - limits.descent * step[i]);
  }
  for (std::size_t k = 2 * count; k-- > 0;) {
    const std::size_t i = k % count;
    const std::size_t next = (i + 1) % count;
    altitude[i] = std::max(altitude[i], altitude[next] - limits.climb * step[i]);
  }
}

void raiseEndsForPitch(std::span<const double> distance, std::span<double> altitude, PitchLimits limits) {
  double first = altitude.front();
  double last = altitude.back();
  const double total = distance.back();
  for (std::size_t i = 1; i < altitude.size(); ++i) {
    first = std::max(first, altitude[i] - limits.climb * (distance[i] - distance.front()));
  }
  altitude.front() = first;
  for (std::size_t i = 0; i + 1 < altitude.size(); ++i) {
    last = std::max(last, altitude[i] - limits.descent * (total - distance[i]));
  }
  altitude.back() = last;
}

void concaveHull(std::span<const double> distance, std::span<const double> altitude, std::vector<std::size_t>& hull) {
  hull.clear();
  for (std::size_t i = 0; i < altitude.size(); ++i) {
    while (hull.size() >= 2) {
      const std::size_t a = hull[hull.size() - 2];
      const std::size_t b = hull.back();
      const double cross = (distance[b] - distance[a]) * (altitude[i] - altitude[a]) - (altitude[b] - altitude[a]) * (distance[i] - distance[a]);
      if (cross < 0.0) {
        break;  // b lies above the chord from a to i
      }
      hull.pop_back();
    }
    hull.push_back(i);
  }
}

void concaveMajorant(std::span<const double> distance, std::span<double> altitude, std::vector<std::size_t>& hull) {
  concaveHull(distance, altitude, hull);
  for (std::size_t h = 1; h < hull.size(); ++h) {
    const std::size_t a = hull[h - 1];
    const std::size_t b = hull[h];
    for (std::size_t i = a + 1; i < b; ++i) {
      const double part = (distance[i] - distance[a]) / (distance[b] - distance[a]);
      altitude[i] = std::max(altitude[i], altitude[a] + part * (altitude[b] - altitude[a]));
    }
  }
}

double lengthInSpace(std::span<const double> distance, std::span<const double> altitude) {
  double total = 0.0;
  for (std::size_t i = 1; i < altitude.size(); ++i) {
    total += std::hypot(distance[i] - distance[i - 1], altitude[i] - altitude[i - 1]);
  }
  return total;
}

}  // namespace vp::tour
