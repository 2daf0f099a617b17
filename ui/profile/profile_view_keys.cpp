// The profile by keyboard.
#include "ui/profile/profile_view.h"

#include <QKeyEvent>

namespace vp::profile {
namespace {

constexpr double kZoomPerKey = 1.25;  // factor
constexpr double kPanStep = 0.1;      // of the shown part

}  // namespace

void ProfileView::pinPoint(std::size_t point) {
  pin(situation_.plan->distanceOf(point));
}

void ProfileView::stepPinned(int by) {
  const auto count = static_cast<int>(situation_.plan->plan().tour.size());
  const std::optional<double> from = state_.pinned() ? state_.pinned() : state_.hovered();
  if (!from) {
    pinPoint(by > 0 ? 0 : static_cast<std::size_t>(count - 1));
    return;
  }
  const document::TourState state = situation_.plan->at(*from);
  const bool between = state.distance > situation_.plan->distanceOf(static_cast<std::size_t>(state.point));
  const int next = state.point + (by > 0 ? 1 : between ? 0 : -1);  // back from between two points: to the one last passed
  pinPoint(static_cast<std::size_t>((next + count) % count));
}

bool ProfileView::zoomByKey(int key) {
  const PlotWindow shown = window();
  const double distance = state_.position().value_or(0.5 * (shown.from + shown.to));
  const double at = distance >= shown.from && distance <= shown.to ? distance : 0.5 * (shown.from + shown.to);
  switch (key) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      zoomDistance(kZoomPerKey, at);
      return true;
    case Qt::Key_Minus:
      zoomDistance(1.0 / kZoomPerKey, at);
      return true;
    case Qt::Key_Asterisk:
      zoomAltitude(kZoomPerKey, 0.5 * (shown.low + shown.high));
      return true;
    case Qt::Key_Slash:
      zoomAltitude(1.0 / kZoomPerKey, 0.5 * (shown.low + shown.high));
      return true;
    case Qt::Key_0:
    case Qt::Key_Insert:
      showAll();
      return true;
    case Qt::Key_PageUp:
      panBy(-shown.width() * 0.5, 0.0);
      return true;
    case Qt::Key_PageDown:
      panBy(shown.width() * 0.5, 0.0);
      return true;
    case Qt::Key_Up:
      panBy(0.0, shown.height() * kPanStep);
      return true;
    case Qt::Key_Down:
      panBy(0.0, -shown.height() * kPanStep);
      return true;
    default:
      return false;
  }
}

void ProfileView::keyPressEvent(QKeyEvent* event) {
  if (situation_.plan == nullptr) {
    QWidget::keyPressEvent(event);
    return;
  }
  switch (event->key()) {
    case Qt::Key_Left:
      stepPinned(-1);
      break;
    case Qt::Key_Right:
      stepPinned(1);
      break;
    case Qt::Key_Home:
      pinPoint(0);
      break;
    case Qt::Key_End:
      pinPoint(situation_.plan->plan().tour.size() - 1);
      break;
    default:
      if (!zoomByKey(event->key())) {
        QWidget::keyPressEvent(event);
      }
      break;
  }
}

}  // namespace vp::profile
