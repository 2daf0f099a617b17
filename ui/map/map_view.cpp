#include "ui/map/map_view.h"

#include "ui/map/render_map.h"
#include "ui/map/tools/add_target_tool.h"
#include "ui/map/tools/draw_weather_tool.h"
#include "ui/map/tools/measure_tool.h"
#include "ui/map/tools/move_target_tool.h"
#include "ui/map/tools/select_tool.h"
#include "ui/style/core_text.h"

#include <QEvent>
#include <QPainter>
#include <QResizeEvent>

#include <algorithm>
#include <cmath>

namespace vp::map {
namespace {

constexpr int kReliefMegabytes = 128;
constexpr int kOverlayMegabytes = 64;
constexpr qint64 kSettled_ms = 700;       // after this the next move starts from a view worth coming back to
constexpr double kTargetScale = 12.0;     // m per px when a target is zoomed to
constexpr double kRequestedScale = 60.0;  // m per px at most when another view asks to see a place
constexpr double kZoomStep = 1.5;
constexpr double kPlanBorder = 60.0;  // px around the plan when it is shown as a whole

}  // namespace

MapView::MapView(document::ViewState& state, QWidget* parent)
    : QWidget(parent), state_(state), renderer_(MapScene{}), relief_(kReliefMegabytes), overlay_(kOverlayMegabytes) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAccessibleName(tr("Map"));
  setAccessibleDescription(
      tr("Terrain, runways, targets and tour. Arrow keys pan, Page Up and Page Down zoom, Ctrl+Home shows everything, the menu key offers what "
         "can be done with the object in the middle or the selected target."));
  useTool(std::make_unique<SelectTool>(asHost()), Tool::Select);
  camera_ = camera_.resized(size());
  connect(&relief_, &TileLayer::tilesArrived, this, qOverload<>(&QWidget::update));
  connect(&overlay_, &TileLayer::tilesArrived, this, qOverload<>(&QWidget::update));
  connect(&state_, &document::ViewState::cursorChanged, this, [this] {
    renderer_.setCursor(state_.position());
    update();
  });
  const auto takeOver = [this] { setScene(renderer_.scene()); };
  connect(&state_, &document::ViewState::selectionChanged, this, takeOver);
  connect(&state_, &document::ViewState::unitsChanged, this, takeOver);
  connect(&state_, &document::ViewState::landingChanged, this, takeOver);
  connect(&state_, &document::ViewState::themeChanged, this, takeOver);
  connect(this, &MapView::cameraChanged, this, [this] {
    if (pointer_) {  // it stays, and the ground moves under it
      emit pointerMoved(latLon(camera_.toGround(*pointer_)));
    }
  });
  connect(&state_, &document::ViewState::placeRequested, this, [this](geo::Point place) { zoomToPlace(place, kRequestedScale); });
  setScene({});
}

MapView::~MapView() = default;

void MapView::setScene(MapScene scene) {
  scene.theme = state_.theme();
  scene.units = state_.units();
  scene.selectedTarget = state_.selectedTarget();
  scene.selectedWeather = state_.selectedWeather();
  scene.cursor = state_.position();
  scene.landing = state_.landing();
  const auto terrainBefore = renderer_.scene().situation.terrain;
  renderer_.setScene(std::move(scene));
  const bool isOtherGround = terrainBefore != renderer_.scene().situation.terrain;
  if (relief_.painter() != renderer_.relief()) {
    relief_.setPainter(renderer_.relief(), isOtherGround ? TileLayer::OldTiles::Drop : TileLayer::OldTiles::Keep);
  }
  if (overlay_.painter() != renderer_.overlay()) {
    overlay_.setPainter(renderer_.overlay(), isOtherGround ? TileLayer::OldTiles::Drop : TileLayer::OldTiles::Keep);
  }
  rings_.layOut(renderer_.scene());
  objectsStale_ = true;
  update();
}

void MapView::setSituation(const document::Situation& situation) {
  const document::Situation before = renderer_.scene().situation;
  MapScene scene = renderer_.scene();
  scene.situation = situation;
  setScene(std::move(scene));
  tool_->sceneChanged();
  const bool isOtherFrame = situation.terrain != nullptr && (before.terrain == nullptr || !(before.terrain->frame == situation.terrain->frame));
  if (isOtherFrame) {
    history_.clear();
  }
  // the view stays put while targets are edited
  const bool isNewContent =
      before.terrain != situation.terrain || before.plan != situation.plan || (before.sites == nullptr) != (situation.sites == nullptr);
  if (isOtherFrame || (isUntouched_ && isNewContent)) {
    camera_ = homeCamera(situation, size());
    isUntouched_ = true;
    emit cameraChanged();
  }
}

void MapView::setOptions(const MapOptions& options) {
  if (options == renderer_.scene().options) {
    return;
  }
  MapScene scene = renderer_.scene();
  scene.options = options;
  setScene(std::move(scene));
  emit optionsChanged();
}

void MapView::useTool(std::unique_ptr<MapTool> tool, Tool kind) {
  if (tool_ != nullptr) {
    leftTools_.push_back(std::move(tool_));
  }
  tool_ = std::move(tool);
  const bool isOther = kind != toolKind_;
  toolKind_ = kind;
  drag_ = drag_ == Drag::Tool ? Drag::None : drag_;
  updateCursorShape();
  update();
  if (isOther) {
    emit toolChanged(kind);
  }
}

void MapView::setTool(Tool tool) {
  switch (tool) {
    case Tool::Select:
      useTool(std::make_unique<SelectTool>(asHost()), tool);
      break;
    case Tool::AddTarget:
      useTool(std::make_unique<AddTargetTool>(asHost()), tool);
      break;
    case Tool::Measure:
      useTool(std::make_unique<MeasureTool>(asHost()), tool);
      break;
    case Tool::DrawWeather:
      useTool(std::make_unique<DrawWeatherTool>(asHost()), tool);
      break;
  }
}

void MapView::moveTarget(int target) {
  const auto& targets = scene().situation.targets;
  if (targets != nullptr && target >= 0 && target < static_cast<int>(targets->size())) {
    useTool(std::make_unique<MoveTargetTool>(asHost(), target), Tool::Select);
  }
}

void MapView::measureFrom(geo::Point place) {
  auto tool = std::make_unique<MeasureTool>(asHost());
  tool->startAt(place);
  useTool(std::move(tool), Tool::Measure);
}

void MapView::setCamera(const MapCamera& camera) {
  moveTo(camera.resized(size()), Jump::Yes);
}

void MapView::moveTo(const MapCamera& camera, Jump jump) {
  if (camera == camera_) {
    return;
  }
  const bool isSettled = !sinceMove_.isValid() || sinceMove_.elapsed() > kSettled_ms;
  if (jump == Jump::Yes || isSettled) {
    history_.leave(camera_);
  }
  sinceMove_.start();
  isUntouched_ = false;
  camera_ = camera;
  emit cameraChanged();
  update();
}

void MapView::zoomIn() {
  moveTo(camera_.zoomedAt(camera_.screen().center(), kZoomStep), Jump::No);
}
void MapView::zoomOut() {
  moveTo(camera_.zoomedAt(camera_.screen().center(), 1.0 / kZoomStep), Jump::No);
}

void MapView::showAll() {
  moveTo(homeCamera(scene().situation, size()), Jump::Yes);
}

void MapView::showPlan() {
  const document::Situation& now = scene().situation;
  geo::Box box;
  if (now.plan != nullptr) {
    for (const document::TourSample& sample : now.plan->samples()) {
      box.add(sample.state.pose.point());
    }
  } else if (now.targets != nullptr && now.terrain != nullptr) {
    for (const document::ShownTarget& target : *now.targets) {
      box.add(target.point);
    }
  }
  if (!box.isEmpty()) {
    moveTo(camera_.fittedTo(box, kPlanBorder), Jump::Yes);
  }
}

void MapView::toggleRings(geo::Point place) {
  const QPointF at = camera_.toScreen(place);
  const std::optional<std::size_t> mark = rings_.markAt(camera_, at);
  if (const auto where = mark ? rings_.placeOf(*mark) : latLon(place)) {
    rings_.toggle(*where);
    updateCursorShape();
    update();
  }
}

void MapView::clearRings() {
  rings_.clear();
  update();
}

void MapView::goBack() {
  if (const auto camera = history_.back(camera_)) {
    camera_ = *camera;
    emit cameraChanged();
    update();
  }
}

void MapView::goForward() {
  if (const auto camera = history_.forward(camera_)) {
    camera_ = *camera;
    emit cameraChanged();
    update();
  }
}

void MapView::centreOn(geo::Point place) {
  moveTo(camera_.centredOn(place), Jump::Yes);
}

void MapView::zoomToPlace(geo::Point place, double metresPerPixel) {
  const MapCamera closer = camera_.metresPerPixel() > metresPerPixel ? camera_.withScale(metresPerPixel) : camera_;
  moveTo(closer.centredOn(place), Jump::Yes);
}

void MapView::zoomToTarget(int target) {
  const auto& targets = scene().situation.targets;
  if (targets != nullptr && target >= 0 && target < static_cast<int>(targets->size())) {
    zoomToPlace((*targets)[static_cast<std::size_t>(target)].point, kTargetScale);
  }
}

std::optional<geo::LatLon> MapView::latLon(geo::Point place) const {
  const auto& terrain = scene().situation.terrain;
  return terrain != nullptr ? std::optional(terrain->frame.toLatLon(place)) : std::nullopt;
}

void MapView::askAddTarget(geo::Point place, int insertBefore) {
  if (const auto where = latLon(place)) {
    emit targetAddRequested(*where, insertBefore);
  }
}

void MapView::askMoveTarget(int target, geo::Point place) {
  if (const auto where = latLon(place)) {
    emit targetMoveRequested(target, *where);
  }
}

bool MapView::askAddWeather(const std::vector<geo::Point>& outline) {
  const auto& terrain = scene().situation.terrain;
  if (terrain == nullptr) {
    return false;
  }
  mission::WeatherCell cell;
  for (const geo::Point& corner : outline) {
    cell.outline.push_back(terrain->frame.toLatLon(corner));
  }
  if (const std::string problem = document::weatherProblem(cell, terrain->frame); !problem.empty()) {
    tell(style::coreText(problem));
    return false;
  }
  emit weatherDrawn(cell.outline);
  return true;
}

void MapView::askMoveWeatherCorner(int cell, std::size_t corner, geo::Point place) {
  if (const auto where = latLon(place)) {
    emit weatherCornerMoved(cell, static_cast<int>(corner), *where);
  }
}

void MapView::askShowSite(int site) {
  emit siteClicked(QString::fromStdString((*scene().situation.sites)[static_cast<std::size_t>(site)].site.site.id));
}

void MapView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  camera_ = isUntouched_ ? homeCamera(scene().situation, size()) : camera_.resized(size());
  emit cameraChanged();
}

void MapView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::FontChange || event->type() == QEvent::LanguageChange) {
    objectsStale_ = true;
    update();
  }
  QWidget::changeEvent(event);
}

}  // namespace vp::map
