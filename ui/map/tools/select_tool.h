#pragma once

#include "ui/map/tools/map_tool.h"

#include <optional>

namespace vp::map {

/** Selects targets and points of the tour; drags targets. */
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
  int target_ = -1;  ///< pressed on
  QPointF pressed_;
  std::optional<QPointF> dragged_;  ///< while it is being dragged
};

}  // namespace vp::map
