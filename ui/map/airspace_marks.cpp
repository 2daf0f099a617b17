#include "ui/map/airspace_marks.h"

#include "ui/document/airspace_words.h"
#include "ui/style/short_name.h"

#include <QPainterPath>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace vp::map {
namespace {

using document::ShownAirspace;

constexpr double kSmallest = 40.0;  // px, airspaces smaller than this have no label
constexpr double kBand = 5.0;       // px, width of the tinted band inside the outline

QPolygonF polygonOf(const ShownAirspace& shown, const MapCamera& camera) {
  QPolygonF polygon;
  for (const geo::Point& corner : shown.outline) {
    polygon << camera.toScreen(corner);
  }
  return polygon;
}

}  // namespace

void AirspaceMarks::draw(QPainter& painter) const {
  if (scene_.situation.airspaces == nullptr) {
    return;
  }
  const QRectF screen = camera_.screen().adjusted(-kBand, -kBand, kBand, kBand);
  for (const ShownAirspace& shown : *scene_.situation.airspaces) {
    const QPolygonF polygon = polygonOf(shown, camera_);
    if (!polygon.boundingRect().intersects(screen)) {
      continue;
    }
    QPainterPath path;
    path.addPolygon(polygon);
    path.closeSubpath();
    const QColor color = style::ChartColors::airspace(scene_.theme, shown.airspace.kind);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipPath(path, Qt::IntersectClip);
    QColor band = color;
    band.setAlpha(60);
    painter.setPen(QPen(band, 2.0 * kBand));
    painter.setBrush(shown.use == mission::AirspaceUse::Forbid ? QBrush(band, Qt::BDiagPattern) : QBrush(Qt::NoBrush));
    painter.drawPath(path);
    painter.restore();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const bool matters = shown.use == mission::AirspaceUse::Warn || shown.use == mission::AirspaceUse::Forbid;
    QPen pen(color, matters ? 2.0 : 1.0);
    pen.setStyle(shown.airspace.kind == "CTR" ? Qt::DashLine : Qt::SolidLine);
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
    painter.restore();
  }
}

void AirspaceMarks::drawLabels(QPainter& painter, LabelPlacer& labels) const {
  if (scene_.situation.airspaces == nullptr) {
    return;
  }
  const QFont font = chartFont(TextSize::Small);
  for (const ShownAirspace& shown : *scene_.situation.airspaces) {
    const QRectF box = polygonOf(shown, camera_).boundingRect();
    const QRectF seen = box.intersected(camera_.screen());
    if (std::min(seen.width(), seen.height()) < kSmallest) {
      continue;
    }
    QStringList text = document::airspaceText(shown.airspace, scene_.units);
    text.front() = style::shortName(text.front());
    const QSizeF size = textSize(text, font);
    // at the upper left inside, where charts put it, else in the middle
    for (const QPointF at : {seen.topLeft() + QPointF(2.0 * kBand, 2.0 * kBand), seen.center() - QPointF(size.width() / 2.0, size.height() / 2.0)}) {
      if (labels.placeAt(QRectF(at, size))) {
        drawHaloText(painter, at, text, font, style::ChartColors::airspace(scene_.theme, shown.airspace.kind), scene_.colors().textHalo);
        break;
      }
    }
  }
}

}  // namespace vp::map
