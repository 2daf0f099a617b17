#include "ui/map/raster_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vp::map {
namespace {

constexpr int kTaps = 6;
constexpr float kFullWeight = 0.99999F;  // weights of the taps sum to 1 within 1e-6
constexpr double kSupport = 9.0;         // cells squared: taps reach three cells to each side
constexpr double kNarrowest = 0.6;       // cells, standard deviation of the smooth kernel where a cell is a pixel
constexpr double kWidest = 1.3;          // cells, the same where a cell is many pixels

/// Neighbouring cells along one axis and their weights.
struct Taps {
  int first = 0;
  std::array<float, kTaps> weight{};
};

/// Cells that a kernel looks at around any coordinate of one axis of a raster.
class Axis {
public:
  Axis(const Raster& raster, double metresPerPixel, Kernel kernel) : kernel_(kernel) {
    const double pixelsPerCell = raster.cell / metresPerPixel;
    deviation_ = std::clamp(kNarrowest + (kWidest - kNarrowest) * (pixelsPerCell - 1.0), kNarrowest, kWidest);
  }

  /// @param count  cells along the axis: further out than a few beyond them everything is unknown alike
  [[nodiscard]] Taps at(double coordinate, int count) const {
    const double base = std::floor(coordinate);
    const double t = coordinate - base;
    Taps taps;
    taps.first = static_cast<int>(std::clamp(base, -4.0, count + 2.0)) - 2;
    if (kernel_ == Kernel::Bilinear) {
      taps.weight[2] = static_cast<float>(1.0 - t);
      taps.weight[3] = static_cast<float>(t);
      return taps;
    }
    std::array<double, kTaps> weight{};
    double sum = 0.0;
    for (int k = 0; k < kTaps; ++k) {
      const double away = (k - 2 - t) / deviation_;
      // the window brings the weight to zero where the taps end, so that no cell comes in with a step
      const double window = std::max(0.0, 1.0 - (k - 2 - t) * (k - 2 - t) / kSupport);
      weight[static_cast<std::size_t>(k)] = std::exp(-0.5 * away * away) * window * window;
      sum += weight[static_cast<std::size_t>(k)];
    }
    for (std::size_t k = 0; k < kTaps; ++k) {
      taps.weight[k] = static_cast<float>(weight[k] / sum);
    }
    return taps;
  }

private:
  Kernel kernel_;
  double deviation_ = kNarrowest;
};

/// A block of cells copied out of a raster: unknown ones as value 0 with weight 0.
struct Block {
  int column = 0;
  int row = 0;
  int columns = 0;
  int rows = 0;
  std::vector<float> value;
  std::vector<float> known;  ///< 1 or 0; empty: all known
};

Block copyBlock(const Raster& raster, const std::vector<Taps>& across, const std::vector<Taps>& down) {
  Block block;
  block.column = across.front().first;
  block.columns = across.back().first + kTaps - block.column;
  block.row = down.back().first;  // rows of a window run south
  block.rows = down.front().first + kTaps - block.row;
  const auto width = static_cast<std::size_t>(block.columns);
  block.value.assign(width * static_cast<std::size_t>(block.rows), 0.0F);
  std::vector<float> known(block.value.size(), 0.0F);
  bool allKnown = true;
  for (int r = 0; r < block.rows; ++r) {
    const int row = block.row + r;
    const bool inside = row >= 0 && row < raster.rows;
    const float* from = inside ? raster.values + static_cast<std::ptrdiff_t>(row) * raster.columns : nullptr;
    float* value = block.value.data() + static_cast<std::size_t>(r) * width;
    float* weight = known.data() + static_cast<std::size_t>(r) * width;
    for (int c = 0; c < block.columns; ++c) {
      const int column = block.column + c;
      const bool isKnown = inside && column >= 0 && column < raster.columns && std::isfinite(from[column]);
      value[c] = isKnown ? from[column] : 0.0F;
      weight[c] = isKnown ? 1.0F : 0.0F;
      allKnown = allKnown && isKnown;
    }
  }
  if (!allKnown) {
    block.known = std::move(known);
  }
  return block;
}

/// One channel of a block interpolated along x, then along y.
std::vector<float> interpolate(const Block& block, const std::vector<float>& channel, const std::vector<Taps>& across,
                               const std::vector<Taps>& down) {
  const std::size_t width = across.size();
  std::vector<float> rows(width * static_cast<std::size_t>(block.rows));
  for (int r = 0; r < block.rows; ++r) {
    const float* from = channel.data() + static_cast<std::ptrdiff_t>(r) * block.columns;
    float* to = rows.data() + static_cast<std::size_t>(r) * width;
    for (std::size_t i = 0; i < width; ++i) {
      const Taps& taps = across[i];
      const float* cells = from + (taps.first - block.column);
      const std::array<float, kTaps>& w = taps.weight;
      to[i] = cells[0] * w[0] + cells[1] * w[1] + cells[2] * w[2] + cells[3] * w[3] + cells[4] * w[4] + cells[5] * w[5];
    }
  }
  std::vector<float> result(width * down.size());
  for (std::size_t j = 0; j < down.size(); ++j) {
    const Taps& taps = down[j];
    const std::array<float, kTaps>& w = taps.weight;
    const float* a = rows.data() + static_cast<std::size_t>(taps.first - block.row) * width;
    const float* b = a + width;
    const float* c = b + width;
    const float* d = c + width;
    const float* e = d + width;
    const float* f = e + width;
    float* to = result.data() + j * width;
    for (std::size_t i = 0; i < width; ++i) {
      to[i] = a[i] * w[0] + b[i] * w[1] + c[i] * w[2] + d[i] * w[3] + e[i] * w[4] + f[i] * w[5];
    }
  }
  return result;
}

std::pair<std::vector<Taps>, std::vector<Taps>> tapsOf(const Raster& raster, const PixelWindow& window, Kernel kernel) {
  const Axis axis(raster, window.metresPerPixel, kernel);
  std::pair<std::vector<Taps>, std::vector<Taps>> taps;
  for (int i = 0; i < window.width; ++i) {
    taps.first.push_back(axis.at((window.xOf(i) - raster.originX) / raster.cell - 0.5, raster.columns));
  }
  for (int j = 0; j < window.height; ++j) {
    taps.second.push_back(axis.at((window.yOf(j) - raster.originY) / raster.cell - 0.5, raster.rows));
  }
  return taps;
}

bool isOutside(const Raster& raster, const PixelWindow& window) {
  const geo::Box box = window.box().grown(4.0 * raster.cell);
  return raster.columns <= 0 || raster.rows <= 0 || box.maxX < raster.originX || box.maxY < raster.originY ||
         box.minX > raster.originX + raster.columns * raster.cell || box.minY > raster.originY + raster.rows * raster.cell;
}

}  // namespace

Samples sample(const Raster& raster, const PixelWindow& window, Kernel kernel) {
  Samples samples{window.width, window.height, {}, {}};
  const std::size_t count = static_cast<std::size_t>(window.width) * static_cast<std::size_t>(window.height);
  if (count == 0 || isOutside(raster, window)) {
    samples.value.assign(count, 0.0F);
    samples.coverage.assign(count, 0.0F);
    return samples;
  }
  const auto [across, down] = tapsOf(raster, window, kernel);
  const Block block = copyBlock(raster, across, down);
  samples.value = interpolate(block, block.value, across, down);
  if (!block.known.empty()) {
    const std::vector<float> weights = interpolate(block, block.known, across, down);
    for (std::size_t i = 0; i < count; ++i) {
      // next to full weight the sum stands as it is: the same bits as in a window without unknown cells
      samples.value[i] = weights[i] > kFullWeight ? samples.value[i] : weights[i] > 0.0F ? samples.value[i] / weights[i] : 0.0F;
    }
    const auto [nearAcross, nearDown] = tapsOf(raster, window, Kernel::Bilinear);
    samples.coverage = interpolate(block, block.known, nearAcross, nearDown);
  }
  return samples;
}

}  // namespace vp::map
