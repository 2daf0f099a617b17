#include "ui/map/relief_painter.h"

#include "core/base/quantity.h"
#include "ui/map/hatch.h"

#include <algorithm>
#include <cmath>

namespace vp::map {
namespace {

using style::ChartColors;
using style::Theme;

constexpr float kSunHeight = 0.70710678F;  // sine and cosine of 45 degrees
constexpr float kDarkest = -0.5F;          // cosine to the light that is drawn darkest
constexpr float kFlat = kLevelShade;
constexpr double kContourPixels = 16.0;  // least distance of contours on a slope of one in two, device-independent
constexpr int kContoursPerIndex = 5;     // every fifth is drawn stronger, as on printed charts
constexpr float kCrowded = 5.0F;         // px between contours below which they fade out
constexpr float kHatchStrength = 0.6F;
constexpr double kHatchSpacing = 10.0;     // px
constexpr double kHatchWidth = 1.1;        // px
constexpr double kFullReliefScale = 25.0;  // m per pixel up to which slopes are shaded as they are
constexpr double kReliefExponent = 0.30;   // how fast slopes are exaggerated beyond: means flatten with scale
constexpr double kMostExaggerated = 4.0;

QRgb mix(QRgb a, QRgb b, float t) {
  const auto part = [t](int from, int to) { return static_cast<int>(std::lround(static_cast<float>(from) + t * static_cast<float>(to - from))); };
  return qRgb(part(qRed(a), qRed(b)), part(qGreen(a), qGreen(b)), part(qBlue(a), qBlue(b)));
}

/// Shadow and light that a theme mixes into the tint, and how strongly.
struct Light {
  QRgb shadow;
  QRgb light;
  float deepest;
  float brightest;
};

Light lightOf(Theme theme) {
  return theme == Theme::Light ? Light{qRgb(0x37, 0x3C, 0x55), qRgb(0xFF, 0xFD, 0xF4), 0.74F, 0.62F}
                               : Light{qRgb(0x06, 0x09, 0x12), qRgb(0xC8, 0xC6, 0xBE), 0.80F, 0.40F};
}

QRgb contourInk(Theme theme) {
  return theme == Theme::Light ? qRgb(0x6E, 0x4F, 0x2E) : qRgb(0xCB, 0xB4, 0x94);
}

double exaggeration(double metresPerPixel) {
  return std::clamp(std::pow(metresPerPixel / kFullReliefScale, kReliefExponent), 1.0, kMostExaggerated);
}

}  // namespace

double contourInterval(double metresPerPixel, style::UnitSystem units) {
  const double unit = units == style::UnitSystem::Aviation ? kMetresPerFoot : 1.0;
  const double least = metresPerPixel * kContourPixels * 0.5;
  for (const double round : {5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0}) {
    if (round * unit >= least) {
      return round * unit;
    }
  }
  return 5000.0 * unit;
}

float hillShade(float east, float north) {
  // light from (-1/2, 1/2, 1/sqrt 2); the ground's normal is (-east, -north, 1)
  const float lit = (0.5F * east - 0.5F * north + kSunHeight) / std::sqrt(1.0F + east * east + north * north);
  return std::clamp((lit - kDarkest) / (1.0F - kDarkest), 0.0F, 1.0F);
}

ReliefPainter::ReliefPainter(std::shared_ptr<const HeightLevels> heights, const ReliefStyle& style) : heights_(std::move(heights)), style_(style) {
  const Light light = lightOf(style.theme);
  palette_.reserve(static_cast<std::size_t>(kTints) * kShades);
  for (int tint = 0; tint < kTints; ++tint) {
    const QRgb base = ChartColors::tint(style.theme, static_cast<double>(tint) / (kTints - 1)).rgb();
    for (int shade = 0; shade < kShades; ++shade) {
      const float lit = static_cast<float>(shade) / (kShades - 1);
      palette_.push_back(lit < kFlat ? mix(base, light.shadow, light.deepest * std::pow((kFlat - lit) / kFlat, 0.8F))
                                     : mix(base, light.light, light.brightest * std::pow((lit - kFlat) / (1.0F - kFlat), 1.2F)));
    }
  }
}

QRgb ReliefPainter::ground(float height, float shade) const {
  const double range = std::max(style_.highest - style_.lowest, 1.0);
  const double fraction = std::clamp((static_cast<double>(height) - style_.lowest) / range, 0.0, 1.0);
  const auto tint = std::min(static_cast<std::size_t>(fraction * kTints), static_cast<std::size_t>(kTints) - 1);
  const auto lit = std::min(static_cast<std::size_t>(shade * kShades), static_cast<std::size_t>(kShades) - 1);
  return palette_[tint * kShades + lit];
}

QImage ReliefPainter::paint(const PixelWindow& window, double devicePixelRatio) const {
  const Samples heights = sample(heights_->levelFor(window.metresPerPixel), window.grown(1), Kernel::Smooth);
  const ChartColors& colors = ChartColors::of(style_.theme);
  const QRgb unknown = colors.unknownBase.rgb();
  const QRgb hatch = mix(unknown, colors.unknown.rgb(), kHatchStrength);
  const QRgb ink = contourInk(style_.theme);
  const auto scale = static_cast<float>(0.5 / window.metresPerPixel);
  const auto relief = static_cast<float>(exaggeration(window.metresPerPixel * devicePixelRatio));
  const auto interval = static_cast<float>(contourInterval(window.metresPerPixel * devicePixelRatio, style_.units));
  const auto pixel = static_cast<float>(devicePixelRatio);
  const auto metresPerPixel = static_cast<float>(window.metresPerPixel);
  QImage image(window.width, window.height, QImage::Format_RGB32);
  for (int row = 0; row < window.height; ++row) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
    const std::size_t above = heights.index(1, row);
    const std::size_t here = heights.index(1, row + 1);
    const std::size_t below = heights.index(1, row + 2);
    for (int column = 0; column < window.width; ++column) {
      const auto c = static_cast<std::size_t>(column);
      if (!heights.isKnown(here + c)) {
        line[column] = mix(unknown, hatch,
                           hatchInk(window.left + column, window.top + row, kHatchSpacing * devicePixelRatio, kHatchWidth * devicePixelRatio, true));
        continue;
      }
      const float height = heights.value[here + c];
      const float east = (heights.value[here + c + 1] - heights.value[here + c - 1]) * scale;
      const float north = (heights.value[above + c] - heights.value[below + c]) * scale;
      line[column] = ground(height, hillShade(east * relief, north * relief));
      if (style_.contours) {
        const float steep = std::max(std::sqrt(east * east + north * north) * metresPerPixel, 1e-4F * interval);
        const float order = std::round(height / interval);
        const float apart = interval / steep / pixel;
        if (apart > kCrowded && order > 0.0F) {
          const bool isIndex = static_cast<int>(order) % kContoursPerIndex == 0;
          const float strength = (isIndex ? 0.50F : 0.26F) * std::min(1.0F, (apart - kCrowded) / kCrowded);
          line[column] = mix(line[column], ink, strength * lineInk((height - order * interval) / steep, (isIndex ? 1.1F : 0.7F) * pixel));
        }
      }
    }
  }
  return image;
}

}  // namespace vp::map
