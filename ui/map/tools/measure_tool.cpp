#include "ui/map/tools/measure_tool.h"

#include "ui/map/chart_text.h"
#include "ui/map/tools/rubber_band.h"
#include "ui/map/words.h"

namespace vp::map {

void MeasureTool::startAt(geo::Point from) {
  from_ = from;
  to_.reset();
  isFixed_ = false;
  host().redraw();
}

void MeasureTool::click(QPointF at) {
  const geo::Point place = host().camera().toGround(at);
  if (!from_ || isFixed_) {
    startAt(place);
  } else {
    to_ = place;
    isFixed_ = true;
  }
  host().redraw();
}

void MeasureTool::hover(QPointF at) {
  if (from_ && !isFixed_) {
    to_ = host().camera().toGround(at);
    host().redraw();
  }
}

bool MeasureTool::cancel() {
  if (from_) {
    from_.reset();
    to_.reset();
    isFixed_ = false;
    host().redraw();
  } else {
    host().leaveTool();
  }
  return true;
}

void MeasureTool::paint(QPainter& painter) const {
  if (!from_) {
    return;
  }
  const MapScene& scene = host().scene();
  const MapCamera& camera = host().camera();
  const geo::Point to = to_.value_or(*from_);
  drawRubberBand(painter, scene, camera, *from_, to);
  QStringList lines{Words::tr("start: %1").arg(groundText(scene, *from_))};
  if (to_) {
    lines = {distanceText(scene, *from_, to), lines.front(), Words::tr("end: %1").arg(groundText(scene, to))};
  }
  drawReadout(painter, camera.toScreen(to) + QPointF(18.0, 14.0), lines, scene.colors(), camera.screen());
}

QCursor MeasureTool::cursor(QPointF /*at*/) const {
  return Qt::CrossCursor;
}

QString MeasureTool::hint() const {
  return from_ && !isFixed_ ? Words::tr("Click where to measure to") : Words::tr("Click where to measure from; Esc when done");
}

}  // namespace vp::map
