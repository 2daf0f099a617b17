#include "app/gui/status_line.h"

#include "core/geo/magnetic_field.h"
#include "ui/profile/plot_text.h"
#include "ui/profile/tour_curves.h"
#include "ui/style/icons.h"

#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::gui {
namespace {

constexpr int kProgressSteps = 1000;
constexpr int kProgressWidth = 180;
constexpr int kGrip = 30;          // px: grip of the window and the margins of the bar
constexpr int kPadding = 18;       // px about each text
constexpr int kMessageRoom = 150;  // px that a message has at least
constexpr double kHighest = 9999.0;

QString join(const QStringList& parts) {
  return parts.join(QStringLiteral("   "));
}

/// Magnetic, of today; nothing where a compass is of no use.
std::optional<QString> variationAt(geo::LatLon place) {
  const geo::MagneticField field = geo::magneticField(place, geo::HeightMsl::fromMetres(0.0), geo::decimalYear(geo::today()));
  return field.movesACompass() ? std::optional(style::Units::variation(field.variation().degrees())) : std::nullopt;
}

}  // namespace

StatusLine::StatusLine(jobs::Workspace& workspace, QStatusBar& bar) : QObject(&bar), workspace_(workspace), bar_(bar) {
  message_ = new QLabel;
  message_->setObjectName(QStringLiteral("statusMessage"));
  message_->setMinimumWidth(1);
  progress_ = new QProgressBar;
  progress_->setRange(0, kProgressSteps);
  progress_->setFixedWidth(kProgressWidth);
  progress_->setTextVisible(false);
  progress_->setAccessibleName(tr("Progress"));
  cancel_ = new QToolButton;
  cancel_->setObjectName(QStringLiteral("cancelButton"));
  cancel_->setToolTip(tr("Stop planning (Esc)"));
  cancel_->setAccessibleName(tr("Stop planning"));
  bar.addWidget(progress_);
  bar.addWidget(cancel_);
  bar.addWidget(message_, 1);
  leastMargin_ = addLeast("statusLeastMargin", tr("Where the tour has the least height above what its glide needs; a click shows the place"));
  leastClearance_ = addLeast("statusLeastClearance", tr("Where the tour is lowest above the ground; a click shows the place"));
  mapWidth_ = addLabel("statusMapWidth", tr("Ground that the map shows from left to right"));
  place_ = addLabel("statusPlace", tr("Place under the pointer"));
  connect(leastMargin_, &QToolButton::clicked, this, [this] { showTourPlace(&document::PlanView::leastGlideMargin); });
  connect(leastClearance_, &QToolButton::clicked, this, [this] { showTourPlace(&document::PlanView::leastClearance); });
  connect(cancel_, &QToolButton::clicked, this, &StatusLine::cancelRequested);
  connect(&workspace_, &jobs::Workspace::situationChanged, this, &StatusLine::fit);
  connect(&workspace_, &jobs::Workspace::activityChanged, this, &StatusLine::showActivity);
  connect(&workspace_, &jobs::Workspace::progressed, this, [this](double fraction, const QString& text) {
    progress_->setValue(static_cast<int>(std::lround(fraction * kProgressSteps)));
    showMessage(text);
  });
  connect(&workspace_.view(), &document::ViewState::unitsChanged, this, &StatusLine::fit);
  bar.installEventFilter(this);
  refreshTheme();
  showActivity();
}

QToolButton* StatusLine::addLeast(const char* name, const QString& tip) {
  auto* button = new QToolButton;
  button->setObjectName(QLatin1String(name));
  button->setToolTip(tip);
  button->setAccessibleDescription(tip);
  button->setAutoRaise(true);
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  button->setFocusPolicy(Qt::TabFocus);
  button->setFont(profile::tabularFont(button->font()));
  bar_.addPermanentWidget(button);
  return button;
}

QLabel* StatusLine::addLabel(const char* name, const QString& accessibleName) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(name));
  label->setAccessibleName(accessibleName);
  label->setFont(profile::tabularFont(label->font()));
  label->setMinimumWidth(1);
  bar_.addPermanentWidget(label);
  return label;
}

void StatusLine::showTourPlace(const document::TourSample& (document::PlanView::*which)() const) {
  if (const auto& plan = workspace_.situation().plan) {
    const document::TourState& state = (plan.get()->*which)().state;
    workspace_.view().setPinned(state.distance);
    workspace_.view().showPlace(state.pose.point());
  }
}

QString StatusLine::marginText(Shortened shortened) const {
  const document::Situation& situation = workspace_.situation();
  const style::Units& units = workspace_.view().units();
  const document::TourState& least = situation.plan->leastGlideMargin().state;
  const QString value = units.margin(profile::shownMargin(least.glideMargin()));
  const QString text = shortened < Shortened::PlacesOfLeast ? tr("Least glide margin %1 at %2").arg(value, units.distance(least.distance))
                                                            : tr("Margin %1").arg(value);
  return situation.planIsCurrent ? text : text + tr(" (old plan)");
}

QString StatusLine::clearanceText(Shortened shortened) const {
  const document::Situation& situation = workspace_.situation();
  const style::Units& units = workspace_.view().units();
  const document::TourState& least = situation.plan->leastClearance().state;
  const QString value = units.heightAboveGround(least.clearance());
  const QString text = shortened < Shortened::PlacesOfLeast ? tr("Least clearance %1 at %2").arg(value, units.distance(least.distance))
                                                            : tr("Clearance %1").arg(value);
  return situation.planIsCurrent ? text : text + tr(" (old plan)");
}

QString StatusLine::placeText(Shortened shortened) const {
  if (!shown_) {
    return {};
  }
  const style::Units& units = workspace_.view().units();
  QStringList parts{style::Units::position(*shown_)};
  if (const auto& terrain = workspace_.situation().terrain) {
    const geo::Point point = terrain->frame.toPoint(*shown_);
    const double ground = terrain->grid->upperAt(point);
    parts << (std::isfinite(ground) ? tr("Ground %1").arg(units.altitudeMsl(ground)) : tr("Ground unknown"));
    if (const std::optional<double> safe = workspace_.safeAltitudeAt(point); safe && std::isfinite(*safe)) {
      parts << tr("Lowest safe %1").arg(units.requiredMsl(*safe));
    }
  }
  if (shortened < Shortened::Variation) {
    const std::optional<QString> variation = variationAt(*shown_);
    parts << (variation ? tr("Var %1").arg(*variation) : tr("No compass here"));
  }
  return join(parts);
}

/// With the longest texts that the pointer may call for, so that nothing jumps while it moves.
int StatusLine::neededWidth(Shortened shortened) const {
  const QFontMetrics metrics(place_->font());
  const style::Units& units = workspace_.view().units();
  QStringList place{QStringLiteral("88°88.88′ N  888°88.88′ W"), tr("Ground %1").arg(units.altitudeMsl(kHighest)),
                    tr("Lowest safe %1").arg(units.requiredMsl(kHighest))};
  if (shortened < Shortened::Variation) {
    place << tr("Var %1").arg(style::Units::variation(-88.8));
  }
  int width = metrics.horizontalAdvance(join(place)) + kPadding;
  if (shortened < Shortened::MapWidth) {
    width += metrics.horizontalAdvance(tr("Map %1 wide").arg(units.distance(units.distanceToSi(88.8)))) + kPadding;
  }
  if (workspace_.situation().plan != nullptr && shortened < Shortened::Least) {
    width += metrics.horizontalAdvance(marginText(shortened)) + metrics.horizontalAdvance(clearanceText(shortened)) + 2 * kPadding;
  }
  return width;
}

int StatusLine::roomForAll() const {
  int room = bar_.width() - kGrip;
  room -= progress_->isHidden() ? 0 : kProgressWidth + kPadding;
  room -= cancel_->isHidden() ? 0 : cancel_->sizeHint().width() + kPadding;
  return room;
}

void StatusLine::fit() {
  const int room = roomForAll();
  const int forMessage = messageText_.isEmpty() ? 0 : kMessageRoom;
  Shortened shortened = Shortened::Nothing;
  for (const Shortened next : {Shortened::PlacesOfLeast, Shortened::MapWidth, Shortened::Variation, Shortened::Least}) {
    shortened = neededWidth(shortened) + forMessage > room ? next : shortened;
  }
  const bool hasLeast = workspace_.situation().plan != nullptr && shortened < Shortened::Least;
  leastMargin_->setVisible(hasLeast);
  leastClearance_->setVisible(hasLeast);
  if (hasLeast) {
    leastMargin_->setText(marginText(shortened));
    leastClearance_->setText(clearanceText(shortened));
    leastMargin_->setAccessibleName(marginText(Shortened::Nothing));
    leastClearance_->setAccessibleName(clearanceText(Shortened::Nothing));
  }
  const style::Units& units = workspace_.view().units();
  mapWidth_->setVisible(shortened < Shortened::MapWidth && shownWidth_ > 0.0 && workspace_.situation().terrain != nullptr);
  mapWidth_->setText(tr("Map %1 wide").arg(units.distance(shownWidth_)));
  const QFontMetrics metrics(place_->font());
  place_->setText(metrics.elidedText(placeText(shortened), Qt::ElideRight, std::max(0, room - forMessage - kPadding)));
  const int left = std::max(kMessageRoom, room - neededWidth(shortened)) - kPadding;
  message_->setText(message_->fontMetrics().elidedText(messageText_, Qt::ElideMiddle, left));
  message_->setToolTip(message_->text() == messageText_ ? QString() : messageText_);
}

bool StatusLine::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &bar_ && event->type() == QEvent::Resize) {
    fit();
  }
  return QObject::eventFilter(watched, event);
}

void StatusLine::showMessage(const QString& text) {
  messageText_ = text;
  fit();
}

void StatusLine::showWork(const QString& text) {
  if (workspace_.activity() == jobs::Workspace::Activity::Idle) {
    showMessage(text);
  }
}

void StatusLine::refreshTheme() {
  cancel_->setIcon(style::icon(QStringLiteral("stop"), workspace_.view().theme()));
}

void StatusLine::showActivity() {
  using Activity = jobs::Workspace::Activity;
  const Activity activity = workspace_.activity();
  progress_->setVisible(activity != Activity::Idle);
  cancel_->setVisible(activity == Activity::Planning);
  if (activity == Activity::Idle) {
    progress_->setValue(0);
    messageText_.clear();
  }
  fit();
}

void StatusLine::showPlace(std::optional<geo::LatLon> place) {
  shown_ = place;
  fit();
}

void StatusLine::showMapWidth(double metres) {
  shownWidth_ = metres;
  fit();
}

}  // namespace vp::gui
