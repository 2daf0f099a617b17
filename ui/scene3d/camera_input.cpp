#include "ui/scene3d/camera_input.h"

#include "ui/scene3d/scene_view.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyleHints>
#include <QWheelEvent>

#include <cmath>
#include <numbers>

namespace vp::scene3d {
namespace {

constexpr double kZoomPerPixel = 1.006;
constexpr double kZoomPerWheelUnit = 1.0016;  // a notch of 120 units: 1.21
constexpr double kZoomPerKey = 1.25;
constexpr double kPanPerKey = 0.08;  // of the picture
constexpr double kTurnPerKey = 0.09;

}  // namespace

CameraInput::Drag CameraInput::dragFor(Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers) {
  const bool left = buttons.testFlag(Qt::LeftButton);
  const bool right = buttons.testFlag(Qt::RightButton);
  if (buttons.testFlag(Qt::MiddleButton) || (left && right) || (left && modifiers.testFlag(Qt::ShiftModifier))) {
    return Drag::Orbit;
  }
  return left ? Drag::Pan : right ? Drag::Zoom : Drag::None;
}

void CameraInput::begin(Drag drag, QPointF place) {
  end();
  drag_ = drag;
  last_ = place;
  if (drag == Drag::Pan) {
    view_.controller_.beginPan(place.x(), place.y());
  }
}

void CameraInput::end() {
  if (drag_ == Drag::Pan) {
    view_.controller_.endPan();
  }
  drag_ = Drag::None;
}

void CameraInput::press(const QMouseEvent& event) {
  isClick_ = event.buttons() == Qt::LeftButton;
  start_ = event.position();
  hasMoved_ = false;
  begin(dragFor(event.buttons(), event.modifiers()), event.position());
}

bool CameraInput::move(const QMouseEvent& event) {
  const Drag wanted = dragFor(event.buttons(), event.modifiers());
  if (wanted == Drag::None && drag_ == Drag::None) {
    return false;
  }
  if (wanted != drag_) {
    begin(wanted, event.position());
  }
  if (!hasMoved_ && (event.position() - start_).manhattanLength() < QGuiApplication::styleHints()->startDragDistance()) {
    return true;
  }
  hasMoved_ = true;
  const QPointF step = event.position() - last_;
  last_ = event.position();
  CameraController& controller = view_.controller_;
  switch (drag_) {
    case Drag::Pan:
      controller.panTo(event.position().x(), event.position().y());
      break;
    case Drag::Orbit:
      // a drag across the picture turns half around
      controller.orbitBy(-step.x() * std::numbers::pi / std::max(1, view_.width()), step.y() * std::numbers::pi / std::max(1, view_.height()));
      break;
    case Drag::Zoom:
      controller.zoomAt(std::pow(kZoomPerPixel, -step.y()), start_.x(), start_.y());
      break;
    case Drag::None:
      break;
  }
  view_.cameraMoved(true);
  return true;
}

void CameraInput::release(const QMouseEvent& event) {
  if (event.buttons() == Qt::NoButton) {
    end();
    if (isClick_ && !hasMoved_) {
      view_.click(event.position());
    }
  } else {
    begin(dragFor(event.buttons(), event.modifiers()), event.position());
  }
}

void CameraInput::wheel(const QWheelEvent& event) {
  const QPoint angle = event.angleDelta();
  const int units = angle.y() != 0 ? angle.y() : angle.x();
  view_.controller_.zoomAt(std::pow(kZoomPerWheelUnit, units), event.position().x(), event.position().y());
  view_.cameraMoved(true);
}

bool CameraInput::arrow(int key, bool isOrbit) {
  const double right = key == Qt::Key_Right ? 1.0 : key == Qt::Key_Left ? -1.0 : 0.0;
  const double up = key == Qt::Key_Up ? 1.0 : key == Qt::Key_Down ? -1.0 : 0.0;
  if (right == 0.0 && up == 0.0) {
    return false;
  }
  if (isOrbit) {
    view_.controller_.orbitBy(right * kTurnPerKey, up * kTurnPerKey);
  } else {
    view_.controller_.panBy(right * kPanPerKey, up * kPanPerKey);
  }
  view_.cameraMoved(true);
  return true;
}

bool CameraInput::key(const QKeyEvent& event) {
  if (arrow(event.key(), event.modifiers().testFlag(Qt::ShiftModifier))) {
    return true;
  }
  const auto zoom = [this](double factor) {
    view_.controller_.zoomAt(factor, 0.5 * view_.width(), 0.5 * view_.height());
    view_.cameraMoved(true);
  };
  switch (event.key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_PageUp:
      zoom(kZoomPerKey);
      return true;
    case Qt::Key_Minus:
    case Qt::Key_PageDown:
      zoom(1.0 / kZoomPerKey);
      return true;
    case Qt::Key_Space:
    case Qt::Key_Home:
      view_.goHome();
      return true;
    case Qt::Key_1:
      view_.showPreset(Preset::Top);
      return true;
    case Qt::Key_2:
      view_.showPreset(Preset::North);
      return true;
    case Qt::Key_3:
      view_.showPreset(Preset::AlongTour);
      return true;
    case Qt::Key_4:
      view_.showPreset(Preset::FromRunway);
      return true;
    case Qt::Key_F:
      view_.setFollowing(!view_.isFollowing());
      return true;
    case Qt::Key_Escape:
      if (!view_.isFollowing()) {
        return false;
      }
      view_.setFollowing(false);
      return true;
    default:
      return false;
  }
}

}  // namespace vp::scene3d
