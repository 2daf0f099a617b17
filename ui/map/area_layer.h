#pragma once

#include "core/geo/pose.h"
#include "ui/document/weather_view.h"
#include "ui/map/pixel_window.h"
#include "ui/style/chart_colors.h"

#include <QColor>
#include <QImage>
#include <QPainter>

#include <array>
#include <memory>
#include <vector>

namespace vp::risk {
class Population;
}

namespace vp::map {

/** People per square kilometre as a choropleth: five classes, each about five times as dense as the one before, in an order of lightness.
 *  @threads const members are pure */
class PopulationLayer {
public:
  /// Lower limits of the classes [people per km^2]; below the first nothing is drawn.
  static constexpr std::array kClasses{10.0, 50.0, 200.0, 1000.0, 4000.0};
  static constexpr float kOpacity = 0.48F;

  /** @param population  not null */
  explicit PopulationLayer(std::shared_ptr<const risk::Population> population);

  /** Class of a density [people per m^2]; -1: too few to be drawn. */
  [[nodiscard]] static int classOf(double density);
  /** Opaque; drawn with kOpacity. Light theme: the denser, the darker; dark theme: the denser, the lighter. */
  [[nodiscard]] static QColor colorOf(int densityClass, style::Theme theme);

  void paint(QPainter& painter, const PixelWindow& window, style::Theme theme) const;

private:
  std::shared_ptr<const risk::Population> population_;
  std::vector<geo::Box> boxes_;  ///< of the polygons
};

/** A brush that hatches weather: the denser, the less likely one comes through. Its lines run on from tile to tile where the brush origin is that of
 *  the frame's raster.
 *  @param success  per nautical mile   @param devicePixelRatio  pixels of the picture per pixel of the user */
QBrush weatherHatch(double success, const QColor& color, double devicePixelRatio);
/** Period of the lines of that brush [px of the picture]. */
int weatherHatchPeriod(double success, double devicePixelRatio);

/** Weather cells with veil, hatching and outline; those without any risk have the outline alone. */
void paintWeather(QPainter& painter, const PixelWindow& window, double devicePixelRatio, const std::vector<document::ShownWeather>& cells,
                  style::Theme theme);

}  // namespace vp::map
