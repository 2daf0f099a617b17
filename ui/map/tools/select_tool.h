#pragma once

#include "ui/map/tools/map_tool.h"
#include "ui/map/weather_marks.h"

#include <optional>

namespace vp::map {

/** Selects targets, weather and points of the tour; drags targets and the corners of the selected weather. */
class SelectTool : public MapTool {
public:
  using MapTool::MapTool;
  bool press(QPointF at) override;
  void drag(QPointF at) override;
  void release(QPointF at) override;
  void click(QPointF at) override;
  bool cancel() override;
  void sceneChanged() override;
  void paint(QPainter& painter) const override;
  [[nodiscard]] QCursor cursor(QPointF at) const override;
  [[nodiscard]] QString hint() const override;

private:
  [[nodiscard]] std::optional<WeatherCorner> cornerAt(QPointF at) const;
  void paintCorner(QPainter& painter) const;

  int target_ = -1;                      ///< pressed on
  std::optional<WeatherCorner> corner_;  ///< likewise, of the selected cell
  QPointF pressed_;
  std::optional<QPointF> dragged_;  ///< while it is being dragged
};

}  // namespace vp::map
