#pragma once

#include "ui/map/tools/map_tool.h"

#include <optional>
#include <vector>

namespace vp::map {

/** Draws the outline of a weather cell: a click sets a corner, a double click, Return or a click on the first corner closes it, Backspace takes the
 *  last corner back; Esc drops what was begun, then leaves. An outline that cannot be used stays to be put right. */
class DrawWeatherTool : public MapTool {
public:
  using MapTool::MapTool;
  void click(QPointF at) override;
  bool doubleClick(QPointF at) override;
  bool key(int key) override;
  void hover(QPointF at) override;
  bool cancel() override;
  void sceneChanged() override;
  void paint(QPainter& painter) const override;
  [[nodiscard]] QCursor cursor(QPointF at) const override;
  [[nodiscard]] QString hint() const override;

private:
  void close();
  [[nodiscard]] bool isOnFirst(QPointF at) const;

  std::vector<geo::Point> corners_;
  std::optional<geo::LatLon> frame_;  ///< origin of the frame that they are of
  std::optional<QPointF> at_;
};

}  // namespace vp::map
