#include "ui/map/weather_marks.h"

#include "ui/map/hit_test.h"
#include "ui/style/short_name.h"

#include <QLineF>

#include <algorithm>

namespace vp::map {
namespace {

constexpr double kSmallest = 44.0;  // px, cells smaller than this have no label
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
  const QFont font = chartFont(TextSize::Small);
  for (std::size_t i = 0; i < scene_.situation.weather->size(); ++i) {
    const document::ShownWeather& shown = (*scene_.situation.weather)[i];
    const QRectF box = QRectF(camera_.toScreen({shown.box.minX, shown.box.maxY}), camera_.toScreen({shown.box.maxX, shown.box.minY}));
    const QRectF seen = box.intersected(camera_.screen());
    if (std::min(seen.width(), seen.height()) < kSmallest) {
      continue;
    }
    const QStringList text{style::shortName(document::weatherTitle(shown.cell, i)), document::weatherAltitudes(shown.cell, scene_.units),
                           document::weatherSuccessText(shown.cell, scene_.units)};
    const QSizeF size = textSize(text, font);
    const QPointF middle = seen.center() - QPointF(0.5 * size.width(), 0.5 * size.height());
    for (const double share : {0.0, -0.25, 0.25}) {
      const QPointF at = middle + QPointF(0.0, share * seen.height());
      if (labels.placeAt(QRectF(at, size))) {
        drawHaloText(painter, at, text, font, scene_.colors().weather, scene_.colors().textHalo);
        break;
      }
    }
  }
}

}  // namespace vp::map
