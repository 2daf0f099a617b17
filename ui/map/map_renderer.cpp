#include "ui/map/map_renderer.h"

#include "ui/map/airspace_marks.h"
#include "ui/map/chart_frame.h"
#include "ui/map/engine_out_label.h"
#include "ui/map/site_marks.h"
#include "ui/map/target_marks.h"
#include "ui/map/tile_layer.h"
#include "ui/map/tour_lines.h"
#include "ui/map/weather_marks.h"

#include <algorithm>
#include <cmath>

namespace vp::map {
namespace {

constexpr double kContourLabelSpacing = 260.0;  // px between labels of one line
constexpr double kContourStep = 6.0;            // px between the probes that look for a line
constexpr double kContourRows = 70.0;           // px between the rows of probes

std::shared_ptr<const std::vector<document::PlanningSketch::Edge>> roadmapOf(const MapScene& scene) {
  return scene.situation.sketch != nullptr ? scene.situation.sketch->roadmap : nullptr;
}

bool wantsField(const MapOptions& options) {
  return options.safeAltitude || options.reachableFrom;
}

}  // namespace

geo::Box contentBox(const document::Situation& situation) {
  geo::Box box;
  if (situation.plan != nullptr) {
    for (const document::TourSample& sample : situation.plan->samples()) {
      box.add(sample.state.pose.point());
    }
    const mission::Plan& plan = situation.plan->plan();
    const auto addSite = [&](int site) {
      if (site >= 0 && static_cast<std::size_t>(site) < plan.sites.size()) {
        box.add(plan.sites[static_cast<std::size_t>(site)].pose.point());
      }
    };
    for (const mission::DecisionPoint& point : plan.tour) {
      addSite(point.witness.site);
    }
    for (const std::optional<mission::HomePath>* way : {&plan.departure, &plan.arrival}) {
      if (*way) {
        addSite((*way)->site);
        for (const mission::DecisionPoint& point : (*way)->points) {
          box.add(point.pose.point());
        }
      }
    }
  }
  if (situation.targets != nullptr) {
    for (const document::ShownTarget& target : *situation.targets) {
      box.add(target.point);
    }
  }
  if (box.isEmpty() && situation.terrain != nullptr) {
    box = situation.terrain->grid->extent();
  }
  if (box.isEmpty() && situation.sites != nullptr) {
    for (const document::ShownSite& site : *situation.sites) {
      box.add(site.site.pose.point());
    }
  }
  return box;
}

MapRenderer::MapRenderer(MapScene scene) {
  setScene(std::move(scene));
}

void MapRenderer::setScene(MapScene scene) {
  const MapScene before = std::move(scene_);
  scene_ = std::move(scene);
  updateRelief(before);
  updateOverlay(before);
  if (before.situation.plan != scene_.situation.plan || before.cursor != scene_.cursor) {
    engineOut_.reset();
    setCursor(scene_.cursor);
  }
}

void MapRenderer::setCursor(std::optional<double> distance) {
  if (scene_.situation.plan == nullptr || !distance) {
    engineOut_.reset();
  } else if (!engineOut_ || scene_.cursor != distance) {
    engineOut_ = scene_.situation.plan->engineOutAt(*distance);
  }
  scene_.cursor = distance;
}

void MapRenderer::updateRelief(const MapScene& before) {
  const std::shared_ptr<const document::TerrainData>& terrain = scene_.situation.terrain;
  if (terrain == nullptr) {
    heights_.reset();
    relief_.reset();
    return;
  }
  const bool isOther = relief_ == nullptr || before.situation.terrain != terrain;
  if (isOther) {
    heights_ = std::make_shared<const HeightLevels>(terrain->grid);
  }
  if (isOther || before.theme != scene_.theme || before.options.contours != scene_.options.contours || !(before.units == scene_.units)) {
    relief_ = std::make_shared<const ReliefPainter>(
        heights_, ReliefStyle{scene_.theme, scene_.units.system(), scene_.options.contours, terrain->lowest, terrain->highest});
  }
}

void MapRenderer::updateOverlay(const MapScene& before) {
  const bool otherField = before.situation.safeAltitudes != scene_.situation.safeAltitudes ||
                          before.options.safeAltitudeCourse != scene_.options.safeAltitudeCourse ||
                          wantsField(before.options) != wantsField(scene_.options);
  if (otherField) {
    safeAltitude_ = scene_.situation.safeAltitudes != nullptr && wantsField(scene_.options)
                        ? std::make_shared<const SafeAltitudeLayer>(*scene_.situation.safeAltitudes, scene_.options.safeAltitudeCourse)
                        : nullptr;
  }
  const bool otherGlides = before.situation.plan != scene_.situation.plan || before.options.allGlides != scene_.options.allGlides;
  if (otherGlides) {
    glides_ = scene_.options.allGlides && scene_.situation.plan != nullptr ? std::make_shared<const GlideLines>(scene_.situation.plan) : nullptr;
  }
  const bool otherPopulation = updatePopulation(before);
  const auto weatherOf = [](const MapScene& scene) { return scene.options.weather ? scene.situation.weather : nullptr; };
  const bool isOther = otherField || otherGlides || otherPopulation || weatherOf(before) != weatherOf(scene_) || before.theme != scene_.theme ||
                       !(before.units == scene_.units) || before.options.safeAltitude != scene_.options.safeAltitude ||
                       before.options.reachableFrom != scene_.options.reachableFrom || roadmapOf(before) != roadmapOf(scene_);
  if (isOther) {
    OverlayContent content{
        scene_.theme,      scene_.units.system(), safeAltitude_,    scene_.options.safeAltitude, scene_.options.reachableFrom, glides_,
        roadmapOf(scene_), population_,           weatherOf(scene_)};
    overlay_ = content.isEmpty() ? nullptr : std::make_shared<const OverlayPainter>(std::move(content));
  }
}

/// @return whether it has changed
bool MapRenderer::updatePopulation(const MapScene& before) {
  const auto shownOf = [](const MapScene& scene) { return scene.options.population ? scene.situation.population : nullptr; };
  if (shownOf(before) == shownOf(scene_)) {
    return false;
  }
  population_ = shownOf(scene_) != nullptr ? std::make_shared<const PopulationLayer>(shownOf(scene_)) : nullptr;
  return true;
}

void MapRenderer::drawObjects(QPainter& painter, const MapCamera& camera, const std::vector<QRectF>& reserved) const {
  LabelPlacer labels(camera.screen());
  for (const QRectF& box : reserved) {
    labels.reserve(box);
  }
  const TourLines tour(scene_, camera);
  const SiteMarks sites(scene_, camera);
  const TargetMarks targets(scene_, camera);
  const AirspaceMarks airspaces(scene_, camera);
  const WeatherMarks weather(scene_, camera);
  airspaces.draw(painter);
  tour.draw(painter);
  tour.drawSketch(painter);
  sites.drawSymbols(painter, labels);
  targets.drawSymbols(painter, labels);
  tour.drawMarks(painter, labels);
  tour.avoidLabels(labels);
  targets.drawLabels(painter, labels);
  sites.drawLabels(painter, labels);
  weather.drawHandles(painter);
  weather.drawLabels(painter, labels);
  airspaces.drawLabels(painter, labels);
  drawContourLabels(painter, camera, labels);
}

void MapRenderer::drawContourLabels(QPainter& painter, const MapCamera& camera, LabelPlacer& labels) const {
  if (safeAltitude_ == nullptr || !scene_.options.safeAltitude || safeAltitude_->isEmpty()) {
    return;
  }
  const style::ChartColors& colors = scene_.colors();
  const QFont font = chartFont(TextSize::Small);
  const double interval = safeAltitude_->interval(scene_.units.system());
  std::vector<std::pair<double, QPointF>> written;
  const int rows = static_cast<int>(std::ceil(camera.size().height() / kContourRows - 0.5));
  const int columns = static_cast<int>(std::ceil(camera.size().width() / kContourStep - 1.0));
  for (int row = 0; row < rows; ++row) {
    const double y = (row + 0.5) * kContourRows;
    std::optional<double> last;
    for (int column = 0; column < columns; ++column) {
      const double x = (column + 1) * kContourStep;
      const std::optional<double> here = safeAltitude_->at(camera.toGround({x, y}));
      if (here && last && std::floor(*here / interval) != std::floor(*last / interval)) {
        const double level = std::floor(std::max(*here, *last) / interval) * interval;
        const double share = (level - *last) / (*here - *last);
        const QPointF at(x - kContourStep * (1.0 - share), y);
        const bool isNear = std::any_of(written.begin(), written.end(), [&](const auto& other) {
          return std::abs(other.first - level) < 0.5 * interval && (other.second - at).manhattanLength() < kContourLabelSpacing;
        });
        const QStringList text{QString::number(std::lround(scene_.units.heightFromSi(level)))};
        QRectF box(QPointF(), textSize(text, font));
        box.moveCenter(at);
        if (!isNear && labels.placeClear(box)) {
          drawHaloText(painter, box.topLeft(), text, font, colors.text, colors.textHalo);
          written.emplace_back(level, at);
        }
      }
      last = here;
    }
  }
}

void MapRenderer::drawCursor(QPainter& painter, const MapCamera& camera) const {
  if (scene_.landing != nullptr) {
    drawLandings(painter, *scene_.landing, camera);
  }
  if (engineOut_) {
    const std::vector<mission::SiteInFrame>& sites = scene_.situation.plan->plan().sites;
    const bool arrives = engineOut_->site >= 0 && !engineOut_->path.empty();
    const std::optional<geo::Point> end = arrives ? std::optional(sites[static_cast<std::size_t>(engineOut_->site)].pose.point()) : std::nullopt;
    drawEngineOut(painter, scene_.colors(), camera, *engineOut_, end);
  }
}

void MapRenderer::drawLandings(QPainter& painter, const document::LandingCase& landing, const MapCamera& camera) const {
  const document::ShownLanding* const shown = landing.shown();
  for (const document::ShownLanding& other : landing.landings) {
    if (&other != shown && !other.glide.path.empty()) {
      drawOtherGlide(painter, scene_.colors(), camera, other.glide);
    }
  }
  document::EngineOut aircraft;
  aircraft.from.pose = landing.pose;
  const std::optional<geo::Point> end = shown != nullptr && shown->site ? std::optional(shown->site->pose.point()) : std::nullopt;
  drawEngineOut(painter, scene_.colors(), camera, shown != nullptr && !shown->glide.path.empty() ? shown->glide : aircraft, end);
}

void MapRenderer::drawFrame(QPainter& painter, const MapCamera& camera, const QString& message) const {
  const ChartFrame frame(scene_, camera, safeAltitude_.get(), message);
  frame.draw(painter);
  if (engineOut_) {
    if (const auto label = engineOutLabel(scene_, camera, *engineOut_, frame.covered())) {
      drawEngineOutLabel(painter, *label, scene_.colors(), camera.screen());
    }
  }
}

std::vector<QRectF> MapRenderer::frameBoxes(const MapCamera& camera) const {
  return ChartFrame(scene_, camera, safeAltitude_.get()).covered();
}

void MapRenderer::drawAll(QPainter& painter, const MapCamera& camera, double devicePixelRatio) const {
  painter.fillRect(camera.screen(), scene_.colors().unknownBase);
  if (relief_ != nullptr) {
    TileLayer::drawNow(painter, *relief_, camera, devicePixelRatio);
  }
  if (overlay_ != nullptr) {
    TileLayer::drawNow(painter, *overlay_, camera, devicePixelRatio);
  }
  drawObjects(painter, camera, frameBoxes(camera));
  drawCursor(painter, camera);
  drawFrame(painter, camera);
}

}  // namespace vp::map
