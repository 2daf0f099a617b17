// What MapView shows: layers in their order, and what to do next.
#include "ui/map/chart_layout.h"
#include "ui/map/chart_text.h"
#include "ui/map/map_view.h"

#include <QPainter>

#include <cmath>

namespace vp::map {
namespace {

constexpr double kSurplus = 160.0;  // px that the picture of the objects is larger than the window on each side

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
    renderer_.drawFrame(painter, camera_, message());
  } else {
    drawInvitation(painter);
  }
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

/// What to do next; empty: nothing stands out.
QString MapView::message() const {
  const document::Situation& now = scene().situation;
  if (!tool_->hint().isEmpty()) {
    return tool_->hint();
  }
  if (now.sites == nullptr || now.sites->empty()) {
    return tr("No runways yet: drop an airfield file here, or choose File > Add airfields…");
  }
  if (now.targets == nullptr || now.targets->empty()) {
    return tr("No targets yet: right-click the map, or use the add-target tool and click");
  }
  return {};
}

/// In the middle of a map that has nothing to show yet.
void MapView::drawInvitation(QPainter& painter) const {
  const style::ChartColors& colors = scene().colors();
  const QString text = tr("Drop a terrain file here, or choose File > Add terrain…");
  const QFont font = chartFont(TextSize::Large);
  QRectF box(QPointF(), plateSize(text, font, camera_.size().width() - 2.0 * kFurnitureEdge));
  box.moveCenter(camera_.screen().center());
  drawPlate(painter, box, text, font, colors.text, colors.panel, colors.panelBorder);
}

}  // namespace vp::map
