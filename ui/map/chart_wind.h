#pragma once

#include "core/air/wind_layer.h"
#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

#include <QPainter>
#include <QStringList>

#include <optional>
#include <vector>

namespace vp::map {

/** The wind that the guarantee holds for, on the map: an arrow that flies with it over a sector as wide as its directions, and its
 *  numbers. Of several layers the lowest and the highest are shown. */
class ChartWind {
public:
  ChartWind(const std::vector<air::WindLayer>& winds, const style::Units& units, const style::ChartColors& colors);

  /** Nothing in still air. [px] */
  [[nodiscard]] std::optional<QSizeF> size() const;
  void draw(QPainter& painter, const QRectF& box) const;

private:
  struct Row {
    air::WindSector wind;
    QStringList lines;
  };
  void drawArrow(QPainter& painter, QPointF centre, const air::WindSector& wind) const;

  const style::ChartColors& colors_;
  std::vector<Row> rows_;
};

}  // namespace vp::map
