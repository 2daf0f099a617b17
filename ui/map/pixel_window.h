#pragma once

#include "core/geo/pose.h"

#include <cstdint>

namespace vp::map {

/** A rectangle of a raster that covers the whole frame at one scale. Column c spans x from c to c + 1 times
 *  metresPerPixel; row r spans y from -r down to -(r + 1) times metresPerPixel, so rows run south as on screen. Every picture
 *  computed for the same scale fits its neighbours without a seam. Pixels here are device pixels. */
struct PixelWindow {
  std::int64_t left = 0;
  std::int64_t top = 0;
  int width = 0;
  int height = 0;
  double metresPerPixel = 1.0;

  [[nodiscard]] double xOf(int column) const { return (static_cast<double>(left + column) + 0.5) * metresPerPixel; }  ///< of a pixel's centre
  [[nodiscard]] double yOf(int row) const { return -(static_cast<double>(top + row) + 0.5) * metresPerPixel; }
  [[nodiscard]] geo::Box box() const {
    return {static_cast<double>(left) * metresPerPixel, -static_cast<double>(top + height) * metresPerPixel,
            static_cast<double>(left + width) * metresPerPixel, -static_cast<double>(top) * metresPerPixel};
  }
  [[nodiscard]] PixelWindow grown(int by) const { return {left - by, top - by, width + 2 * by, height + 2 * by, metresPerPixel}; }
};

}  // namespace vp::map
