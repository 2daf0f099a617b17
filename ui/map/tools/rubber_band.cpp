#include "ui/map/tools/rubber_band.h"

#include "ui/map/words.h"

#include <cmath>

namespace vp::map {

QString distanceText(const MapScene& scene, geo::Point from, geo::Point to) {
  if (scene.situation.terrain == nullptr) {
    return scene.units.distance(geo::distance(from, to));
  }
  const geo::LatLon a = scene.situation.terrain->frame.toLatLon(from);
  const geo::LatLon b = scene.situation.terrain->frame.toLatLon(to);
  const QString distance = scene.units.distance(geo::geodesicDistance(a, b).si());
  return a == b ? distance : QStringLiteral("%1   %2").arg(distance, style::Units::course(geo::geodesicCourse(a, b).degrees()));
}

QString groundText(const MapScene& scene, geo::Point at) {
  const double ground = scene.situation.terrain != nullptr ? scene.situation.terrain->grid->upperAt(at) : HUGE_VAL;
  return std::isfinite(ground) ? Words::tr("ground %1").arg(scene.units.altitudeMsl(ground)) : Words::tr("ground unknown");
}

void drawRubberBand(QPainter& painter, const MapScene& scene, const MapCamera& camera, geo::Point from, geo::Point to) {
  const style::ChartColors& colors = scene.colors();
  const QPointF a = camera.toScreen(from);
  const QPointF b = camera.toScreen(to);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colors.textHalo, 4.5, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(a, b);
  painter.setPen(QPen(colors.selection, 2.0, Qt::DashLine, Qt::FlatCap));
  painter.drawLine(a, b);
  for (const QPointF& end : {a, b}) {
    painter.setPen(QPen(colors.textHalo, 4.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(end, 4.0, 4.0);
    painter.setPen(QPen(colors.selection, 1.8));
    painter.drawEllipse(end, 4.0, 4.0);
  }
  painter.restore();
}

}  // namespace vp::map
