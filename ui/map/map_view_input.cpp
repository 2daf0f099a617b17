// What MapView does with mouse and keys.
#include "ui/map/hit_test.h"
#include "ui/map/map_menu.h"
#include "ui/map/map_view.h"

#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyleHints>
#include <QWheelEvent>

#include <cmath>

namespace vp::map {
namespace {

constexpr double kNotch = 120.0;          // eighths of a degree of a wheel's notch
constexpr double kOctavesPerNotch = 0.5;  // three notches: not quite three times as close
constexpr double kKeyPan = 0.15;          // of the view
constexpr double kKeyZoom = 1.5;
constexpr double kHoverReach = 14.0;  // px around the tour
constexpr double kSiteScale = 8.0;    // m per px when a runway is zoomed to
constexpr double kDoubleClickZoom = 2.0;
constexpr Qt::KeyboardModifiers kClickModifiers = Qt::ShiftModifier | Qt::ControlModifier | Qt::AltModifier;

}  // namespace

void MapView::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / kNotch;
  if (notches != 0.0) {
    moveTo(camera_.zoomedAt(event->position(), std::exp2(notches * kOctavesPerNotch)), Jump::No);
    hoverAt(event->position());
  }
  event->accept();
}

void MapView::mousePressEvent(QMouseEvent* event) {
  leftTools_.clear();
  isUntouched_ = false;
  const QPointF at = event->position();
  pressedAt_ = at;
  lastAt_ = at;
  if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && isSpaceHeld_)) {
    drag_ = Drag::Panning;
  } else if (event->button() == Qt::LeftButton && drag_ == Drag::None) {
    const bool isPlain = (event->modifiers() & kClickModifiers) == Qt::NoModifier;
    drag_ = isPlain && tool_->press(at) ? Drag::Tool : Drag::Undecided;
  } else if (event->button() == Qt::RightButton) {
    const bool wasDragging = drag_ == Drag::Tool;
    swallowsMenu_ = tool_->cancel();
    drag_ = wasDragging ? Drag::None : drag_;
  }
  updateCursorShape();
}

void MapView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  if (drag_ == Drag::Undecided && (at - pressedAt_).manhattanLength() >= QGuiApplication::styleHints()->startDragDistance()) {
    drag_ = Drag::Panning;
    lastAt_ = pressedAt_;
    updateCursorShape();
  }
  if (drag_ == Drag::Panning || (isSpaceHeld_ && drag_ == Drag::None)) {
    moveTo(camera_.panned(at - lastAt_), Jump::No);
  } else if (drag_ == Drag::Tool) {
    tool_->drag(at);
  }
  lastAt_ = at;
  hoverAt(at);
}

void MapView::mouseReleaseEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  const Drag was = drag_;
  const bool endsDrag = event->button() == Qt::LeftButton || (event->button() == Qt::MiddleButton && was == Drag::Panning);
  if (!endsDrag) {
    return;
  }
  drag_ = Drag::None;
  if (was == Drag::Tool) {
    tool_->release(at);
  } else if (was == Drag::Undecided && !clickWith(event->modifiers() & kClickModifiers, at)) {
    tool_->click(at);
  }
  updateCursorShape();
}

/// A click with keys held, or on the middle of range rings. @return false: the tool's business
bool MapView::clickWith(Qt::KeyboardModifiers modifiers, QPointF at) {
  const geo::Point place = camera_.toGround(at);
  if (modifiers == (Qt::ControlModifier | Qt::AltModifier)) {
    const auto& plan = scene().situation.plan;
    const auto distance = plan != nullptr ? plan->nearest(place, HUGE_VAL) : std::nullopt;
    askAddTarget(place, distance ? insertionIndex(scene(), *distance) : -1);
  } else if (modifiers == (Qt::ShiftModifier | Qt::AltModifier)) {
    askAddTarget(place, -1);
  } else if (modifiers == Qt::ShiftModifier || (modifiers == Qt::NoModifier && isOnRingMiddle(at))) {
    toggleRings(place);
  } else if ((modifiers == Qt::ControlModifier || modifiers == Qt::AltModifier) && toolKind_ != Tool::Measure) {
    measureFrom(place);
  } else {
    return false;
  }
  return true;
}

bool MapView::isOnRingMiddle(QPointF at) const {
  return toolKind_ == Tool::Select && rings_.markAt(camera_, at) && objectAt(scene(), camera_, at).kind == MapObject::Kind::Ground;
}

void MapView::mouseDoubleClickEvent(QMouseEvent* event) {
  const bool isPlain = (event->modifiers() & kClickModifiers) == Qt::NoModifier;
  if (event->button() == Qt::LeftButton && toolKind_ == Tool::Select && !isSpaceHeld_ && isPlain) {
    zoomToObject(event->position());
  } else if (event->button() == Qt::LeftButton && !isSpaceHeld_ && isPlain && tool_->doubleClick(event->position())) {
    updateCursorShape();
  } else {
    mousePressEvent(event);
  }
}

void MapView::zoomToObject(QPointF at) {
  const MapObject object = objectAt(scene(), camera_, at);
  if (object.kind == MapObject::Kind::Target) {
    zoomToTarget(object.index);
  } else if (object.kind == MapObject::Kind::Site) {
    zoomToPlace((*scene().situation.sites)[static_cast<std::size_t>(object.index)].site.pose.point(), kSiteScale);
  } else {
    moveTo(camera_.zoomedAt(at, kDoubleClickZoom), Jump::Yes);
  }
}

void MapView::hoverAt(QPointF at) {
  pointer_ = at;
  emit pointerMoved(latLon(camera_.toGround(at)));
  tool_->hover(at);
  std::optional<double> distance;
  if (scene().situation.plan != nullptr && drag_ == Drag::None) {
    distance = scene().situation.plan->nearest(camera_.toGround(at), kHoverReach * camera_.metresPerPixel());
  }
  if (distance) {
    hasHovered_ = true;
    state_.setHovered(distance);
  } else {
    clearHover();
  }
  updateCursorShape();
}

void MapView::clearHover() {
  if (hasHovered_) {
    hasHovered_ = false;
    state_.setHovered(std::nullopt);
  }
}

void MapView::leaveEvent(QEvent* event) {
  pointer_.reset();
  clearHover();
  emit pointerMoved(std::nullopt);
  QWidget::leaveEvent(event);
}

void MapView::updateCursorShape() {
  if (drag_ == Drag::Panning) {
    setCursor(Qt::ClosedHandCursor);
  } else if (isSpaceHeld_) {
    setCursor(Qt::OpenHandCursor);
  } else if (drag_ == Drag::None && isOnRingMiddle(lastAt_)) {
    setCursor(Qt::PointingHandCursor);
  } else {
    setCursor(tool_->cursor(lastAt_));
  }
}

bool MapView::handleViewKey(QKeyEvent* event) {
  const double stepX = kKeyPan * camera_.size().width();
  const double stepY = kKeyPan * camera_.size().height();
  const bool alt = event->modifiers().testFlag(Qt::AltModifier);
  const bool control = event->modifiers().testFlag(Qt::ControlModifier);
  if (control && event->key() != Qt::Key_Home) {
    return false;  // Ctrl with arrows and Page keys means something else in the window
  }
  switch (event->key()) {
    case Qt::Key_Left:
      alt ? goBack() : moveTo(camera_.panned({stepX, 0.0}), Jump::No);
      return true;
    case Qt::Key_Right:
      alt ? goForward() : moveTo(camera_.panned({-stepX, 0.0}), Jump::No);
      return true;
    case Qt::Key_Up:
      moveTo(camera_.panned({0.0, stepY}), Jump::No);
      return true;
    case Qt::Key_Down:
      moveTo(camera_.panned({0.0, -stepY}), Jump::No);
      return true;
    case Qt::Key_PageUp:
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      moveTo(camera_.zoomedAt(camera_.screen().center(), kKeyZoom), Jump::No);
      return true;
    case Qt::Key_PageDown:
    case Qt::Key_Minus:
      moveTo(camera_.zoomedAt(camera_.screen().center(), 1.0 / kKeyZoom), Jump::No);
      return true;
    case Qt::Key_Home:
      if (control) {
        showAll();
      }
      return control;
    default:
      return false;
  }
}

void MapView::keyPressEvent(QKeyEvent* event) {
  leftTools_.clear();
  if (event->key() == Qt::Key_Space) {
    isSpaceHeld_ = true;
    updateCursorShape();
  } else if (event->key() == Qt::Key_Escape) {
    const bool wasDragging = drag_ == Drag::Tool;
    const bool wasCancelled = tool_->cancel();
    drag_ = wasDragging ? Drag::None : drag_;
    if (!wasCancelled && !wasDragging) {
      state_.setPinned(std::nullopt);
    }
    updateCursorShape();
  } else if (tool_->key(event->key())) {
    updateCursorShape();
  } else if (event->key() == Qt::Key_Delete && state_.selectedTarget() >= 0) {
    emit targetRemoveRequested(state_.selectedTarget());
  } else if (event->key() == Qt::Key_Delete && state_.selectedWeather() >= 0) {
    emit weatherRemoveRequested(state_.selectedWeather());
  } else if (!handleViewKey(event)) {
    QWidget::keyPressEvent(event);
  }
}

void MapView::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
    isSpaceHeld_ = false;
    updateCursorShape();
    return;
  }
  QWidget::keyReleaseEvent(event);
}

void MapView::focusOutEvent(QFocusEvent* event) {
  isSpaceHeld_ = false;
  updateCursorShape();
  QWidget::focusOutEvent(event);
}

std::unique_ptr<QMenu> MapView::contextMenuAt(QPointF at) {
  MenuActions actions;
  actions.addTarget = [this](geo::Point place, int before) { askAddTarget(place, before); };
  actions.moveTarget = [this](int target) { moveTarget(target); };
  actions.renameTarget = [this](int target) { emit targetRenameRequested(target); };
  actions.editTarget = [this](int target) { emit targetEditRequested(target); };
  actions.removeTarget = [this](int target) { emit targetRemoveRequested(target); };
  actions.excludeSite = [this](const QString& site, bool exclude) { emit siteExcludeRequested(site, exclude); };
  actions.setHome = [this](const QString& takeoff, const QString& landing) { emit homeRequested(takeoff, landing); };
  actions.setAirspaceUse = [this](const QString& kind, const QString& name, mission::AirspaceUse use) { emit airspaceUseRequested(kind, name, use); };
  actions.editAirspaceRules = [this] { emit airspaceRulesRequested(); };
  actions.editWeather = [this](int cell) { emit weatherEditRequested(cell); };
  actions.removeWeather = [this](int cell) { emit weatherRemoveRequested(cell); };
  actions.engineOut = [this](geo::Point place, std::optional<double> distance) { emit engineOutRequested(place, distance); };
  actions.pin = [this](double distance) { state_.setPinned(distance); };
  actions.zoomTo = [this](const MapObject& /*object*/, geo::Point place) { zoomToObject(camera_.toScreen(place)); };
  actions.measureFrom = [this](geo::Point place) { measureFrom(place); };
  actions.toggleRings = [this](geo::Point place) { toggleRings(place); };
  actions.hasRings = rings_.markAt(camera_, at).has_value();
  actions.centreOn = [this](geo::Point place) { centreOn(place); };
  actions.showAll = [this] { showAll(); };
  return mapMenu(scene(), objectAt(scene(), camera_, at), camera_.toGround(at), actions);
}

void MapView::contextMenuEvent(QContextMenuEvent* event) {
  if (swallowsMenu_ && event->reason() == QContextMenuEvent::Mouse) {
    swallowsMenu_ = false;
    return;
  }
  QPointF at(event->pos());
  if (event->reason() == QContextMenuEvent::Keyboard) {
    const int selected = state_.selectedTarget();
    const auto& targets = scene().situation.targets;
    const bool hasSelected = targets != nullptr && selected >= 0 && selected < static_cast<int>(targets->size());
    at = hasSelected ? camera_.toScreen((*targets)[static_cast<std::size_t>(selected)].point) : camera_.screen().center();
  } else if (const MapObject object = objectAt(scene(), camera_, at); object.kind == MapObject::Kind::Target) {
    state_.selectTarget(object.index);
  }
  QMenu* menu = contextMenuAt(at).release();
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->popup(mapToGlobal(at.toPoint()));
}

}  // namespace vp::map
