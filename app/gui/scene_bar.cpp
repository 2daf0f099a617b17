#include "app/gui/scene_bar.h"

#include "ui/scene3d/scene_view.h"
#include "ui/style/icons.h"

#include <QComboBox>
#include <QMenu>
#include <QToolButton>

namespace vp::gui {

using scene3d::Preset;

SceneBar::SceneBar(scene3d::SceneView& view, QWidget* parent) : QToolBar(parent), view_(view) {
  setIconSize(QSize(18, 18));
  setAccessibleName(tr("3D view"));
  addPresets();
  addSeparator();
  addFlight();
  addSeparator();
  addOptions();
  connect(&view_, &scene3d::SceneView::flightChanged, this, &SceneBar::refresh);
  refresh();
}

void SceneBar::addPresets() {
  auto* menu = new QMenu(this);
  const auto addPreset = [&](const QString& text, Preset preset) {
    connect(menu->addAction(text), &QAction::triggered, this, [this, preset] { view_.showPreset(preset); });
  };
  addPreset(tr("&Top\t1"), Preset::Top);
  addPreset(tr("Facing &north\t2"), Preset::North);
  addPreset(tr("&Along the tour\t3"), Preset::AlongTour);
  addPreset(tr("From the &runway\t4"), Preset::FromRunway);
  connect(menu->addAction(tr("&Home\tSpace")), &QAction::triggered, &view_, &scene3d::SceneView::goHome);
  QAction* made = menu->menuAction();
  made->setText(tr("Views"));
  made->setToolTip(tr("Fixed views"));
  icons_.emplace_back(made, QStringLiteral("scene"));
  addAction(made);
  if (auto* button = qobject_cast<QToolButton*>(widgetForAction(made))) {
    button->setPopupMode(QToolButton::InstantPopup);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }
}

void SceneBar::addFlight() {
  fly_ = addAction(tr("Fly along the tour"));
  fly_->setObjectName(QStringLiteral("sceneFly"));
  fly_->setCheckable(true);
  icons_.emplace_back(fly_, QStringLiteral("play"));
  connect(fly_, &QAction::triggered, this, [this](bool on) { on ? view_.startFlight(speed_->currentData().toDouble()) : view_.stopFlight(); });
  speed_ = new QComboBox(this);
  speed_->setAccessibleName(tr("Speed of the flight"));
  speed_->setToolTip(tr("Speed of the flight, times that of the aircraft"));
  for (const int factor : {1, 5, 20, 60}) {
    speed_->addItem(tr("%1 ×").arg(factor), static_cast<double>(factor));
  }
  speed_->setCurrentIndex(2);
  connect(speed_, &QComboBox::currentIndexChanged, this, [this] {
    if (view_.isFlying()) {
      view_.startFlight(speed_->currentData().toDouble());
    }
  });
  addWidget(speed_);
  follow_ = addAction(tr("Follow the point on the tour"));
  follow_->setCheckable(true);
  icons_.emplace_back(follow_, QStringLiteral("follow"));
  connect(follow_, &QAction::triggered, &view_, &scene3d::SceneView::setFollowing);
}

void SceneBar::addOptions() {
  exaggeration_ = new QComboBox(this);
  exaggeration_->setAccessibleName(tr("Vertical exaggeration"));
  exaggeration_->setToolTip(tr("Heights drawn so many times larger"));
  for (const double factor : {1.0, 1.5, 2.0, 3.0, 5.0}) {
    exaggeration_->addItem(tr("Heights %1 ×").arg(factor), factor);
  }
  connect(exaggeration_, &QComboBox::currentIndexChanged, this, [this] {
    scene3d::SceneOptions options = view_.options();
    options.verticalExaggeration = exaggeration_->currentData().toDouble();
    view_.setOptions(options);
  });
  addWidget(exaggeration_);
  auto* menu = new QMenu(this);
  const auto addFlag = [&](const QString& text, bool scene3d::SceneOptions::*flag) {
    QAction* made = menu->addAction(text);
    made->setCheckable(true);
    made->setChecked(view_.options().*flag);
    connect(made, &QAction::toggled, this, [this, flag](bool on) {
      scene3d::SceneOptions options = view_.options();
      options.*flag = on;
      view_.setOptions(options);
    });
  };
  addFlag(tr("&Curtain below the tour"), &scene3d::SceneOptions::curtain);
  addFlag(tr("All landing &glides"), &scene3d::SceneOptions::allGlides);
  addFlag(tr("&Runways"), &scene3d::SceneOptions::runways);
  addFlag(tr("&Excluded runways"), &scene3d::SceneOptions::excludedRunways);
  addFlag(tr("&Names"), &scene3d::SceneOptions::labels);
  QAction* shown = menu->menuAction();
  shown->setText(tr("Shown"));
  icons_.emplace_back(shown, QStringLiteral("layers"));
  addAction(shown);
  if (auto* button = qobject_cast<QToolButton*>(widgetForAction(shown))) {
    button->setPopupMode(QToolButton::InstantPopup);
  }
}

void SceneBar::refresh() {
  fly_->setChecked(view_.isFlying());
  follow_->setChecked(view_.isFollowing());
}

void SceneBar::setTheme(style::Theme theme) {
  for (const auto& [action, name] : icons_) {
    action->setIcon(style::icon(name, theme));
  }
}

}  // namespace vp::gui
