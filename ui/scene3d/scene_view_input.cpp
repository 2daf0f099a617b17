// What the mouse and the keys do to a SceneView; see scene_view.h.
#include "ui/scene3d/camera_input.h"
#include "ui/scene3d/scene_picking.h"
#include "ui/scene3d/scene_view.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>

namespace vp::scene3d {
namespace {

constexpr double kHoverPixels = 14.0;
constexpr double kTargetPixels = 12.0;

}  // namespace

void SceneView::hover(QPointF place) {
  if (situation_.plan == nullptr || isFlying()) {
    return;
  }
  const auto distance = pickTour(*situation_.plan, model_.get(), camera(), options_.verticalExaggeration, place.x(), place.y(), kHoverPixels);
  setCursor(distance ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (distance || didHover_) {
    didHover_ = distance.has_value();
    state_.setHovered(distance);
  }
}

void SceneView::click(QPointF place) {
  setFocus(Qt::MouseFocusReason);
  if (situation_.targets != nullptr) {
    if (const auto target =
            pickTarget(*situation_.targets, model_.get(), camera(), options_.verticalExaggeration, place.x(), place.y(), kTargetPixels)) {
      state_.selectTarget(*target);
      return;
    }
  }
  if (situation_.plan == nullptr) {
    return;
  }
  if (const auto distance = pickTour(*situation_.plan, model_.get(), camera(), options_.verticalExaggeration, place.x(), place.y(), kHoverPixels)) {
    state_.setPinned(distance);
  }
}

void SceneView::goTo(QPointF place) {
  if (model_ == nullptr || controller_.isFollowing()) {
    return;
  }
  if (const auto ground = pickGround(*model_, camera(), options_.verticalExaggeration, place.x(), place.y())) {
    CameraOrbit orbit = controller_.orbit();
    orbit.pivot = *ground;
    orbit.distance *= 0.45;
    controller_.flyTo(orbit);
    cameraMoved(true);
  }
}

bool SceneView::event(QEvent* event) {
  // the window's shortcuts must not take the keys that move the camera while this view has the focus
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool isPlain = (key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
    if (isPlain && (key->key() == Qt::Key_Space || (key->key() >= Qt::Key_1 && key->key() <= Qt::Key_4) ||
                    (key->key() >= Qt::Key_Left && key->key() <= Qt::Key_Down))) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void SceneView::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  if (didHover_) {
    didHover_ = false;
    state_.setHovered(std::nullopt);
  }
}

void SceneView::mousePressEvent(QMouseEvent* event) {
  input_->press(*event);
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  if (!input_->move(*event)) {
    hover(event->position());
  }
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
  input_->release(*event);
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) {
    goTo(event->position());
  }
}

void SceneView::wheelEvent(QWheelEvent* event) {
  input_->wheel(*event);
}

void SceneView::keyPressEvent(QKeyEvent* event) {
  if (!input_->key(*event)) {
    QWidget::keyPressEvent(event);
  }
}

}  // namespace vp::scene3d
