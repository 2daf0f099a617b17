#include "ui/map/tools/move_target_tool.h"

#include "ui/map/chart_text.h"
#include "ui/map/target_marks.h"
#include "ui/map/tools/rubber_band.h"
#include "ui/map/words.h"

namespace vp::map {

MoveTargetTool::MoveTargetTool(ToolHost& host, int target)
    : MapTool(host), target_(target), name_((*host.scene().situation.targets)[static_cast<std::size_t>(target)].target.name) {}

void MoveTargetTool::click(QPointF at) {
  const int target = target_;
  const geo::Point place = host().camera().toGround(at);
  host().leaveTool();
  host().askMoveTarget(target, place);
}

void MoveTargetTool::hover(QPointF at) {
  at_ = at;
  host().redraw();
}

bool MoveTargetTool::cancel() {
  host().leaveTool();
  return true;
}

void MoveTargetTool::sceneChanged() {
  const auto& targets = host().scene().situation.targets;
  const auto at = static_cast<std::size_t>(target_);
  if (targets == nullptr || at >= targets->size() || (*targets)[at].target.name != name_) {
    host().leaveTool();
  }
}

void MoveTargetTool::paint(QPainter& painter) const {
  const MapScene& scene = host().scene();
  if (!at_ || scene.situation.targets == nullptr) {
    return;
  }
  const geo::Point from = (*scene.situation.targets)[static_cast<std::size_t>(target_)].point;
  const geo::Point to = host().camera().toGround(*at_);
  drawRubberBand(painter, scene, host().camera(), from, to);
  drawTargetSymbol(painter, *at_, scene.colors(), true, false);
  drawReadout(painter, *at_ + QPointF(18.0, 14.0), {distanceText(scene, from, to), groundText(scene, to)}, scene.colors(), host().camera().screen());
}

QCursor MoveTargetTool::cursor(QPointF /*at*/) const {
  return Qt::SizeAllCursor;
}

QString MoveTargetTool::hint() const {
  return Words::tr("Click where %1 shall be; Esc or right click to leave it").arg(QString::fromStdString(name_));
}

}  // namespace vp::map
