#include "ui/profile/plot_scale.h"

#include <algorithm>
#include <cmath>

namespace vp::profile {

double PlotScale::yOf(double altitude) const {
  const double y = area_.top() + (window_.high - altitude) / window_.height() * area_.height();
  return std::clamp(y, area_.top() - 2.0 * area_.height(), area_.bottom() + 2.0 * area_.height());
}

std::vector<double> niceTicks(double low, double high, int most) {
  std::vector<double> ticks;
  if (!(high > low) || most < 1) {
    return ticks;
  }
  const double raw = (high - low) / most;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  double step = 10.0 * power;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw) {
      step = factor * power;
      break;
    }
  }
  const double noise = 1e-9 * step;
  for (double k = std::ceil((low - noise) / step); k * step <= high + noise; k += 1.0) {
    ticks.push_back(k * step);
  }
  return ticks;
}

int tickDecimals(const std::vector<double>& ticks) {
  if (ticks.size() < 2) {
    return 0;
  }
  return std::clamp(static_cast<int>(std::ceil(-std::log10(ticks[1] - ticks[0]) - 1e-9)), 0, 6);
}

}  // namespace vp::profile
