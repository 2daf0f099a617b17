#pragma once

#include "ui/map/chart_text.h"
#include "ui/map/map_camera.h"
#include "ui/map/map_scene.h"

#include <QPainter>
#include <QPointF>
#include <QRectF>
#include <QStringList>

#include <optional>

namespace vp::map {

/** A corner of a weather cell. */
struct WeatherCorner {
  int cell = -1;  ///< index into Situation::weather
  std::size_t corner = 0;
};

/** What stands on weather cells beside their hatching: name, altitudes and probability, and the corners of the selected one to be dragged. */
class WeatherMarks {
public:
  WeatherMarks(const MapScene& scene, const MapCamera& camera) : scene_(scene), camera_(camera) {}

  void drawHandles(QPainter& painter) const;
  void drawLabels(QPainter& painter, LabelPlacer& labels) const;

  /** The cell that is selected; null: none, or weather is not shown. */
  [[nodiscard]] const document::ShownWeather* selected() const;
  /** The corner of the selected cell under a point of the screen. */
  [[nodiscard]] std::optional<WeatherCorner> cornerAt(QPointF at) const;

private:
  bool drawLabel(QPainter& painter, LabelPlacer& labels, const QRectF& seen, const QStringList& text) const;

  const MapScene& scene_;
  const MapCamera& camera_;
};

/** A corner that can be dragged. */
void drawHandle(QPainter& painter, QPointF at, const style::ChartColors& colors);

/** Index of the cell shown over a place; -1: none, or weather is not shown. */
int shownWeatherAt(const MapScene& scene, geo::Point place);

}  // namespace vp::map
