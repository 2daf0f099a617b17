#pragma once

#include "core/air/wind_layer.h"
#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

#include <QFont>
#include <QPainter>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace vp::style {

/** The wind that the guarantee holds for, beside a map or a scene: an arrow that flies with it over a sector as wide as its directions,
 *  and its numbers. Of several layers the lowest and the highest are shown. */
class WindFigure {
public:
  /** @param colors  outlive this */
  WindFigure(const std::vector<air::WindLayer>& winds, const Units& units, const ChartColors& colors, QFont font);

  /** Nothing in still air. [px] */
  [[nodiscard]] std::optional<QSizeF> size() const;
  /** On a background that is there already.
   *  @param north  where north is on the picture: 0 up, counter-clockwise [rad] */
  void draw(QPainter& painter, const QRectF& box, double north = 0.0) const;

private:
  struct Row {
    air::WindSector wind;
    QStringList lines;
  };
  void drawArrow(QPainter& painter, QPointF centre, const air::WindSector& wind, double north) const;

  const ChartColors& colors_;
  QFont font_;
  std::vector<Row> rows_;
};

}  // namespace vp::style
