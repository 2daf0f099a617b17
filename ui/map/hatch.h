#pragma once

#include "ui/map/pixel_window.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace vp::map {

/** Share of ink (0..1) of slanted lines at a pixel of the frame's raster: the same in whatever tile it lies.
 *  @param spacing, width  device pixels across the lines   @param rising  lines run up to the right, else down */
inline float hatchInk(std::int64_t column, std::int64_t row, double spacing, double width, bool rising) {
  const double across = static_cast<double>(rising ? column + row : column - row) * 0.70710678118654752;
  const double phase = across - std::floor(across / spacing) * spacing;
  const double away = std::min(phase, spacing - phase);
  return static_cast<float>(std::clamp(0.5 * width + 0.5 - away, 0.0, 1.0));
}

/** Share of ink of a line of some width at `away` pixels from its middle, smoothed over a pixel. */
inline float lineInk(float away, float width) {
  return std::clamp(0.5F * width + 0.5F - std::abs(away), 0.0F, 1.0F);
}

}  // namespace vp::map
