// What MapView shows: layers in their order, and the hints of an empty map.
#include "ui/map/chart_text.h"
#include "ui/map/map_view.h"

#include <QPainter>

#include <cmath>

namespace vp::map {
namespace {

constexpr double kSurplus = 160.0;  // px that the picture of the objects is larger than the window on each side
constexpr double kHintTop = 26.0;   // px

}  // namespace

void MapView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const style::ChartColors& colors = scene().colors();
  if (scene().situation.terrain == nullptr) {
    painter.fillRect(rect(), colors.sky);
  }
  relief_.draw(painter, camera_, devicePixelRatioF());
  overlay_.draw(painter, camera_, devicePixelRatioF());
  drawObjects(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  rings_.draw(painter, scene(), camera_);
  renderer_.drawCursor(painter, camera_);
  tool_->paint(painter);
  if (scene().situation.terrain != nullptr) {
    renderer_.drawFrame(painter, camera_);
  }
  drawHints(painter);
}

void MapView::drawObjects(QPainter& painter) {
  const double ratio = devicePixelRatioF();
  const QSizeF size = camera_.size() + QSizeF(2.0 * kSurplus, 2.0 * kSurplus);
  const QPointF moved = camera_.toScreen(objectsCamera_.centre()) - camera_.screen().center();
  const bool fits = !objectsStale_ && objectsCamera_.metresPerPixel() == camera_.metresPerPixel() && objectsCamera_.size() == size &&
                    objects_.devicePixelRatio() == ratio && std::abs(moved.x()) <= kSurplus && std::abs(moved.y()) <= kSurplus;
  if (!fits) {
    objectsCamera_ = camera_.resized(size);
    const QSize pixels((size * ratio).toSize());
    if (objects_.size() != pixels || objects_.devicePixelRatio() != ratio) {
      objects_ = QImage(pixels, QImage::Format_ARGB32_Premultiplied);
      objects_.setDevicePixelRatio(ratio);
    }
    objects_.fill(Qt::transparent);
    QPainter onto(&objects_);
    renderer_.drawObjects(onto, objectsCamera_, {});
    objectsStale_ = false;
  }
  const QPointF at = camera_.toScreen(objectsCamera_.centre()) - camera_.screen().center() - QPointF(kSurplus, kSurplus);
  // at whole device pixels: a plain copy, and letters stay sharp
  painter.drawImage(QPointF(std::round(at.x() * ratio) / ratio, std::round(at.y() * ratio) / ratio), objects_);
}

void MapView::drawHints(QPainter& painter) const {
  const document::Situation& now = scene().situation;
  const style::ChartColors& colors = scene().colors();
  const bool hasTargets = now.targets != nullptr && !now.targets->empty();
  const bool hasSites = now.sites != nullptr && !now.sites->empty();
  const QPointF top(camera_.screen().center().x(), kHintTop);
  const auto hint = [&](const QString& text) {
    drawPlate(painter, top, text, chartFont(TextSize::Normal), colors.text, colors.panel, colors.panelBorder);
  };
  if (now.terrain == nullptr) {
    const QPointF middle = camera_.screen().center();
    drawPlate(painter, middle, tr("Drop a terrain file here, or choose File > Add terrain…"), chartFont(TextSize::Large), colors.text, colors.panel,
              colors.panelBorder);
  } else if (!tool_->hint().isEmpty()) {
    hint(tool_->hint());
  } else if (!hasSites) {
    hint(tr("No runways yet: drop an airfield file here, or choose File > Add airfields…"));
  } else if (!hasTargets) {
    hint(tr("No targets yet: right-click the map, or use the add-target tool and click"));
  }
}

}  // namespace vp::map
