#pragma once

#include "ui/map/height_levels.h"
#include "ui/map/tile_painter.h"
#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

#include <array>
#include <memory>

namespace vp::map {

/** How the ground is drawn. */
struct ReliefStyle {
  style::Theme theme = style::Theme::Light;
  style::UnitSystem units = style::UnitSystem::Aviation;  ///< contours stand at round heights of these
  bool contours = true;
  double lowest = 0.0;  ///< m MSL, range of the hypsometric tint
  double highest = 0.0;
  bool operator==(const ReliefStyle&) const = default;
};

/** Contour interval in metres for a scale: a round height in the shown units, wide enough apart on slopes of one in two. */
double contourInterval(double metresPerPixel, style::UnitSystem units);

/** Brightness of a slope, 0..1, lit from the north-west at 45 degrees. Level ground has kLevelShade; slopes turned away from the
 *  light go on darkening, so that shadows keep their relief.
 *  @param east, north  rise per metre towards east and north   @source B. K. P. Horn, Hill shading and the reflectance map, 1981;
 *  shifted here so that cosines from -1/2 to 1 fill the range */
inline constexpr float kLevelShade = 0.80473785F;
float hillShade(float east, float north);

/** Hill-shaded, tinted ground with thin contours; unknown ground hatched. Opaque. */
class ReliefPainter : public TilePainter {
public:
  ReliefPainter(std::shared_ptr<const HeightLevels> heights, const ReliefStyle& style);

  [[nodiscard]] QImage paint(const PixelWindow& window, double devicePixelRatio) const override;
  [[nodiscard]] geo::Box extent() const override { return {}; }
  void abandon() const override { heights_->abandon(); }

private:
  static constexpr int kTints = 256;
  static constexpr int kShades = 256;

  [[nodiscard]] QRgb ground(float height, float shade) const;

  std::shared_ptr<const HeightLevels> heights_;
  ReliefStyle style_;
  std::vector<QRgb> palette_;  ///< [tint * kShades + shade]
};

}  // namespace vp::map
