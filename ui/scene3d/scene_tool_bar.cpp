#include "ui/scene3d/scene_tool_bar.h"

#include "ui/scene3d/scene_view.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QToolButton>

#include <array>
#include <utility>

namespace vp::scene3d {
namespace {

constexpr std::array kSpeeds{1.0, 2.0, 5.0, 10.0, 20.0, 50.0};
constexpr std::array kHeights{1.0, 1.5, 2.0, 3.0, 5.0};

}  // namespace

SceneToolBar::SceneToolBar(SceneView& view, QWidget* parent) : QToolBar(tr("3D view"), parent), view_(view) {
  setObjectName(QStringLiteral("sceneToolBar"));
  setToolButtonStyle(Qt::ToolButtonTextOnly);
  addPresets();
  addSeparator();
  addFlight();
  addSeparator();
  addOptions();
  showOverflow();
  connect(&view_, &SceneView::flightChanged, this, &SceneToolBar::showState);
  connect(&view_, &SceneView::optionsChanged, this, &SceneToolBar::showState);
  connect(&view_, &SceneView::situationChanged, this, &SceneToolBar::showState);
  showState();
}

void SceneToolBar::addPresets() {
  const std::array entries{std::pair{tr("Top"), tr("From straight above, north up (1)")},
                           std::pair{tr("North"), tr("All of the tour, looking north (2)")},
                           std::pair{tr("Along"), tr("Behind the aircraft, along the tour (3)")},
                           std::pair{tr("Runway"), tr("From the runway, towards where the glide comes from (4)")}};
  for (std::size_t i = 0; i < entries.size(); ++i) {
    QAction* action = addAction(entries[i].first);
    action->setToolTip(entries[i].second);
    action->setStatusTip(entries[i].second);
    connect(action, &QAction::triggered, &view_, [this, i] { view_.showPreset(static_cast<Preset>(i)); });
    presets_.push_back(action);
  }
}

void SceneToolBar::addFlight() {
  follow_ = addAction(tr("Follow"));
  follow_->setCheckable(true);
  follow_->setToolTip(tr("Keep the chosen point of the tour in the middle (F)"));
  connect(follow_, &QAction::triggered, &view_, &SceneView::setFollowing);
  fly_ = addAction(tr("Fly"));
  fly_->setCheckable(true);
  fly_->setToolTip(tr("Fly along the tour; Esc ends it"));
  connect(fly_, &QAction::triggered, &view_, [this](bool isOn) {
    if (isOn) {
      view_.startFlight(flightSpeed_);
    } else {
      view_.stopFlight();
    }
    showState();
  });
  speed_ = addChoice(tr("Speed of the flight, times that of the aircraft"), tr("%1× speed"), {kSpeeds.begin(), kSpeeds.end()}, [this](double factor) {
    flightSpeed_ = factor;
    if (view_.isFlying()) {
      view_.startFlight(factor);
    }
    showState();
  });
}

void SceneToolBar::addOptions() {
  curtain_ = addAction(tr("Curtain"));
  curtain_->setCheckable(true);
  curtain_->setToolTip(tr("Surface between the tour and the ground, coloured by altitude"));
  connect(curtain_, &QAction::triggered, this, [this](bool isOn) { changeOptions([isOn](SceneOptions& o) { o.curtain = isOn; }); });
  allGlides_ = addAction(tr("All glides"));
  allGlides_->setCheckable(true);
  allGlides_->setToolTip(tr("The glide of every decision point, coloured by altitude"));
  connect(allGlides_, &QAction::triggered, this, [this](bool isOn) { changeOptions([isOn](SceneOptions& o) { o.allGlides = isOn; }); });
  heights_ = addChoice(tr("How much larger heights are drawn than distances"), tr("Heights %1×"), {kHeights.begin(), kHeights.end()},
                       [this](double factor) { changeOptions([factor](SceneOptions& o) { o.verticalExaggeration = factor; }); });
}

QAction* SceneToolBar::addChoice(const QString& tip, const QString& text, const std::vector<double>& factors,
                                 const std::function<void(double)>& choose) {
  QAction* action = addAction(text);
  action->setToolTip(tip);
  auto* menu = new QMenu(this);
  auto* group = new QActionGroup(menu);
  for (const double factor : factors) {
    QAction* entry = menu->addAction(text.arg(factor));
    entry->setCheckable(true);
    entry->setData(factor);
    group->addAction(entry);
    connect(entry, &QAction::triggered, this, [choose, factor] { choose(factor); });
  }
  action->setMenu(menu);
  if (auto* button = qobject_cast<QToolButton*>(widgetForAction(action))) {
    button->setPopupMode(QToolButton::InstantPopup);
    button->setAccessibleName(tip);
  }
  return action;
}

void SceneToolBar::showChoice(QAction* action, double factor) {
  for (QAction* entry : action->menu()->actions()) {
    entry->setChecked(entry->data().toDouble() == factor);
    if (entry->isChecked()) {
      action->setText(entry->text());
    }
  }
}

void SceneToolBar::showOverflow() {
  auto* more = findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
  if (more != nullptr) {
    // a dozen pixels wide: with the padding of other buttons nothing of its arrows is left; these are black in every theme
    more->setStyleSheet(QStringLiteral("QToolButton { padding: 0px; margin: 0px; border: none; background: #9AA3AE; }"));
    more->setToolTip(tr("More"));
    more->setAccessibleName(tr("More of the 3D view's controls"));
  }
}

void SceneToolBar::changeOptions(const std::function<void(SceneOptions&)>& change) {
  SceneOptions options = view_.options();
  change(options);
  view_.setOptions(options);
}

void SceneToolBar::showState() {
  const bool hasPlan = view_.situation().plan != nullptr;
  presets_[static_cast<std::size_t>(Preset::AlongTour)]->setEnabled(hasPlan);
  follow_->setEnabled(hasPlan);
  follow_->setChecked(view_.isFollowing());
  fly_->setEnabled(hasPlan);
  fly_->setChecked(view_.isFlying());
  fly_->setText(view_.isFlying() ? tr("Stop") : tr("Fly"));
  speed_->setEnabled(hasPlan);
  curtain_->setChecked(view_.options().curtain);
  allGlides_->setChecked(view_.options().allGlides);
  showChoice(speed_, flightSpeed_);
  showChoice(heights_, view_.options().verticalExaggeration);
}

}  // namespace vp::scene3d
