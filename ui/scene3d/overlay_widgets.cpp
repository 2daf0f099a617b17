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
  wind_ = new Part(view, [this](QPainter& painter, const QRectF& rect) { paintWind(painter, rect, content_.winds, azimuth_, style_); });
  wind_->setAccessibleName(tr("Wind that the plan holds for"));
  wind_->setAttribute(Qt::WA_TransparentForMouseEvents);
  legend_ = new Part(view, [this](QPainter& painter, const QRectF& rect) { paintLegend(painter, rect, content_.legend, style_); });
  legend_->setAccessibleName(tr("Colours of altitudes"));
  legend_->setAttribute(Qt::WA_TransparentForMouseEvents);
  note_ = new Part(
      view, [this](QPainter& painter, const QRectF& rect) { paintNote(painter, rect, exaggerationText(content_.exaggeration), style_.theme); });
  note_->setAttribute(Qt::WA_TransparentForMouseEvents);
}

void SceneOverlay::arrange() {
  layout_ = isVisible_ ? layOutOverlay(QSizeF(rect_.size()), content_, style_) : OverlayLayout{};
  const auto place = [this](Part* part, const QRectF& rect) {
    part->setGeometry(rect.toAlignedRect().translated(rect_.topLeft()));
    part->setVisible(!rect.isEmpty());
    part->raise();
    part->update();
  };
  place(compass_, layout_.compass);
  place(wind_, layout_.wind);
  place(legend_, layout_.legend);
  place(note_, layout_.note);
  note_->setAccessibleName(exaggerationText(content_.exaggeration));
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
    wind_->update();
  }
}

void SceneOverlay::setExaggeration(double factor) {
  content_.exaggeration = factor;
  arrange();
}

void SceneOverlay::setAltitudes(std::optional<AltitudeRange> range) {
  content_.legend.altitudes = range;
  arrange();
}

void SceneOverlay::setContourInterval(double metres) {
  content_.legend.contourInterval = metres;
  arrange();
}

void SceneOverlay::setWinds(std::vector<air::WindLayer> winds) {
  if (winds != content_.winds) {
    content_.winds = std::move(winds);
    arrange();
  }
}

}  // namespace vp::scene3d
