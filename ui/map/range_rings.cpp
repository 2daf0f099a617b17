#include "ui/map/range_rings.h"

#include "ui/map/chart_text.h"
#include "ui/map/hit_test.h"

#include <QLineF>

#include <algorithm>
#include <array>

namespace vp::map {
namespace {

constexpr std::array kRadii{1, 2, 5, 10, 20, 50};  // NM or km
constexpr int kCorners = 120;                      // of a circle: its sagitta is 0.03 % of the radius
constexpr double kLeastPixels = 22.0;              // smaller circles would only cover the place
constexpr double kMiddle = 5.0;                    // px, half the size of the mark in the middle
constexpr int kLabelPlaces = 12;                   // tried around a circle, from the north
constexpr double kMarkText = 75.0;                 // px, room of the text to the right of a target or runway
constexpr double kMarkRoom = 20.0;                 // px, room of its symbol
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

/// Where the label of a circle stands: over its northernmost point, else the next one round that is in view and hides no
/// target or runway with the text to its right; nothing if there is no such place.
std::optional<QPointF> RangeRings::labelPlace(const QPolygonF& outline, QSizeF size, const MapScene& scene, const MapCamera& camera) {
  std::vector<QPointF> marks;
  if (scene.situation.targets != nullptr) {
    for (const document::ShownTarget& target : *scene.situation.targets) {
      marks.push_back(camera.toScreen(target.point));
    }
  }
  if (scene.situation.sites != nullptr) {
    for (const document::ShownSite& site : *scene.situation.sites) {
      marks.push_back(camera.toScreen(site.site.pose.point()));
    }
  }
  for (int corner = 0; corner < kCorners; corner += kCorners / kLabelPlaces) {
    const QRectF box(outline[corner] - QPointF(size.width() / 2.0, size.height() + kLabelGap), size);
    const QRectF kept = box.adjusted(-kMarkText, -kMarkRoom, kMarkRoom, kMarkRoom);
    const bool hides = std::any_of(marks.begin(), marks.end(), [&kept](QPointF mark) { return kept.contains(mark); });
    if (camera.screen().contains(box) && !hides) {
      return box.topLeft();
    }
  }
  return std::nullopt;
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
      if (const auto at = labelPlace(outline, textSize({circle.label}, font), scene, camera)) {
        drawHaloText(painter, *at, {circle.label}, font, colors.selection, colors.textHalo);
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
