#pragma once

#include "core/air/wind_layer.h"
#include "ui/scene3d/scene_data.h"
#include "ui/scene3d/scene_options.h"

#include <QRectF>
#include <QSizeF>

#include <optional>
#include <vector>

class QPainter;

namespace vp::scene3d {

/** What stands on the picture beside the scene: north, wind, the colours of altitudes, exaggeration. The same paint for the
 *  window's widgets and for pictures. Sizes in px at 96 dpi. */

/// Side of the compass.
inline constexpr double kCompassSide = 64.0;

/** A rose that shows where north lies. @param azimuth  direction of view, mathematical [rad] */
void paintCompass(QPainter& painter, const QRectF& rect, double azimuth, style::Theme theme);

/** What the legend explains. */
struct LegendContent {
  std::optional<AltitudeRange> altitudes;  ///< of the colour scale
  double contourInterval = 0.0;            ///< m, 0: no contour lines
  bool operator==(const LegendContent&) const = default;
};

/** The wind that the guarantee holds for, as seen in that direction of view; no size in still air. */
QSizeF windSize(const std::vector<air::WindLayer>& winds, const SceneStyle& style);
void paintWind(QPainter& painter, const QRectF& rect, const std::vector<air::WindLayer>& winds, double azimuth, const SceneStyle& style);

/** The colour scale with altitudes, and the height between contour lines, in the operator's unit. */
QSizeF legendSize(const LegendContent& content, const SceneStyle& style);
void paintLegend(QPainter& painter, const QRectF& rect, const LegendContent& content, const SceneStyle& style);

/** "Heights shown 2 x", empty at 1. */
QString exaggerationText(double factor);
QSizeF noteSize(const QString& text);
void paintNote(QPainter& painter, const QRectF& rect, const QString& text, style::Theme theme);

/** What stands beside a scene. */
struct OverlayContent {
  LegendContent legend;
  std::vector<air::WindLayer> winds;  ///< none: still air
  double exaggeration = 1.0;
};

/** Where they stand on a picture of a size: compass, wind, legend, note; empty rectangles for those not shown. */
struct OverlayLayout {
  QRectF compass;
  QRectF wind;
  QRectF legend;
  QRectF note;
  [[nodiscard]] std::vector<QRectF> shown() const;
};
OverlayLayout layOutOverlay(QSizeF size, const OverlayContent& content, const SceneStyle& style);

/** All of it on a finished picture. */
void paintOverlay(QPainter& painter, QSizeF size, double azimuth, const OverlayContent& content, const SceneStyle& style);

}  // namespace vp::scene3d
