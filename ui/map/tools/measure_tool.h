#pragma once

#include "ui/map/tools/map_tool.h"

#include <optional>

namespace vp::map {

/** Measures between two clicks: distance, true course, ground at both ends. */
class MeasureTool : public MapTool {
public:
  using MapTool::MapTool;
  void startAt(geo::Point from);
  void click(QPointF at) override;
  void hover(QPointF at) override;
  bool cancel() override;
  void paint(QPainter& painter) const override;
  [[nodiscard]] QCursor cursor(QPointF at) const override;
  [[nodiscard]] QString hint() const override;

private:
  std::optional<geo::Point> from_;
  std::optional<geo::Point> to_;
  bool isFixed_ = false;  ///< both ends are set
};

}  // namespace vp::map
