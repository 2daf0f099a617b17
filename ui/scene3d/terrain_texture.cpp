#include "ui/scene3d/terrain_tile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::scene3d {
namespace {

constexpr int kSize = TileTexture::kSide;
constexpr int kFinerLevels = 3;  ///< between posts of a tile and about one post for each texel
static_assert(TerrainModel::kTileQuads << kFinerLevels == kSize);

/// Heights around a tile on the level that gives about one post for each texel; unknown posts filled for shading only.
struct HeightPatch {
  int level = 0;
  int west = 0;  ///< post of the first column
  int south = 0;
  int columns = 0;
  int rows = 0;
  std::vector<float> heights;
  std::vector<std::uint8_t> unknown;  ///< empty if all is known

  [[nodiscard]] std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i);
  }
};

/// Gives unknown posts the mean of their known neighbours, from the edge of the known ground outwards.
void fillUnknown(HeightPatch& patch, float fallback) {
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<float> before = patch.heights;
    for (int j = 0; j < patch.rows; ++j) {
      for (int i = 0; i < patch.columns; ++i) {
        if (std::isfinite(before[patch.at(i, j)])) {
          continue;
        }
        float sum = 0.0F;
        int count = 0;
        for (int dj = std::max(0, j - 1); dj <= std::min(patch.rows - 1, j + 1); ++dj) {
          for (int di = std::max(0, i - 1); di <= std::min(patch.columns - 1, i + 1); ++di) {
            const float value = before[patch.at(di, dj)];
            sum += std::isfinite(value) ? value : 0.0F;
            count += std::isfinite(value) ? 1 : 0;
          }
        }
        patch.heights[patch.at(i, j)] = count > 0 ? sum / static_cast<float>(count) : before[patch.at(i, j)];
      }
    }
  }
  std::replace_if(
      patch.heights.begin(), patch.heights.end(), [](float h) { return !std::isfinite(h); }, fallback);
}

/// Whether ground at a post is hatched: unknown inside the terrain, down to single cells that the post stands for. At the edge of
/// the known ground the surface itself ends where it should.
bool isUnknownInside(const TerrainModel& model, int level, int column, int row) {
  if (!model.touchesUnknown(level, column, row)) {
    return false;
  }
  for (int j = row - 1; j <= row + 1; ++j) {
    for (int i = column - 1; i <= column + 1; ++i) {
      if (!std::isfinite(model.post(level, i, j)) && !model.hasLid(level, i, j)) {
        return false;
      }
    }
  }
  return true;
}

HeightPatch heightsAround(const TerrainModel& model, TileId tile) {
  HeightPatch patch;
  patch.level = std::max(0, tile.level - kFinerLevels);
  const int posts = TerrainModel::kTileQuads << (tile.level - patch.level);
  patch.west = tile.column * posts - 2;
  patch.south = tile.row * posts - 2;
  patch.columns = posts + 5;
  patch.rows = posts + 5;
  patch.heights.reserve(static_cast<std::size_t>(patch.columns) * static_cast<std::size_t>(patch.rows));
  const int lastColumn = model.columns(patch.level) - 1;
  const int lastRow = model.rows(patch.level) - 1;
  bool hasUnknown = false;
  for (int j = 0; j < patch.rows; ++j) {
    for (int i = 0; i < patch.columns; ++i) {
      // beyond the last post its value goes on: nothing there is drawn
      const int column = std::clamp(patch.west + i, 0, lastColumn);
      const int row = std::clamp(patch.south + j, 0, lastRow);
      patch.heights.push_back(model.post(patch.level, column, row));
      hasUnknown = hasUnknown || model.touchesUnknown(patch.level, column, row);
    }
  }
  if (hasUnknown) {
    for (int j = 0; j < patch.rows; ++j) {
      for (int i = 0; i < patch.columns; ++i) {
        const bool isHatched =
            isUnknownInside(model, patch.level, std::clamp(patch.west + i, 0, lastColumn), std::clamp(patch.south + j, 0, lastRow));
        patch.unknown.push_back(isHatched ? 1 : 0);
      }
    }
    fillUnknown(patch, static_cast<float>(model.lowest()));
  }
  return patch;
}

/// Where texel k falls between the posts of a patch, with the weights of a uniform cubic B-spline and of its slope.
struct SplineSample {
  int first = 0;
  std::array<float, 4> value{};
  std::array<float, 4> slope{};
};

SplineSample splineAt(int texel, int posts) {
  const double at = static_cast<double>(texel) * posts / (kSize - 1);
  const int cell = std::min(static_cast<int>(at), posts - 1);
  const auto t = static_cast<float>(at - cell);
  const float s = 1.0F - t;
  SplineSample sample;
  sample.first = cell + 1;  // the patch begins two posts before the tile
  sample.value = {s * s * s / 6.0F, (3.0F * t * t * t - 6.0F * t * t + 4.0F) / 6.0F, (3.0F * s * s * s - 6.0F * s * s + 4.0F) / 6.0F,
                  t * t * t / 6.0F};
  sample.slope = {-0.5F * s * s, 1.5F * t * t - 2.0F * t, -1.5F * s * s + 2.0F * s, 0.5F * t * t};
  return sample;
}

void addMipmaps(std::vector<std::uint8_t>& rgb) {
  std::size_t from = 0;
  for (int size = kSize; size > 1; size /= 2) {
    const int half = size / 2;
    const std::size_t to = rgb.size();
    rgb.resize(to + static_cast<std::size_t>(half) * static_cast<std::size_t>(half) * 3);
    const std::size_t line = static_cast<std::size_t>(size) * 3;
    for (int j = 0; j < half; ++j) {
      for (int i = 0; i < half * 3; ++i) {
        const std::size_t at = from + static_cast<std::size_t>(2 * j) * line + static_cast<std::size_t>(i / 3 * 6 + i % 3);
        const int sum = rgb[at] + rgb[at + 3] + rgb[at + line] + rgb[at + line + 3];
        rgb[to + static_cast<std::size_t>(j) * static_cast<std::size_t>(half) * 3 + static_cast<std::size_t>(i)] =
            static_cast<std::uint8_t>((sum + 2) / 4);
      }
    }
    from = to;
  }
}

TerrainPalette::Rgb bytesOf(const QColor& color) {
  return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()), static_cast<std::uint8_t>(color.blue())};
}

}  // namespace

double contourInterval(double lowest, double highest, const style::Units& units) {
  const double range = highest - lowest;
  const bool isMetric = units.system() == style::UnitSystem::Metric;
  const double shown = range > 1200.0 ? (isMetric ? 100.0 : 500.0) : range > 300.0 ? (isMetric ? 50.0 : 200.0) : (isMetric ? 10.0 : 50.0);
  return units.heightToSi(shown);
}

TerrainPalette::TerrainPalette(style::Theme theme, double lowest, double highest, double contourInterval)
    : lowest_(lowest),
      perMetre_(static_cast<double>(kSteps - 1) / std::max(highest - lowest, 1.0)),
      interval_(contourInterval),
      isDark_(theme == style::Theme::Dark) {
  for (std::size_t i = 0; i < kSteps; ++i) {
    const QColor color = style::ChartColors::tint(theme, static_cast<double>(i) / static_cast<double>(kSteps - 1));
    tint_[i] = {static_cast<float>(color.red()), static_cast<float>(color.green()), static_cast<float>(color.blue())};
  }
  hatch_ = bytesOf(style::ChartColors::of(theme).unknown);
  hatchBase_ = bytesOf(style::ChartColors::of(theme).unknownBase);
}

double TerrainPalette::contourAt(double height, double slope, double texel) const {
  constexpr double kHalfWidth = 0.75;     // texels
  constexpr double kClosest = 5.0;        // texels between lines, none nearer than that
  constexpr double kLeastSlope = 0.015;   // flatter ground would be all line
  const double perTexel = slope * texel;  // m
  if (interval_ <= 0.0) {
    return 0.0;
  }
  const double apart = interval_ / std::max(perTexel, 1e-6);
  if (slope < kLeastSlope || apart < kClosest) {
    return 0.0;
  }
  const double away = std::abs(height - std::round(height / interval_) * interval_) / perTexel;
  const double line = std::clamp(kHalfWidth + 0.5 - away, 0.0, 1.0);
  return line * std::clamp((apart - kClosest) / kClosest, 0.0, 1.0);
}

TerrainPalette::Rgb TerrainPalette::colorOf(double height, double east, double north, double texel) const {
  const double at = std::clamp((height - lowest_) * perMetre_, 0.0, static_cast<double>(kSteps - 1));
  const std::array<float, 3>& tint = tint_[static_cast<std::size_t>(at)];
  // Light from the north-west at 45 degrees and a third as much from the west-south-west, so that no slope is flat grey.
  const double norm = 1.0 / std::sqrt(east * east + north * north + 1.0);
  const double main = (0.5 * east - 0.5 * north + 0.7071) * norm;
  const double second = (0.68 * east + 0.25 * north + 0.69) * norm;
  const double light = std::clamp(0.75 * main + 0.25 * second, 0.0, 1.0) - 0.703;  // 0 on flat ground
  // Lit slopes gain warm light, slopes in shadow turn bluish: the manner of Swiss relief maps.
  const double shadow = light < 0.0 ? std::min(1.0, -light / 0.703) : 0.0;
  const double lit = light > 0.0 ? light / 0.297 : 0.0;
  const double deep = isDark_ ? 0.62 : 0.74;
  const double bright = isDark_ ? 0.55 : 0.20;
  const std::array<double, 3> factor{1.0 - deep * shadow + bright * lit, 1.0 - (deep - 0.04) * shadow + 0.9 * bright * lit,
                                     1.0 - (deep - 0.16) * shadow + 0.5 * bright * lit};
  const double contour = 1.0 - (isDark_ ? -0.30 : 0.22) * contourAt(height, std::hypot(east, north), texel);
  Rgb rgb{};
  for (std::size_t c = 0; c < 3; ++c) {
    rgb[c] = static_cast<std::uint8_t>(std::clamp(static_cast<double>(tint[c]) * factor[c] * contour * (isDark_ ? 1.2 : 1.0) + 0.5, 0.0, 255.0));
  }
  return rgb;
}

TileTexture buildTileTexture(const TerrainModel& model, const TerrainPalette& palette, TileId tile) {
  const HeightPatch patch = heightsAround(model, tile);
  const int posts = patch.columns - 5;
  const double spacing = model.terrain().grid->cellSize() * std::exp2(patch.level);
  // Means flatten slopes: distant relief is shaded as if it were as steep as it is near by.
  const auto perMetre = static_cast<float>((1.0 + 0.22 * patch.level) / spacing);

  const double texel = model.terrain().grid->cellSize() * std::exp2(tile.level) * TerrainModel::kTileQuads / (kSize - 1);
  std::array<SplineSample, kSize> samples;
  for (int k = 0; k < kSize; ++k) {
    samples[static_cast<std::size_t>(k)] = splineAt(k, posts);
  }
  // along the rows first: values and slopes for each row of posts
  const std::size_t width = kSize;
  std::vector<float> value(width * static_cast<std::size_t>(patch.rows));
  std::vector<float> slope(value.size());
  for (int j = 0; j < patch.rows; ++j) {
    for (std::size_t i = 0; i < width; ++i) {
      const float* h = &patch.heights[patch.at(samples[i].first, j)];
      const std::size_t at = static_cast<std::size_t>(j) * width + i;
      for (std::size_t k = 0; k < 4; ++k) {
        value[at] += samples[i].value[k] * h[k];
        slope[at] += samples[i].slope[k] * h[k];
      }
    }
  }
  TileTexture texture;
  texture.rgb.reserve(width * width * 4);
  texture.rgb.resize(width * width * 3);
  for (std::size_t j = 0; j < width; ++j) {
    const SplineSample& sample = samples[j];
    for (std::size_t i = 0; i < width; ++i) {
      float height = 0.0F;
      float east = 0.0F;
      float north = 0.0F;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t at = (static_cast<std::size_t>(sample.first) + k) * width + i;
        height += sample.value[k] * value[at];
        east += sample.value[k] * slope[at];
        north += sample.slope[k] * value[at];
      }
      TerrainPalette::Rgb rgb =
          palette.colorOf(static_cast<double>(height), static_cast<double>(east * perMetre), static_cast<double>(north * perMetre), texel);
      const int nearestColumn = samples[i].first + 1 + (samples[i].value[2] > samples[i].value[1] ? 1 : 0);
      const int nearestRow = sample.first + 1 + (sample.value[2] > sample.value[1] ? 1 : 0);
      if (!patch.unknown.empty() && patch.unknown[patch.at(nearestColumn, nearestRow)] != 0) {
        const int x = tile.column * (kSize - 1) + static_cast<int>(i);
        const int y = tile.row * (kSize - 1) + static_cast<int>(j);
        rgb = TerrainPalette::isHatchLine(x, y) ? palette.hatch() : palette.hatchBase();
      }
      std::copy(rgb.begin(), rgb.end(), texture.rgb.begin() + static_cast<std::ptrdiff_t>((j * width + i) * 3));
    }
  }
  addMipmaps(texture.rgb);
  return texture;
}

}  // namespace vp::scene3d
