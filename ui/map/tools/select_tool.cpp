#include "ui/map/tools/select_tool.h"

#include "ui/map/chart_text.h"
#include "ui/map/hit_test.h"
#include "ui/map/target_marks.h"
#include "ui/map/tools/rubber_band.h"
#include "ui/map/words.h"

#include <QGuiApplication>
#include <QStyleHints>

#include <utility>

namespace vp::map {

std::optional<WeatherCorner> SelectTool::cornerAt(QPointF at) const {
  return WeatherMarks(host().scene(), host().camera()).cornerAt(at);
}

bool SelectTool::press(QPointF at) {
  corner_ = cornerAt(at);
  pressed_ = at;
  if (corner_) {
    return true;
  }
  const MapObject object = objectAt(host().scene(), host().camera(), at);
  if (object.kind != MapObject::Kind::Target) {
    return false;
  }
  target_ = object.index;
  host().viewState().selectTarget(target_);
  return true;
}

void SelectTool::drag(QPointF at) {
  if ((target_ >= 0 || corner_) && (dragged_ || (at - pressed_).manhattanLength() >= QGuiApplication::styleHints()->startDragDistance())) {
    dragged_ = at;
    host().redraw();
  }
}

void SelectTool::release(QPointF at) {
  const int target = target_;
  const std::optional<WeatherCorner> corner = corner_;
  const bool wasDragged = dragged_.has_value();
  target_ = -1;
  corner_.reset();
  dragged_.reset();
  if (wasDragged && corner) {
    host().askMoveWeatherCorner(corner->cell, corner->corner, host().camera().toGround(at));
  } else if (wasDragged && target >= 0) {
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
    host().viewState().selectWeather(shownWeatherAt(host().scene(), host().camera().toGround(at)));
  }
}

bool SelectTool::cancel() {
  const bool wasDragged = dragged_.has_value();
  target_ = -1;
  corner_.reset();
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
  const document::ShownWeather* cell = WeatherMarks(host().scene(), host().camera()).selected();
  if (corner_ && (cell == nullptr || corner_->cell != host().scene().selectedWeather || corner_->corner >= cell->outline.size())) {
    corner_.reset();
    dragged_.reset();
  }
}

/// The two sides that move with a corner.
void SelectTool::paintCorner(QPainter& painter) const {
  const document::ShownWeather* cell = WeatherMarks(host().scene(), host().camera()).selected();
  if (cell == nullptr) {
    return;
  }
  const style::ChartColors& colors = host().scene().colors();
  const std::size_t count = cell->outline.size();
  const QPointF before = host().camera().toScreen(cell->outline[(corner_->corner + count - 1) % count]);
  const QPointF after = host().camera().toScreen(cell->outline[(corner_->corner + 1) % count]);
  for (const auto& [color, width] : {std::pair{colors.routeCasing, 4.0}, std::pair{colors.weather, 2.0}}) {
    painter.setPen(QPen(color, width, Qt::DashLine));
    painter.drawLine(before, *dragged_);
    painter.drawLine(*dragged_, after);
  }
  drawHandle(painter, *dragged_, colors);
}

void SelectTool::paint(QPainter& painter) const {
  if (dragged_ && corner_) {
    paintCorner(painter);
  }
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
  if (dragged_ || cornerAt(at)) {
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
  if (dragged_ && corner_) {
    return Words::tr("Release to place the corner; Esc or right click to leave it where it was");
  }
  return dragged_ ? Words::tr("Release to place the target; Esc or right click to leave it where it was") : QString();
}

}  // namespace vp::map
