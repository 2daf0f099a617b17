#include "ui/profile/profile_view.h"

#include "ui/profile/wind_lane.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace vp::profile {
namespace {

constexpr double kLeastWidth = 200.0;   // m, deepest zoom
constexpr double kLeastHeight = 30.0;   // m
constexpr double kWheelNotch = 120.0;   // eighths of a degree, Qt
constexpr double kZoomPerNotch = 1.25;  // factor

/// Moves [from, from + width] into [low, high] without changing its width unless it is wider.
void fit(double& from, double& to, double low, double high) {
  const double width = std::min(to - from, high - low);
  from = std::clamp(from, low, high - width);
  to = from + width;
}

}  // namespace

ProfileView::ProfileView(document::ViewState& state, QWidget* parent) : QWidget(parent), state_(state) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAccessibleName(tr("Altitude profile of the tour"));
  connect(&state_, &document::ViewState::cursorChanged, this, &ProfileView::followCursor);
  connect(&state_, &document::ViewState::unitsChanged, this, &ProfileView::invalidate);
  connect(&state_, &document::ViewState::themeChanged, this, &ProfileView::invalidate);
  describe();
}

ProfileView::~ProfileView() = default;

void ProfileView::setSituation(const document::Situation& situation) {
  const bool changed = situation.plan != situation_.plan || situation.planIsCurrent != situation_.planIsCurrent ||
                       (situation.plan == nullptr && (situation.terrain != situation_.terrain || situation.targets != situation_.targets ||
                                                      (situation.sketch == nullptr) != (situation_.sketch == nullptr)));
  const bool sameTour = situation.plan != nullptr && situation_.plan != nullptr && situation.plan->length() == situation_.plan->length();
  if (!sameTour) {
    window_.reset();
    drag_.reset();
  }
  situation_ = situation;
  if (changed) {
    invalidate();
  }
}

ProfileStyle ProfileView::profileStyle() const {
  return {state_.theme(), state_.units(), font()};
}

const ProfileRenderer* ProfileView::renderer() const {
  if (renderer_ == nullptr && situation_.plan != nullptr) {
    renderer_ = std::make_unique<ProfileRenderer>(situation_, profileStyle(), QSizeF(size()), window_);
  }
  return renderer_.get();
}

void ProfileView::invalidate() {
  renderer_.reset();
  picture_ = QPixmap();
  describe();
  update();
}

PlotWindow ProfileView::window() const {
  return window_ || situation_.plan == nullptr ? window_.value_or(PlotWindow()) : ProfileRenderer::fullWindow(*situation_.plan);
}

void ProfileView::setWindow(const PlotWindow& window) {
  if (situation_.plan == nullptr) {
    return;
  }
  const PlotWindow full = ProfileRenderer::fullWindow(*situation_.plan);
  PlotWindow fitted = window;
  fit(fitted.from, fitted.to, full.from, full.to);
  fit(fitted.low, fitted.high, full.low, full.high);
  if (fitted != this->window()) {
    window_ = fitted;
    invalidate();
  }
}

void ProfileView::showAll() {
  window_.reset();
  invalidate();
}

void ProfileView::zoomDistance(double factor, double at) {
  PlotWindow shown = window();
  const double width = std::max(shown.width() / factor, std::min(kLeastWidth, shown.width()));
  const double share = (at - shown.from) / shown.width();
  shown.from = at - share * width;
  shown.to = shown.from + width;
  setWindow(shown);
}

void ProfileView::zoomAltitude(double factor, double at) {
  PlotWindow shown = window();
  const double height = std::max(shown.height() / factor, std::min(kLeastHeight, shown.height()));
  const double share = (at - shown.low) / shown.height();
  shown.low = at - share * height;
  shown.high = shown.low + height;
  setWindow(shown);
}

void ProfileView::panBy(double distance, double altitude) {
  PlotWindow shown = window();
  shown.from += distance;
  shown.to += distance;
  shown.low += altitude;
  shown.high += altitude;
  setWindow(shown);
}

void ProfileView::reveal(double distance) {
  const PlotWindow shown = window();
  if (distance < shown.from || distance > shown.to) {
    panBy(distance - 0.5 * (shown.from + shown.to), 0.0);
  }
}

void ProfileView::pin(double distance) {
  reveal(distance);
  state_.setPinned(distance);
}

void ProfileView::followCursor() {
  describe();
  update();
}

void ProfileView::describe() {
  QStringList parts;
  if (const ProfileRenderer* drawn = renderer()) {
    for (const ProfileFact& fact : drawn->facts()) {
      parts << fact.text;
    }
    if (const std::optional<double> pinned = state_.pinned()) {
      for (const HoverRow& row : hoverRows(*pinned)) {
        parts << row.name + QLatin1Char(' ') + row.value;
      }
    }
  } else {
    parts << emptyProfileText(situation_);
  }
  setAccessibleDescription(parts.join(QStringLiteral(". ")));
}

std::vector<HoverRow> ProfileView::hoverRows(double distance) const {
  const document::PlanView& plan = *situation_.plan;
  const document::TourState state = plan.at(distance);
  const style::Units& units = state_.units();
  const bool known = std::isfinite(state.ground);
  std::vector<HoverRow> rows{
      {tr("Distance"), tr("%1 of %2").arg(units.distance(state.distance), units.distance(plan.length()))},
      {tr("Altitude"), units.altitudeMsl(state.altitude)},
      {tr("Above ground"), known ? units.heightAboveGround(state.clearance()) : tr("unknown"), !known},
      {tr("Ground"), known ? units.requiredMsl(state.ground) : tr("unknown"), !known},
  };
  const bool glides = std::isfinite(state.safeAltitude);
  rows.push_back({tr("Safe altitude"), glides ? units.requiredMsl(state.safeAltitude) : tr("none known"), !glides});
  rows.push_back(
      {tr("Glide margin"), glides ? units.margin(shownMargin(state.glideMargin())) : tr("no glide"), !glides || state.glideMargin() < -1e-3});
  if (const int site = glideSite(plan, state); site >= 0) {
    rows.push_back({tr("Glide to"), runwayNameLong(plan.plan().sites[static_cast<std::size_t>(site)].site)});
  }
  if (const std::optional<CourseWind> wind = courseWind(plan, state)) {
    rows.push_back({tr("Wind"), courseWindText(plan, *wind, units)});
  }
  const auto point = static_cast<std::size_t>(state.point);
  const int target = plan.plan().tour[point].target;
  if (target >= 0 && std::abs(plan.distanceOf(point) - state.distance) < 0.5 * document::PlanView::kSampleStep) {
    rows.push_back({tr("Target"), QString::fromStdString(plan.plan().targets[static_cast<std::size_t>(target)].target.name)});
  }
  return rows;
}

void ProfileView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const ProfileRenderer* drawn = renderer();
  if (drawn == nullptr) {
    paintEmptyProfile(painter, rect(), situation_, profileStyle());
    return;
  }
  const double dpr = devicePixelRatioF();
  if (picture_.isNull() || picture_.devicePixelRatio() != dpr) {
    picture_ = QPixmap((QSizeF(size()) * dpr).toSize());
    picture_.setDevicePixelRatio(dpr);
    QPainter buffer(&picture_);
    drawn->paint(buffer);
  }
  painter.drawPixmap(0, 0, picture_);
  if (state_.pinned()) {
    drawn->paintCursor(painter, *state_.pinned(), Cursor::Pinned);
  }
  if (state_.hovered()) {
    drawn->paintCursor(painter, *state_.hovered(), Cursor::Hovered);
    const double x = drawn->scale().xOf(*state_.hovered());
    if (x >= drawn->frame().left() - 0.5 && x <= drawn->frame().right() + 0.5) {
      paintHoverBox(painter, hoverRows(*state_.hovered()), x, drawn->frame().adjusted(4.0, 4.0, -4.0, -2.0), profileStyle());
    }
  }
  if (hasFocus()) {
    painter.setPen(QPen(profileStyle().colors().selection, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

void ProfileView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  invalidate();
}

void ProfileView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::LanguageChange) {
    invalidate();
  }
}

void ProfileView::wheelEvent(QWheelEvent* event) {
  const ProfileRenderer* drawn = renderer();
  // some platforms turn Shift+wheel into a horizontal wheel
  const double notches = (event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x()) / kWheelNotch;
  if (drawn == nullptr || notches == 0.0) {
    event->ignore();
    return;
  }
  const PlotScale scale = drawn->scale();
  const double factor = std::pow(kZoomPerNotch, notches);
  if (event->modifiers().testFlag(Qt::ShiftModifier)) {
    zoomAltitude(factor, scale.altitudeAt(std::clamp(event->position().y(), scale.area().top(), scale.area().bottom())));
  } else {
    zoomDistance(factor, scale.distanceAt(std::clamp(event->position().x(), scale.area().left(), scale.area().right())));
  }
  event->accept();
}

const ProfileFact* ProfileView::factAt(QPointF position) const {
  if (const ProfileRenderer* drawn = renderer()) {
    for (const ProfileFact& fact : drawn->facts()) {
      if (fact.rect.contains(position)) {
        return &fact;
      }
    }
  }
  return nullptr;
}

void ProfileView::mousePressEvent(QMouseEvent* event) {
  const ProfileRenderer* drawn = renderer();
  if (drawn == nullptr || (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton)) {
    QWidget::mousePressEvent(event);
    return;
  }
  if (const ProfileFact* fact = factAt(event->position()); fact != nullptr && event->button() == Qt::LeftButton) {
    const double distance = fact->distance;  // pinning redraws, and the fact with it
    pin(distance);
    state_.showPlace(situation_.plan->at(distance).pose.point());
  } else if (drawn->frame().contains(event->position())) {
    drag_ = Drag{event->position(), window()};
  }
}

void ProfileView::mouseMoveEvent(QMouseEvent* event) {
  const ProfileRenderer* drawn = renderer();
  if (drawn == nullptr) {
    return;
  }
  const QPointF position = event->position();
  if (drag_) {
    drag_->moved = drag_->moved || (position - drag_->start).manhattanLength() >= QApplication::startDragDistance();
    if (drag_->moved) {
      state_.setHovered(std::nullopt);
      setCursor(Qt::ClosedHandCursor);
      const QRectF area = drawn->scale().area();
      PlotWindow moved = drag_->window;
      const double dx = (position.x() - drag_->start.x()) / area.width() * moved.width();
      const double dy = (position.y() - drag_->start.y()) / area.height() * moved.height();
      setWindow({moved.from - dx, moved.to - dx, moved.low + dy, moved.high + dy});
    }
    return;
  }
  const bool onFact = factAt(position) != nullptr;
  const bool inside = drawn->frame().contains(position);
  setCursor(onFact ? Qt::PointingHandCursor : inside ? Qt::CrossCursor : Qt::ArrowCursor);
  state_.setHovered(inside ? std::optional(std::clamp(drawn->scale().distanceAt(position.x()), 0.0, situation_.plan->length())) : std::nullopt);
}

void ProfileView::mouseReleaseEvent(QMouseEvent* event) {
  if (drag_ && !drag_->moved && event->button() == Qt::LeftButton && renderer() != nullptr) {
    pin(std::clamp(renderer()->scale().distanceAt(event->position().x()), 0.0, situation_.plan->length()));
  }
  drag_.reset();
  unsetCursor();
}

void ProfileView::mouseDoubleClickEvent(QMouseEvent* event) {
  const ProfileRenderer* drawn = renderer();
  if (drawn != nullptr && event->button() == Qt::LeftButton && drawn->frame().contains(event->position())) {
    state_.showPlace(situation_.plan->at(drawn->scale().distanceAt(event->position().x())).pose.point());
  }
}

void ProfileView::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  if (situation_.plan != nullptr) {
    state_.setHovered(std::nullopt);
  }
}

void ProfileView::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  update();
}

void ProfileView::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  update();
}

}  // namespace vp::profile
