#include "ui/scene3d/overlay_widgets.h"

#include <QMouseEvent>
#include <QPainter>

#include <cmath>
#include <functional>
#include <utility>

namespace vp::scene3d {
/// A small widget that paints one thing.
class SceneOverlay::Part : public QWidget {
public:
  Part(QWidget* view, std::function<void(QPainter&, const QRectF&)> paint) : QWidget(view), paint_(std::move(paint)) {
    setAttribute(Qt::WA_NoSystemBackground);
  }
  std::function<void()> pressed;

protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    paint_(painter, QRectF(rect()));
  }
  void mousePressEvent(QMouseEvent* event) override {
    if (pressed && event->button() == Qt::LeftButton) {
      pressed();
    } else {
      event->ignore();
    }
  }

private:
  std::function<void(QPainter&, const QRectF&)> paint_;
};

SceneOverlay::SceneOverlay(QWidget* view) : QObject(view) {
  compass_ = new Part(view, [this](QPainter& painter, const QRectF& rect) { paintCompass(painter, rect, azimuth_, style_.theme); });
  compass_->setCursor(Qt::PointingHandCursor);
  compass_->setToolTip(tr("Turn the view north"));
  compass_->setAccessibleName(tr("Compass"));
  compass_->pressed = [this] { emit northRequested(); };
  legend_ = new Part(view, [this](QPainter& painter, const QRectF& rect) { paintLegend(painter, rect, content_, style_); });
  legend_->setAccessibleName(tr("Colours of altitudes"));
  legend_->setAttribute(Qt::WA_TransparentForMouseEvents);
  note_ = new Part(view, [this](QPainter& painter, const QRectF& rect) { paintNote(painter, rect, exaggerationText(exaggeration_), style_.theme); });
  note_->setAttribute(Qt::WA_TransparentForMouseEvents);
}

void SceneOverlay::arrange() {
  layout_ = isVisible_ ? layOutOverlay(QSizeF(rect_.size()), content_, style_, exaggeration_) : OverlayLayout{};
  const auto place = [this](Part* part, const QRectF& rect) {
    part->setGeometry(rect.toAlignedRect().translated(rect_.topLeft()));
    part->setVisible(!rect.isEmpty());
    part->raise();
    part->update();
  };
  place(compass_, layout_.compass);
  place(legend_, layout_.legend);
  place(note_, layout_.note);
  note_->setAccessibleName(exaggerationText(exaggeration_));
  emit arranged();
}

void SceneOverlay::setGeometry(const QRect& rect) {
  rect_ = rect;
  arrange();
}

void SceneOverlay::setVisible(bool visible) {
  isVisible_ = visible;
  arrange();
}

void SceneOverlay::setStyle(const SceneStyle& style) {
  style_ = style;
  arrange();
}

void SceneOverlay::setAzimuth(double azimuth) {
  if (std::abs(azimuth - azimuth_) > 1e-3) {
    azimuth_ = azimuth;
    compass_->update();
  }
}

void SceneOverlay::setExaggeration(double factor) {
  exaggeration_ = factor;
  arrange();
}

void SceneOverlay::setAltitudes(std::optional<AltitudeRange> range) {
  content_.altitudes = range;
  arrange();
}

void SceneOverlay::setContourInterval(double metres) {
  content_.contourInterval = metres;
  arrange();
}

}  // namespace vp::scene3d
