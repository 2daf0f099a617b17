#include "ui/scene3d/scene_view.h"

#include "ui/scene3d/camera_input.h"
#include "ui/scene3d/camera_presets.h"
#include "ui/scene3d/overlay_widgets.h"
#include "ui/scene3d/terrain_tile.h"

#include <QLabel>

#include <algorithm>
#include <cmath>

namespace vp::scene3d {
namespace {

constexpr int kTickMs = 16;
constexpr int kRestMs = 160;  // after that long without movement the picture is drawn at its best
constexpr int kPinMs = 80;    // the flight moves the shared cursor this often

}  // namespace

SceneView::SceneView(document::ViewState& state, QWidget* parent) : QWidget(parent), state_(state) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(160, 120);
  setAccessibleName(tr("3D view"));
  setAccessibleDescription(tr("Terrain, tour and glides in three dimensions. Space shows all, keys 1 to 4 change the view."));
  input_ = std::make_unique<CameraInput>(*this);
  // from any thread; requestFrame() itself runs here
  worker_ = std::make_unique<SceneWorker>([this] { mailbox_.post([this] { requestFrame(); }); });
  overlay_ = new SceneOverlay(this);
  message_ = new QLabel(this);
  message_->setAlignment(Qt::AlignCenter);
  message_->setWordWrap(true);
  message_->setMargin(24);
  message_->setAttribute(Qt::WA_TransparentForMouseEvents);
  connect(overlay_, &SceneOverlay::northRequested, this, [this] {
    CameraOrbit orbit = controller_.orbit();
    orbit.azimuth = 1.5707963267948966;
    controller_.flyTo(orbit);
    cameraMoved(true);
  });
  connect(worker_.get(), &SceneWorker::terrainReady, this, &SceneView::receiveTerrain);
  connect(worker_.get(), &SceneWorker::sceneReady, this, &SceneView::receiveScene);
  connect(worker_.get(), &SceneWorker::cursorReady, this, [this](const std::shared_ptr<const SceneNodes>& nodes) {
    takeCursor(nodes);
    requestFrame();
  });
  connect(&state_, &document::ViewState::cursorChanged, this, &SceneView::onCursorChanged);
  connect(&state_, &document::ViewState::selectionChanged, this, &SceneView::rebuildCursor);
  connect(&state_, &document::ViewState::placeRequested, this, &SceneView::onPlaceRequested);
  connect(&state_, &document::ViewState::unitsChanged, this, [this] {
    rebuildTerrain();  // contour lines lie at round heights of the unit
    rebuildScene();
    rebuildCursor();
  });
  connect(&state_, &document::ViewState::themeChanged, this, [this] {
    rebuildTerrain();
    rebuildScene();
    rebuildCursor();
    updateMessage();
  });
  clock_.setInterval(kTickMs);
  clock_.setTimerType(Qt::PreciseTimer);
  connect(&clock_, &QTimer::timeout, this, &SceneView::tick);
  sincePin_.start();
  updateMessage();
  // last: it calls the derived class, which is not there yet
  connect(overlay_, &SceneOverlay::arranged, this, [this] {
    takeReserved(overlay_->covered());
    requestFrame();
  });
}

SceneView::~SceneView() = default;

void SceneView::setSituation(const document::Situation& situation) {
  const bool newTerrain = situation.terrain != situation_.terrain;
  const bool newPlan = situation.plan != situation_.plan;
  const bool targetsChanged = situation.targets != situation_.targets;
  const bool newScene = newTerrain || newPlan || situation.sites != situation_.sites || situation.airspaces != situation_.airspaces ||
                        targetsChanged || situation.planIsCurrent != situation_.planIsCurrent;
  situation_ = situation;
  overlay_->setWinds(situation_.wind);
  if (newTerrain) {
    isHome_ = true;
    isTerrainBuilt_ = false;
    rebuildTerrain();
  }
  if (newPlan || targetsChanged) {
    rebuildCursor();
  }
  if (newPlan) {
    updatePath();
    if (isHome_ && model_ != nullptr && !newTerrain) {
      goHome();
    }
  }
  if (newScene) {
    rebuildScene();
  }
  updateMessage();
  emit situationChanged();
}

void SceneView::setOptions(const SceneOptions& options) {
  SceneOptions wanted = options;
  wanted.verticalExaggeration = std::clamp(options.verticalExaggeration, 1.0, 5.0);
  if (wanted == options_) {
    return;
  }
  const double before = options_.verticalExaggeration;
  const bool onlyHeights = [&] {
    SceneOptions same = wanted;
    same.verticalExaggeration = before;
    return same == options_;
  }();
  options_ = wanted;
  if (options_.verticalExaggeration != before) {
    takeLook(state_.theme(), options_.verticalExaggeration);
    CameraOrbit orbit = controller_.orbit();
    orbit.pivot.z *= options_.verticalExaggeration / before;
    controller_.setGround(cameraGround(model_, options_.verticalExaggeration));
    updatePath();
    controller_.jumpTo(orbit);
    cameraMoved(false);
  }
  if (!onlyHeights) {
    rebuildScene();
  }
  overlay_->setExaggeration(options_.verticalExaggeration);
  emit optionsChanged();
}

void SceneView::showPreset(Preset preset) {
  if (controller_.isFollowing()) {
    setFollowing(false);
  }
  controller_.flyTo(presetOrbit(preset, situation_, model_.get(), options_.verticalExaggeration, state_.position(), controller_));
  cameraMoved(true);
}

void SceneView::goHome() {
  showPreset(Preset::North);
  isHome_ = true;
}

void SceneView::startFlight(double speedFactor) {
  if (situation_.plan == nullptr || speedFactor <= 0.0) {
    return;
  }
  if (!controller_.isFollowing()) {
    controller_.follow(state_.position().value_or(0.0));
  }
  controller_.fly(speedFactor);
  cameraMoved(true);
  emit flightChanged();
}

void SceneView::stopFlight() {
  if (!isFlying()) {
    return;
  }
  controller_.fly(0.0);
  if (const auto distance = controller_.followedDistance()) {
    state_.setPinned(distance);
  }
  cameraMoved(true);
  emit flightChanged();
}

void SceneView::setFollowing(bool following) {
  if (following == controller_.isFollowing() || (following && situation_.plan == nullptr)) {
    return;
  }
  if (following) {
    controller_.follow(state_.position().value_or(0.0));
  } else {
    stopFlight();
    controller_.stopFollowing();
  }
  cameraMoved(true);
  emit flightChanged();
}

bool SceneView::isSettled() const {
  return !worker_->isBusy() && !controller_.isMoving();
}

void SceneView::showProblem(const QString& text) {
  problem_ = text;
  updateMessage();
}

bool SceneView::isInMotion() const {
  return input_->isDragging() || controller_.isMoving() || (sinceMove_.isValid() && sinceMove_.elapsed() < kRestMs);
}

void SceneView::rebuildTerrain() {
  takeLook(state_.theme(), options_.verticalExaggeration);
  overlay_->setStyle(sceneStyle());
  worker_->buildTerrain(situation_.terrain, sceneStyle());
  updateMessage();
}

void SceneView::rebuildScene() {
  labelRatio_ = labelRatio();
  overlay_->setStyle(sceneStyle());
  worker_->buildScene(situation_, options_, sceneStyle(), labelRatio_);
}

void SceneView::rebuildCursor() {
  worker_->buildCursor(situation_, state_.position(), state_.selectedTarget(), sceneStyle(), labelRatio());
}

void SceneView::receiveTerrain(const SceneWorker::Terrain& terrain) {
  const bool isNew = terrain.model != model_;
  model_ = terrain.model;
  isTerrainBuilt_ = true;
  takeTerrain(terrain.layer);
  overlay_->setContourInterval(model_ != nullptr ? contourInterval(model_->lowest(), model_->highest(), state_.units()) : 0.0);
  if (isNew) {
    controller_.setGround(cameraGround(model_, options_.verticalExaggeration));
    if (isHome_) {
      const Preset home = Preset::North;
      controller_.jumpTo(presetOrbit(home, situation_, model_.get(), options_.verticalExaggeration, {}, controller_));
    }
  }
  updateMessage();
  cameraMoved(false);
}

void SceneView::receiveScene(const SceneWorker::Scene& scene) {
  takeScene(scene.nodes);
  overlay_->setAltitudes(situation_.plan != nullptr ? std::optional(scene.altitudes) : std::nullopt);
  requestFrame();
}

void SceneView::updatePath() {
  controller_.setPath(flightPath(situation_.plan, options_.verticalExaggeration));
}

void SceneView::onCursorChanged() {
  rebuildCursor();
  if (isPinning_ || !controller_.isFollowing()) {
    return;
  }
  if (const auto position = isFlying() ? state_.pinned() : state_.position()) {
    controller_.follow(*position);
    cameraMoved(false);
  }
}

void SceneView::onPlaceRequested(geo::Point place) {
  if (model_ == nullptr) {
    return;
  }
  setFollowing(false);
  CameraOrbit orbit = controller_.orbit();
  orbit.pivot = {place.x, place.y, model_->surfaceAt(place) * options_.verticalExaggeration};
  orbit.distance = std::min(orbit.distance, std::max(4000.0, 0.25 * controller_.camera().farPlane / 8.0));
  controller_.flyTo(orbit);
  cameraMoved(true);
}

void SceneView::cameraMoved(bool byHand) {
  isHome_ = isHome_ && !byHand;
  sinceMove_.start();
  overlay_->setAzimuth(controller_.orbit().azimuth);
  if (!clock_.isActive()) {
    sinceTick_.start();
    clock_.start();
  }
  requestFrame();
}

void SceneView::tick() {
  const double seconds = static_cast<double>(sinceTick_.restart()) / 1000.0;
  if (controller_.isMoving()) {
    controller_.advance(seconds);
    sinceMove_.start();
    overlay_->setAzimuth(controller_.orbit().azimuth);
    if (isFlying() && sincePin_.elapsed() >= kPinMs) {
      sincePin_.start();
      isPinning_ = true;
      state_.setPinned(controller_.followedDistance());
      isPinning_ = false;
    }
    requestFrame();
  } else if (!isInMotion()) {
    clock_.stop();
    requestFrame();  // once more, at its best
  }
}

void SceneView::updateMessage() {
  QString text = problem_;
  if (text.isEmpty() && situation_.terrain == nullptr) {
    text = tr("No terrain yet.\nAdd a terrain file to see it in three dimensions.");
  } else if (text.isEmpty() && model_ == nullptr) {
    text = isTerrainBuilt_ ? tr("This terrain is too small to be drawn.") : tr("Preparing the terrain…");
  }
  const style::ChartColors& colors = style::ChartColors::of(state_.theme());
  QPalette palette = message_->palette();
  palette.setColor(QPalette::WindowText, colors.text);
  palette.setColor(QPalette::Window, colors.sky);
  message_->setPalette(palette);
  message_->setAutoFillBackground(true);
  message_->setText(text);
  message_->setVisible(!text.isEmpty());
  message_->setGeometry(rect());
  overlay_->setVisible(text.isEmpty());
  message_->raise();
}

void SceneView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const double before = controller_.camera().aspect();
  controller_.setPicture(width(), height());
  overlay_->setGeometry(rect());
  message_->setGeometry(rect());
  if (isHome_ && std::abs(controller_.camera().aspect() - before) > 1e-3 && situation_.terrain != nullptr) {
    controller_.jumpTo(presetOrbit(Preset::North, situation_, model_.get(), options_.verticalExaggeration, {}, controller_));
  }
  cameraMoved(false);
}

void SceneView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (labelRatio_ != 0.0 && labelRatio_ != labelRatio()) {
    rebuildScene();
    rebuildCursor();
  }
}

}  // namespace vp::scene3d
