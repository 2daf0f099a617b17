#include "ui/scene3d/scene_tool_bar.h"

#include "ui/scene3d/scene_view.h"

#include <QAction>
#include <QComboBox>
#include <QSignalBlocker>

#include <array>
#include <utility>

namespace vp::scene3d {
namespace {

constexpr std::array kSpeeds{1, 2, 5, 10, 20, 50};
constexpr int kUsualSpeed = 10;
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
      view_.startFlight(speed_->currentData().toDouble());
    } else {
      view_.stopFlight();
    }
    showState();
  });
  speed_ = new QComboBox(this);
  speed_->setToolTip(tr("Speed of the flight, times that of the aircraft"));
  speed_->setAccessibleName(tr("Speed of the flight"));
  for (const int factor : kSpeeds) {
    speed_->addItem(tr("%1× speed").arg(factor), static_cast<double>(factor));
  }
  speed_->setCurrentIndex(speed_->findData(static_cast<double>(kUsualSpeed)));
  connect(speed_, &QComboBox::activated, &view_, [this] {
    if (view_.isFlying()) {
      view_.startFlight(speed_->currentData().toDouble());
    }
  });
  addWidget(speed_);
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
  heights_ = new QComboBox(this);
  heights_->setToolTip(tr("How much larger heights are drawn than distances"));
  heights_->setAccessibleName(tr("Exaggeration of heights"));
  for (const double factor : kHeights) {
    heights_->addItem(tr("Heights %1×").arg(factor), factor);
  }
  connect(heights_, &QComboBox::activated, this,
          [this] { changeOptions([factor = heights_->currentData().toDouble()](SceneOptions& o) { o.verticalExaggeration = factor; }); });
  addWidget(heights_);
}

void SceneToolBar::changeOptions(const std::function<void(SceneOptions&)>& change) {
  SceneOptions options = view_.options();
  change(options);
  view_.setOptions(options);
}

void SceneToolBar::showState() {
  const bool hasPlan = view_.situation().plan != nullptr;
  const QSignalBlocker speedBlocker(speed_);
  const QSignalBlocker heightBlocker(heights_);
  presets_[static_cast<std::size_t>(Preset::AlongTour)]->setEnabled(hasPlan);
  follow_->setEnabled(hasPlan);
  follow_->setChecked(view_.isFollowing());
  fly_->setEnabled(hasPlan);
  fly_->setChecked(view_.isFlying());
  fly_->setText(view_.isFlying() ? tr("Stop") : tr("Fly"));
  speed_->setEnabled(hasPlan);
  curtain_->setChecked(view_.options().curtain);
  allGlides_->setChecked(view_.options().allGlides);
  heights_->setCurrentIndex(heights_->findData(view_.options().verticalExaggeration));
}

}  // namespace vp::scene3d
