#include "ui/map/weather_marks.h"

#include "ui/map/hit_test.h"
#include "ui/style/short_name.h"

#include <QLineF>

#include <algorithm>
#include <array>

namespace vp::map {
namespace {

constexpr double kSmallest = 44.0;  // px, cells smaller than this have no label
constexpr double kPlate = 4.0;      // px between a label and the edge of its plate
constexpr double kHandle = 7.0;     // px, side of the square on a corner

}  // namespace

void drawHandle(QPainter& painter, QPointF at, const style::ChartColors& colors) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QPen(colors.weather, 1.5));
  painter.setBrush(colors.panel);
  painter.drawRect(QRectF(at.x() - 0.5 * kHandle, at.y() - 0.5 * kHandle, kHandle, kHandle));
  painter.restore();
}

int shownWeatherAt(const MapScene& scene, geo::Point place) {
  const bool isShown = scene.options.weather && scene.situation.weather != nullptr;
  return isShown ? document::weatherAt(*scene.situation.weather, place) : -1;
}

const document::ShownWeather* WeatherMarks::selected() const {
  const auto& cells = scene_.situation.weather;
  const int cell = scene_.selectedWeather;
  const bool isShown = scene_.options.weather && cells != nullptr && cell >= 0 && cell < static_cast<int>(cells->size());
  return isShown ? &(*cells)[static_cast<std::size_t>(cell)] : nullptr;
}

std::optional<WeatherCorner> WeatherMarks::cornerAt(QPointF at) const {
  std::optional<WeatherCorner> found;
  double least = kReach;
  if (const document::ShownWeather* cell = selected()) {
    for (std::size_t i = 0; i < cell->outline.size(); ++i) {
      const double away = QLineF(at, camera_.toScreen(cell->outline[i])).length();
      if (away <= least) {
        least = away;
        found = WeatherCorner{scene_.selectedWeather, i};
      }
    }
  }
  return found;
}

void WeatherMarks::drawHandles(QPainter& painter) const {
  if (const document::ShownWeather* cell = selected()) {
    for (const geo::Point& corner : cell->outline) {
      drawHandle(painter, camera_.toScreen(corner), scene_.colors());
    }
  }
}

void WeatherMarks::drawLabels(QPainter& painter, LabelPlacer& labels) const {
  if (!scene_.options.weather || scene_.situation.weather == nullptr) {
    return;
  }
  for (std::size_t i = 0; i < scene_.situation.weather->size(); ++i) {
    const document::ShownWeather& shown = (*scene_.situation.weather)[i];
    const QRectF box = QRectF(camera_.toScreen({shown.box.minX, shown.box.maxY}), camera_.toScreen({shown.box.maxX, shown.box.minY}));
    const QRectF seen = box.intersected(camera_.screen());
    if (std::min(seen.width(), seen.height()) < kSmallest) {
      continue;
    }
    const QString title = style::shortName(document::weatherTitle(shown.cell, i));
    const QString success = document::weatherSuccessText(shown.cell, scene_.units);
    if (!drawLabel(painter, labels, seen, {title, document::weatherAltitudes(shown.cell, scene_.units), success})) {
      drawLabel(painter, labels, seen, {QStringLiteral("%1, %2").arg(title, success)});  // shorter, where there is little room
    }
  }
}

/// On a plate, as letters cannot be read on hatching: in the middle, else beside it, else under or over the cell.
bool WeatherMarks::drawLabel(QPainter& painter, LabelPlacer& labels, const QRectF& seen, const QStringList& text) const {
  static constexpr std::array kPlaces{QPointF(0.0, 0.0),   QPointF(0.0, -0.25),   QPointF(0.0, 0.25),   QPointF(-0.25, 0.0),
                                      QPointF(0.25, 0.0),  QPointF(-0.25, -0.25), QPointF(0.25, -0.25), QPointF(-0.25, 0.25),
                                      QPointF(0.25, 0.25), QPointF(0.0, 0.6),     QPointF(0.0, -0.6)};
  const QFont font = chartFont(TextSize::Small);
  const QSizeF size = textSize(text, font);
  for (const QPointF& share : kPlaces) {
    QRectF box(QPointF(), size + QSizeF(2.0 * kPlate, kPlate));
    box.moveCenter(seen.center() + QPointF(share.x() * seen.width(), share.y() * seen.height()));
    if (labels.placeAt(box)) {
      const style::ChartColors& colors = scene_.colors();
      painter.save();
      painter.setRenderHint(QPainter::Antialiasing);
      QColor plate = colors.panel;
      plate.setAlphaF(0.88F);
      painter.setPen(QPen(colors.weather, 1.0));
      painter.setBrush(plate);
      painter.drawRoundedRect(box, 3.0, 3.0);
      painter.restore();
      drawHaloText(painter, box.topLeft() + QPointF(kPlate, 0.5 * kPlate), text, font, colors.text, Qt::transparent);
      return true;
    }
  }
  return false;
}

}  // namespace vp::map
