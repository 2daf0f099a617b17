#include "app/gui/status_line.h"

#include "ui/profile/plot_text.h"
#include "ui/profile/tour_curves.h"
#include "ui/style/icons.h"

#include <QLabel>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>

#include <cmath>

namespace vp::gui {
namespace {
constexpr int kProgressSteps = 1000;
constexpr int kProgressWidth = 180;
}  // namespace

StatusLine::StatusLine(jobs::Workspace& workspace, QStatusBar& bar) : QObject(&bar), workspace_(workspace) {
  message_ = new QLabel;
  message_->setObjectName(QStringLiteral("statusMessage"));
  progress_ = new QProgressBar;
  progress_->setRange(0, kProgressSteps);
  progress_->setFixedWidth(kProgressWidth);
  progress_->setTextVisible(false);
  progress_->setAccessibleName(tr("Progress"));
  cancel_ = new QToolButton;
  cancel_->setObjectName(QStringLiteral("cancelButton"));
  cancel_->setToolTip(tr("Stop planning (Esc)"));
  cancel_->setAccessibleName(tr("Stop planning"));
  place_ = new QLabel;
  place_->setObjectName(QStringLiteral("statusPlace"));
  place_->setAccessibleName(tr("Place under the pointer"));
  bar.addWidget(progress_);
  bar.addWidget(cancel_);
  bar.addWidget(message_, 1);
  leastMargin_ = addLeast(bar, "statusLeastMargin", tr("Where the tour has the least height above what its glide needs; a click shows the place"));
  leastClearance_ = addLeast(bar, "statusLeastClearance", tr("Where the tour is lowest above the ground; a click shows the place"));
  bar.addPermanentWidget(place_);
  connect(leastMargin_, &QToolButton::clicked, this, [this] { showTourPlace(&document::PlanView::leastGlideMargin); });
  connect(leastClearance_, &QToolButton::clicked, this, [this] { showTourPlace(&document::PlanView::leastClearance); });
  connect(&workspace_, &jobs::Workspace::situationChanged, this, &StatusLine::showLeast);
  connect(cancel_, &QToolButton::clicked, this, &StatusLine::cancelRequested);
  connect(&workspace_, &jobs::Workspace::activityChanged, this, &StatusLine::showActivity);
  connect(&workspace_, &jobs::Workspace::progressed, this, &StatusLine::showProgress);
  connect(&workspace_.view(), &document::ViewState::unitsChanged, this, [this] {
    showPlace(shown_);
    showLeast();
  });
  refreshTheme();
  showActivity();
  showLeast();
}

QToolButton* StatusLine::addLeast(QStatusBar& bar, const char* name, const QString& tip) {
  auto* button = new QToolButton;
  button->setObjectName(QLatin1String(name));
  button->setToolTip(tip);
  button->setAccessibleDescription(tip);
  button->setAutoRaise(true);
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  button->setFocusPolicy(Qt::TabFocus);
  button->setFont(profile::tabularFont(button->font()));
  bar.addPermanentWidget(button);
  return button;
}

void StatusLine::showTourPlace(const document::TourSample& (document::PlanView::*which)() const) {
  if (const auto& plan = workspace_.situation().plan) {
    const document::TourState& state = (plan.get()->*which)().state;
    workspace_.view().setPinned(state.distance);
    workspace_.view().showPlace(state.pose.point());
  }
}

void StatusLine::showLeast() {
  const document::Situation& situation = workspace_.situation();
  const document::PlanView* plan = situation.plan.get();
  leastMargin_->setVisible(plan != nullptr);
  leastClearance_->setVisible(plan != nullptr);
  if (plan == nullptr) {
    return;
  }
  const style::Units& units = workspace_.view().units();
  const document::TourState& margin = plan->leastGlideMargin().state;
  const document::TourState& clearance = plan->leastClearance().state;
  const QString suffix = situation.planIsCurrent ? QString() : tr(" (old plan)");
  leastMargin_->setText(
      tr("Least glide margin %1 at %2").arg(units.margin(profile::shownMargin(margin.glideMargin())), units.distance(margin.distance)) + suffix);
  leastClearance_->setText(tr("Least clearance %1 at %2").arg(units.heightAboveGround(clearance.clearance()), units.distance(clearance.distance)) +
                           suffix);
  leastMargin_->setAccessibleName(leastMargin_->text());
  leastClearance_->setAccessibleName(leastClearance_->text());
}

void StatusLine::showWork(const QString& text) {
  if (workspace_.activity() == jobs::Workspace::Activity::Idle) {
    message_->setText(text);
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
    message_->clear();
    progress_->setValue(0);
  }
}

void StatusLine::showProgress(double fraction, const QString& text) {
  progress_->setValue(static_cast<int>(std::lround(fraction * kProgressSteps)));
  message_->setText(text);
}

void StatusLine::showPlace(std::optional<geo::LatLon> place) {
  shown_ = place;
  const auto& terrain = workspace_.situation().terrain;
  if (!place) {
    place_->clear();
    return;
  }
  const style::Units& units = workspace_.view().units();
  QString text = style::Units::position(*place);
  if (terrain) {
    const geo::Point point = terrain->frame.toPoint(*place);
    const double ground = terrain->grid->upperAt(point);
    text += QStringLiteral("   ") + (std::isfinite(ground) ? tr("Ground %1").arg(units.altitudeMsl(ground)) : tr("Ground unknown"));
    if (const std::optional<double> safe = workspace_.safeAltitudeAt(point); safe && std::isfinite(*safe)) {
      text += QStringLiteral("   ") + tr("Lowest safe %1").arg(units.requiredMsl(*safe));
    }
  }
  place_->setText(text);
}

}  // namespace vp::gui
