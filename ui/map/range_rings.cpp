#include "ui/map/range_rings.h"

#include "ui/map/chart_text.h"
#include "ui/map/hit_test.h"

#include <QLineF>
#include <QPolygonF>

#include <algorithm>
#include <array>

namespace vp::map {
namespace {

constexpr std::array kRadii{1, 2, 5, 10, 20, 50};  // NM or km
constexpr int kCorners = 120;                      // of a circle: its sagitta is 0.03 % of the radius
constexpr double kLeastPixels = 22.0;              // smaller circles would only cover the place
constexpr double kMiddle = 5.0;                    // px, half the size of the mark in the middle
constexpr double kLabelGap = 2.0;                  // px between a circle and its label

}  // namespace

void RangeRings::toggle(geo::LatLon place) {
  const auto there = std::find_if(rings_.begin(), rings_.end(), [&](const Ring& ring) { return ring.place == place; });
  if (there != rings_.end()) {
    rings_.erase(there);
    return;
  }
  rings_.push_back({place, {}, {}});
  if (frame_) {
    layOut(rings_.back());
  }
}

std::optional<std::size_t> RangeRings::markAt(const MapCamera& camera, QPointF at) const {
  for (std::size_t i = 0; frame_ && i < rings_.size(); ++i) {
    if (QLineF(camera.toScreen(rings_[i].middle), at).length() <= kReach) {
      return i;
    }
  }
  return std::nullopt;
}

void RangeRings::layOut(Ring& ring) const {
  ring.middle = frame_->toPoint(ring.place);
  ring.circles.clear();
  for (const int radius : kRadii) {
    Circle circle;
    circle.radius = units_.distanceToSi(radius);
    circle.label = QStringLiteral("%1 %2").arg(radius).arg(units_.distanceUnit());
    for (int i = 0; i < kCorners; ++i) {
      const Angle course = Angle::degrees(360.0 * i / kCorners);
      circle.outline.push_back(frame_->toPoint(geo::geodesicDestination(ring.place, course, Length::fromSi(circle.radius))));
    }
    ring.circles.push_back(std::move(circle));
  }
}

void RangeRings::layOut(const MapScene& scene) {
  const auto& terrain = scene.situation.terrain;
  if (terrain == nullptr) {
    frame_.reset();
    return;
  }
  if (frame_ == terrain->frame && units_ == scene.units) {
    return;
  }
  frame_ = terrain->frame;
  units_ = scene.units;
  for (Ring& ring : rings_) {
    layOut(ring);
  }
}

void RangeRings::draw(QPainter& painter, const MapScene& scene, const MapCamera& camera) const {
  if (!frame_ || rings_.empty()) {
    return;
  }
  const style::ChartColors& colors = scene.colors();
  const QFont font = chartFont(TextSize::Small, true);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  for (const Ring& ring : rings_) {
    for (const Circle& circle : ring.circles) {
      if (circle.radius / camera.metresPerPixel() < kLeastPixels) {
        continue;
      }
      QPolygonF outline;
      for (const geo::Point& corner : circle.outline) {
        outline << camera.toScreen(corner);
      }
      if (!outline.boundingRect().intersects(camera.screen())) {
        continue;
      }
      painter.setPen(QPen(colors.textHalo, 3.6));
      painter.drawPolygon(outline);
      painter.setPen(QPen(colors.selection, 1.4));
      painter.drawPolygon(outline);
      const QSizeF size = textSize({circle.label}, font);
      for (const int corner : {0, kCorners / 4, kCorners / 2, 3 * kCorners / 4}) {  // north, else the first that is in view
        const QPointF on = outline[corner] - QPointF(size.width() / 2.0, size.height() + kLabelGap);
        if (camera.screen().contains(QRectF(on, size))) {
          drawHaloText(painter, on, {circle.label}, font, colors.selection, colors.textHalo);
          break;
        }
      }
    }
    const QPointF middle = camera.toScreen(ring.middle);
    for (const auto& [color, width] : {std::pair{colors.textHalo, 4.0}, std::pair{colors.selection, 1.8}}) {
      painter.setPen(QPen(color, width));
      painter.drawEllipse(middle, kMiddle, kMiddle);
      painter.drawPoint(middle);
    }
  }
  painter.restore();
}

}  // namespace vp::map
