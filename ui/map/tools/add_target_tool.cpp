#include "ui/map/tools/add_target_tool.h"

#include "ui/map/chart_text.h"
#include "ui/map/hit_test.h"
#include "ui/map/target_marks.h"
#include "ui/map/tools/rubber_band.h"
#include "ui/map/words.h"

namespace vp::map {

void AddTargetTool::click(QPointF at) {
  const MapObject object = objectAt(host().scene(), host().camera(), at);
  if (object.kind == MapObject::Kind::Target) {
    host().viewState().selectTarget(object.index);
    return;
  }
  const int before = object.kind == MapObject::Kind::Tour ? insertionIndex(host().scene(), object.distance) : -1;
  host().askAddTarget(host().camera().toGround(at), before);
}

void AddTargetTool::hover(QPointF at) {
  at_ = at;
  host().redraw();
}

bool AddTargetTool::cancel() {
  host().leaveTool();
  return true;
}

void AddTargetTool::paint(QPainter& painter) const {
  if (!at_ || !host().camera().screen().contains(*at_)) {
    return;
  }
  const MapScene& scene = host().scene();
  const MapObject object = objectAt(scene, host().camera(), *at_);
  if (object.kind == MapObject::Kind::Target) {
    return;
  }
  QStringList lines{groundText(scene, host().camera().toGround(*at_))};
  const int before = object.kind == MapObject::Kind::Tour ? insertionIndex(scene, object.distance) : -1;
  if (before >= 0) {
    lines.push_front(Words::tr("insert before %1").arg(targetTitle((*scene.situation.targets)[static_cast<std::size_t>(before)])));
  }
  painter.setOpacity(0.6);
  drawTargetSymbol(painter, *at_, scene.colors(), false, false);
  painter.setOpacity(1.0);
  drawReadout(painter, *at_ + QPointF(18.0, 14.0), lines, scene.colors(), host().camera().screen());
}

QCursor AddTargetTool::cursor(QPointF /*at*/) const {
  return Qt::CrossCursor;
}

QString AddTargetTool::hint() const {
  return Words::tr("Click to add a target, on the tour to insert it there; Esc when done");
}

}  // namespace vp::map
