#include "ui/map/tools/select_tool.h"

#include "ui/map/chart_text.h"
#include "ui/map/hit_test.h"
#include "ui/map/target_marks.h"
#include "ui/map/tools/rubber_band.h"
#include "ui/map/words.h"

#include <QGuiApplication>
#include <QStyleHints>

namespace vp::map {

bool SelectTool::press(QPointF at) {
  const MapObject object = objectAt(host().scene(), host().camera(), at);
  if (object.kind != MapObject::Kind::Target) {
    return false;
  }
  target_ = object.index;
  pressed_ = at;
  host().viewState().selectTarget(target_);
  return true;
}

void SelectTool::drag(QPointF at) {
  if (target_ >= 0 && (dragged_ || (at - pressed_).manhattanLength() >= QGuiApplication::styleHints()->startDragDistance())) {
    dragged_ = at;
    host().redraw();
  }
}

void SelectTool::release(QPointF at) {
  const int target = target_;
  const bool wasDragged = dragged_.has_value();
  target_ = -1;
  dragged_.reset();
  if (wasDragged && target >= 0) {
    host().askMoveTarget(target, host().camera().toGround(at));
  }
  host().redraw();
}

void SelectTool::click(QPointF at) {
  const MapObject object = objectAt(host().scene(), host().camera(), at);
  if (object.kind == MapObject::Kind::Tour) {
    host().viewState().setPinned(object.distance);
  } else if (object.kind == MapObject::Kind::Site) {
    host().askShowSite(object.index);
  } else if (object.kind == MapObject::Kind::Ground) {
    host().viewState().selectTarget(-1);
  }
}

bool SelectTool::cancel() {
  const bool wasDragged = dragged_.has_value();
  target_ = -1;
  dragged_.reset();
  host().redraw();
  return wasDragged;
}

void SelectTool::sceneChanged() {
  const auto& targets = host().scene().situation.targets;
  if (targets == nullptr || target_ >= static_cast<int>(targets->size())) {
    target_ = -1;
    dragged_.reset();
  }
}

void SelectTool::paint(QPainter& painter) const {
  if (!dragged_ || target_ < 0) {
    return;
  }
  const MapScene& scene = host().scene();
  const geo::Point from = (*scene.situation.targets)[static_cast<std::size_t>(target_)].point;
  const geo::Point to = host().camera().toGround(*dragged_);
  drawRubberBand(painter, scene, host().camera(), from, to);
  drawTargetSymbol(painter, *dragged_, scene.colors(), true, false);
  drawReadout(painter, *dragged_ + QPointF(18.0, 14.0), {distanceText(scene, from, to), groundText(scene, to)}, scene.colors(),
              host().camera().screen());
}

QCursor SelectTool::cursor(QPointF at) const {
  if (dragged_) {
    return Qt::SizeAllCursor;
  }
  switch (objectAt(host().scene(), host().camera(), at).kind) {
    case MapObject::Kind::Target:
      return Qt::SizeAllCursor;
    case MapObject::Kind::Site:
    case MapObject::Kind::Tour:
      return Qt::PointingHandCursor;
    case MapObject::Kind::Ground:
      break;
  }
  return Qt::ArrowCursor;
}

QString SelectTool::hint() const {
  return dragged_ ? Words::tr("Release to place the target; Esc or right click to leave it where it was") : QString();
}

}  // namespace vp::map
