#pragma once

#include "ui/map/chart_layout.h"
#include "ui/map/chart_legend.h"
#include "ui/style/wind_figure.h"

namespace vp::map {

/** A round length for a scale bar: 1, 2 or 5 times a power of ten of the shown unit, at most `pixels` long. [m] */
double scaleBarLength(double metresPerPixel, double pixels, const style::Units& units);

/** What stands still on the glass while the ground moves under it: scale bar, message, wind, legend, north arrow (layOutChart says
 *  where, and what is left out where there is no room). */
class ChartFrame {
public:
  /** @param safeAltitude  the field that is shown; null: none   @param message  what to do next; may be empty */
  ChartFrame(const MapScene& scene, const MapCamera& camera, const SafeAltitudeLayer* safeAltitude, const QString& message = {});

  void draw(QPainter& painter) const;
  /** Places that draw() covers, for labels to keep off. */
  [[nodiscard]] std::vector<QRectF> covered() const { return layout_.boxes(); }
  [[nodiscard]] const ChartLayout& layout() const { return layout_; }

private:
  [[nodiscard]] QSizeF scaleSize() const;
  [[nodiscard]] double scalePixels() const;
  void drawScale(QPainter& painter) const;
  void drawNorth(QPainter& painter, const QRectF& box) const;

  const MapScene& scene_;
  const MapCamera& camera_;
  QString message_;
  double scale_;  ///< length of the scale bar [m]
  ChartLegend legend_;
  style::WindFigure wind_;
  ChartLayout layout_;
};

}  // namespace vp::map
