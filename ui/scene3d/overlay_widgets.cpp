#include "ui/scene3d/overlay_widgets.h"

#include "ui/scene3d/scene_overlay.h"

#include <QMouseEvent>
#include <QPainter>

#include <cmath>
#include <functional>

namespace vp::scene3d {
namespace {

constexpr int kMargin = 12;
constexpr int kLeastHeight = 260;  // of the view, below which the legend would cover too much

}  // namespace

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
  legend_ = new Part(view, [this](QPainter& painter, const QRectF& rect) { paintAltitudeLegend(painter, rect, range_, style_); });
  legend_->setAccessibleName(tr("Colours of altitudes"));
  legend_->setAttribute(Qt::WA_TransparentForMouseEvents);
  note_ = new Part(view, [this](QPainter& painter, const QRectF& rect) { paintNote(painter, rect, exaggerationText(exaggeration_), style_.theme); });
  note_->setAttribute(Qt::WA_TransparentForMouseEvents);
}

void SceneOverlay::arrange() {
  const int side = static_cast<int>(kCompassSide);
  compass_->setGeometry(rect_.right() - kMargin - side + 1, rect_.top() + kMargin, side, side);
  const QSize legend = legendSize(style_).toSize();
  legend_->setGeometry(rect_.left() + kMargin, rect_.bottom() - kMargin - legend.height() + 1, legend.width(), legend.height());
  const QString text = exaggerationText(exaggeration_);
  note_->setGeometry(QRect(QPoint(rect_.left() + kMargin, rect_.top() + kMargin), noteSize(text).toSize()));
  note_->setAccessibleName(text);
  compass_->setVisible(isVisible_);
  legend_->setVisible(isVisible_ && hasAltitudes_ && rect_.height() >= kLeastHeight);
  note_->setVisible(isVisible_ && !text.isEmpty());
  for (Part* part : {compass_, legend_, note_}) {
    part->raise();
    part->update();
  }
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

void SceneOverlay::setAltitudes(const AltitudeRange& range, bool hasAltitudes) {
  range_ = range;
  hasAltitudes_ = hasAltitudes;
  arrange();
}

}  // namespace vp::scene3d
