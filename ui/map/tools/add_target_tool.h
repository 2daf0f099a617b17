#pragma once

#include "ui/map/tools/map_tool.h"

#include <optional>

namespace vp::map {

/** A click adds a target, on a leg of the tour between its neighbours. Stays until it is left. */
class AddTargetTool : public MapTool {
public:
  using MapTool::MapTool;
  void click(QPointF at) override;
  void hover(QPointF at) override;
  bool cancel() override;
  void paint(QPainter& painter) const override;
  [[nodiscard]] QCursor cursor(QPointF at) const override;
  [[nodiscard]] QString hint() const override;

private:
  std::optional<QPointF> at_;
};

}  // namespace vp::map
