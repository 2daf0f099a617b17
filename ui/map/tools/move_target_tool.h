#pragma once

#include "ui/map/tools/map_tool.h"

#include <optional>
#include <string>

namespace vp::map {

/** Carries a target chosen in a menu until the next click places it. */
class MoveTargetTool : public MapTool {
public:
  MoveTargetTool(ToolHost& host, int target);
  void click(QPointF at) override;
  void hover(QPointF at) override;
  bool cancel() override;
  void sceneChanged() override;
  void paint(QPainter& painter) const override;
  [[nodiscard]] QCursor cursor(QPointF at) const override;
  [[nodiscard]] QString hint() const override;

private:
  int target_;
  std::string name_;
  std::optional<QPointF> at_;
};

}  // namespace vp::map
