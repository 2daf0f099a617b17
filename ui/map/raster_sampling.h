#pragma once

#include "ui/map/pixel_window.h"

#include <cstddef>
#include <vector>

namespace vp::map {

/** A field of values at the centres of square cells, rows running north; a value that is not finite is unknown, and so is
 *  everything outside. A view: the values belong to somebody else. */
struct Raster {
  double originX = 0.0;  ///< m, south-west corner
  double originY = 0.0;
  double cell = 1.0;  ///< m
  int columns = 0;
  int rows = 0;
  const float* values = nullptr;  ///< row-major from south-west
};

enum class Kernel {
  Bilinear,  ///< between the four nearest centres: never outside their values
  Smooth,    ///< windowed Gaussian of 0.6 to 1.3 cells: slopes without facets and without the steps that a conservative warp leaves
};

/** Values at the pixels of a window, row by row from the north. */
struct Samples {
  int width = 0;
  int height = 0;
  std::vector<float> value;     ///< where coverage is 0 any number
  std::vector<float> coverage;  ///< bilinear weight of known cells, 0..1; empty: 1 everywhere

  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
  [[nodiscard]] bool isKnown(std::size_t at) const { return coverage.empty() || coverage[at] > kLeastCoverage; }
  /// Below this a pixel counts as unknown: high enough that a single unknown cell is drawn no smaller than it is.
  static constexpr float kLeastCoverage = 0.75F;
};

/** Samples a raster at the centres of a window's pixels; unknown cells have no weight.
 *  The same pixel of the frame gets the same bits from whatever window it is in.  @threads pure  @cost some 10 ns a pixel */
Samples sample(const Raster& raster, const PixelWindow& window, Kernel kernel);

}  // namespace vp::map
