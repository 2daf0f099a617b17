#include "ui/scene3d/scene_data.h"

#include "core/flight/curve_sampling.h"
#include "ui/scene3d/airspace_scene.h"
#include "ui/style/short_name.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace vp::scene3d {
namespace {

constexpr double kRouteWidth = 4.0;
constexpr double kCursorGlideWidth = 5.0;
constexpr double kAllGlidesWidth = 1.6;
constexpr std::size_t kMostGlides = 400;  // more overlap to one surface
constexpr double kDefaultRunway = 600.0;  // m, where the file has no length
constexpr double kDefaultWidth = 30.0;    // m

double surfaceAt(const TerrainModel* terrain, geo::Point p, double fallback) {
  return terrain != nullptr ? terrain->surfaceAt(p) : fallback;
}

ScenePoint pointOf(const document::TourState& state) {
  return {state.pose.x, state.pose.y, state.altitude};
}

void addTour(SceneData& scene, const document::Situation& situation, const SceneOptions& options) {
  const style::ChartColors& colors = style::ChartColors::of(scene.style.theme);
  SceneLine tour;
  tour.color = situation.planIsCurrent ? colors.route : colors.routeOutdated;
  tour.casing = colors.routeCasing;
  tour.width = kRouteWidth;
  tour.showHidden = true;
  for (const document::TourSample& sample : situation.plan->samples()) {
    tour.points.push_back(pointOf(sample.state));
  }
  if (options.curtain) {
    SceneCurtain curtain;
    curtain.top = tour.points;
    for (const ScenePoint& p : curtain.top) {
      curtain.bottom.push_back(std::min(p.z, surfaceAt(scene.terrain.get(), p.ground(), scene.altitudes.low)));
    }
    scene.curtains.push_back(std::move(curtain));
  }
  scene.lines.push_back(std::move(tour));
}

/// Spirals down to low targets and up again ([1] Fig. 7).
void addSpirals(SceneData& scene, const document::Situation& situation) {
  constexpr int kPointsPerTurn = 48;
  const style::ChartColors& colors = style::ChartColors::of(scene.style.theme);
  const mission::Plan& plan = situation.plan->plan();
  for (const mission::SpiralVisit& spiral : plan.spirals) {
    const auto visit =
        std::find_if(plan.tour.begin(), plan.tour.end(), [&](const mission::DecisionPoint& point) { return point.target == spiral.target; });
    if (visit == plan.tour.end() || spiral.radius <= 0.0 || spiral.turn == flight::Turn::Straight) {
      continue;
    }
    SceneLine line;
    line.color = situation.planIsCurrent ? colors.route : colors.routeOutdated;
    line.casing = colors.routeCasing;
    line.width = 0.6 * kRouteWidth;
    const double around = 2.0 * std::numbers::pi * spiral.radius;
    const int down = std::max(1, spiral.turnsDown) * kPointsPerTurn;
    const int up = std::max(1, spiral.turnsUp) * kPointsPerTurn;
    for (int k = 0; k <= down + up; ++k) {
      const double flown = around * static_cast<double>(k % kPointsPerTurn) / kPointsPerTurn;
      const geo::Pose pose = flight::poseAfter(visit->pose, {spiral.turn, spiral.radius, around}, flown);
      const double part = k <= down ? static_cast<double>(k) / down : 1.0 - static_cast<double>(k - down) / up;
      line.points.push_back({pose.x, pose.y, spiral.top + (spiral.bottom - spiral.top) * part});
    }
    scene.lines.push_back(std::move(line));
  }
}

/// The ways from and to the home runway.
void addHomePaths(SceneData& scene, const document::Situation& situation) {
  constexpr double kSpacing = 15.0;  // m
  const style::ChartColors& colors = style::ChartColors::of(scene.style.theme);
  const mission::Plan& plan = situation.plan->plan();
  for (const std::optional<mission::HomePath>* path : {&plan.departure, &plan.arrival}) {
    if (!*path) {
      continue;
    }
    SceneLine line;
    line.color = situation.planIsCurrent ? colors.route : colors.routeOutdated;
    line.casing = colors.routeCasing;
    line.width = 0.6 * kRouteWidth;
    const std::vector<mission::DecisionPoint>& points = (*path)->points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const flight::Piece& piece = points[i].onward;
      const int parts = std::max(1, static_cast<int>(std::ceil(piece.length / kSpacing)));
      for (int k = 0; k < parts; ++k) {
        const double part = static_cast<double>(k) / parts;
        const geo::Pose pose = flight::poseAfter(points[i].pose, piece, part * piece.length);
        line.points.push_back({pose.x, pose.y, points[i].altitude + part * (points[i + 1].altitude - points[i].altitude)});
      }
    }
    line.points.push_back({points.back().pose.x, points.back().pose.y, points.back().altitude});
    scene.lines.push_back(std::move(line));
  }
}

std::vector<ScenePoint> pointsOf(const document::EngineOut& glide) {
  std::vector<ScenePoint> points;
  points.reserve(glide.path.size());
  for (const document::GlidePoint& p : glide.path) {
    points.push_back({p.pose.x, p.pose.y, p.altitude});
  }
  return points;
}

void addAllGlides(SceneData& scene, const document::Situation& situation, const std::stop_token& stop) {
  const std::size_t count = situation.plan->plan().tour.size();
  const std::size_t step = (count + kMostGlides - 1) / kMostGlides;
  for (std::size_t i = 0; i < count && !stop.stop_requested(); i += step) {
    SceneLine line;
    line.points = pointsOf(situation.plan->engineOutAt(situation.plan->distanceOf(i)));
    line.width = kAllGlidesWidth;
    scene.lines.push_back(std::move(line));
  }
}

ScenePole poleOf(const document::ShownTarget& target, const SceneData& scene, bool isSelected) {
  const style::ChartColors& colors = style::ChartColors::of(scene.style.theme);
  const double foot = surfaceAt(scene.terrain.get(), target.point, scene.altitudes.low);
  const double head = std::max(target.altitude.value_or(foot + 100.0), foot + 1.0);
  return {
      {target.point.x, target.point.y, foot}, {target.point.x, target.point.y, head}, target.altitude ? colors.target : colors.mutedText, isSelected};
}

void addTargets(SceneData& scene, const document::Situation& situation) {
  for (std::size_t i = 0; situation.targets != nullptr && i < situation.targets->size(); ++i) {
    const document::ShownTarget& target = (*situation.targets)[i];
    const bool isPlaced = target.altitude.has_value();
    const ScenePole pole = poleOf(target, scene, false);
    scene.poles.push_back(pole);
    SceneLabel label;
    label.kind = SceneLabel::Kind::Target;
    label.anchor = pole.head;
    label.text = style::shortName(QString::fromStdString(target.target.name));
    label.detail =
        isPlaced ? scene.style.units.altitudeMsl(*target.altitude) : QCoreApplication::translate("vp::scene3d::SceneData", "no terrain here");
    label.color = pole.color;
    label.priority = 50.0;
    scene.labels.push_back(std::move(label));
  }
}

bool isOtherEnd(const SceneRunway& a, const mission::SiteInFrame& b) {
  const double turn = std::abs(std::remainder(b.pose.heading - a.threshold.heading, 2.0 * std::numbers::pi));
  const geo::Point end{a.threshold.x + a.length * std::cos(a.threshold.heading), a.threshold.y + a.length * std::sin(a.threshold.heading)};
  return turn > 3.0 && geo::distance(end, b.pose.point()) < std::max(150.0, 0.4 * a.length);
}

/// How an airport's usable and excluded ends come together to runways and labels.
struct AirportEnds {
  ScenePoint sum;
  int count = 0;
  bool usable = false;
  QString name;
  std::string ident;
  double elevation = 0.0;
};

void addRunway(SceneData& scene, const document::ShownSite& shown, std::vector<std::pair<SceneRunway, std::string>>& runways) {
  const mission::LandingSite& site = shown.site.site;
  for (auto& [runway, airport] : runways) {
    if (airport == site.airportIdent && isOtherEnd(runway, shown.site)) {
      runway.usableBack = runway.usableBack || shown.usable;
      return;
    }
  }
  SceneRunway runway;
  runway.threshold = shown.site.pose;
  runway.elevation = site.elevation.metres();
  runway.length = site.length ? site.length->si() : kDefaultRunway;
  runway.width = site.width ? site.width->si() : kDefaultWidth;
  runway.usable = shown.usable;
  runways.emplace_back(runway, site.airportIdent);
  static_cast<void>(scene);
}

void addRunways(SceneData& scene, const document::Situation& situation, const SceneOptions& options) {
  const style::ChartColors& colors = style::ChartColors::of(scene.style.theme);
  std::vector<std::pair<SceneRunway, std::string>> runways;
  std::map<std::string, AirportEnds> airports;
  for (const document::ShownSite& shown : *situation.sites) {
    if (!shown.usable && !options.excludedRunways) {
      continue;
    }
    addRunway(scene, shown, runways);
    const mission::LandingSite& site = shown.site.site;
    const double ground = surfaceAt(scene.terrain.get(), shown.site.pose.point(), site.elevation.metres());
    const ScenePoint place{shown.site.pose.x, shown.site.pose.y, std::max(ground, site.elevation.metres())};
    AirportEnds& airport = airports[site.airportIdent.empty() ? site.id : site.airportIdent];
    airport.sum = airport.sum + place;
    airport.count += 1;
    airport.usable = airport.usable || shown.usable;
    airport.ident = site.airportIdent.empty() ? site.id : site.airportIdent;
    airport.elevation = site.elevation.metres();
    SceneLabel label;
    label.kind = SceneLabel::Kind::RunwayEnd;
    label.anchor = place;
    label.text = QString::fromStdString(site.runwayIdent);
    label.color = shown.usable ? colors.runway : colors.runwayExcluded;
    label.priority = 20.0;
    label.showWithin = 14.0 * std::max(600.0, site.length ? site.length->si() : kDefaultRunway);
    if (!label.text.isEmpty()) {
      scene.labels.push_back(std::move(label));
    }
  }
  for (auto& [runway, airport] : runways) {
    scene.runways.push_back(runway);
  }
  for (const auto& [ident, airport] : airports) {
    SceneLabel label;
    label.kind = SceneLabel::Kind::Airport;
    label.anchor = (1.0 / airport.count) * airport.sum;
    label.text = QString::fromStdString(airport.ident);
    label.detail = scene.style.units.altitudeMsl(airport.elevation);
    label.color = airport.usable ? colors.runway : colors.runwayExcluded;
    label.priority = airport.usable ? 30.0 : 10.0;
    scene.labels.push_back(std::move(label));
  }
}

}  // namespace

AltitudeRange altitudeRangeOf(const document::Situation& situation) {
  AltitudeRange range{0.0, 1000.0};
  if (situation.plan != nullptr) {
    range = {situation.plan->lowestAltitude(), situation.plan->highestAltitude()};
    for (const mission::DecisionPoint& point : situation.plan->plan().tour) {
      if (point.witness.site >= 0) {
        const auto site = static_cast<std::size_t>(point.witness.site);
        range.low = std::min(range.low, situation.plan->plan().sites[site].site.elevation.metres());
      }
    }
  } else if (situation.terrain != nullptr) {
    range = {situation.terrain->lowest, situation.terrain->highest};
  }
  range.high = std::max(range.high, range.low + 100.0);
  return range;
}

std::optional<SceneData> buildScene(const document::Situation& situation, std::shared_ptr<const TerrainModel> terrain, const SceneOptions& options,
                                    const SceneStyle& style, const std::stop_token& stop) {
  SceneData scene;
  scene.style = style;
  scene.terrain = std::move(terrain);
  scene.altitudes = altitudeRangeOf(situation);
  if (situation.plan != nullptr) {
    addTour(scene, situation, options);
    addSpirals(scene, situation);
    addHomePaths(scene, situation);
    if (options.allGlides) {
      addAllGlides(scene, situation, stop);
    }
  }
  addTargets(scene, situation);
  addAirspaces(scene, situation);
  if (options.runways && situation.sites != nullptr) {
    addRunways(scene, situation, options);
  }
  if (!options.labels) {
    scene.labels.clear();
  }
  return stop.stop_requested() ? std::nullopt : std::optional(std::move(scene));
}

SceneData buildCursorScene(const document::Situation& situation, std::shared_ptr<const TerrainModel> terrain, std::optional<double> distance,
                           int selectedTarget, const SceneStyle& style) {
  SceneData scene;
  scene.style = style;
  scene.terrain = std::move(terrain);
  scene.altitudes = altitudeRangeOf(situation);
  if (selectedTarget >= 0 && situation.targets != nullptr && selectedTarget < static_cast<int>(situation.targets->size())) {
    scene.poles.push_back(poleOf((*situation.targets)[static_cast<std::size_t>(selectedTarget)], scene, true));
  }
  if (situation.plan == nullptr || !distance) {
    return scene;
  }
  const style::ChartColors& colors = style::ChartColors::of(style.theme);
  const document::EngineOut glide = situation.plan->engineOutAt(*distance);
  const ScenePoint here = pointOf(glide.from);
  SceneLine line;
  line.points = pointsOf(glide);
  line.width = kCursorGlideWidth;
  line.casing = colors.cursor;
  line.showHidden = true;
  scene.lines.push_back(std::move(line));
  const double ground = surfaceAt(scene.terrain.get(), here.ground(), here.z);
  scene.lines.push_back({{{here.x, here.y, std::min(ground, here.z)}, here}, colors.cursor, 1.5, {}, false});
  scene.aircraft = SceneAircraft{here, glide.from.pose.heading};
  SceneLabel label;
  label.kind = SceneLabel::Kind::Cursor;
  label.anchor = here;
  label.text = style.units.altitudeMsl(here.z);
  if (std::isfinite(glide.from.safeAltitude)) {
    label.detail = QCoreApplication::translate("vp::scene3d::SceneData", "glide %1").arg(style.units.margin(glide.margin));
  }
  label.color = colors.text;
  label.priority = 100.0;
  scene.labels.push_back(std::move(label));
  if (glide.site >= 0) {
    const mission::SiteInFrame& site = situation.plan->plan().sites[static_cast<std::size_t>(glide.site)];
    SceneRunway runway;
    runway.threshold = site.pose;
    runway.elevation = site.site.elevation.metres();
    runway.length = site.site.length ? site.site.length->si() : kDefaultRunway;
    runway.width = site.site.width ? site.site.width->si() : kDefaultWidth;
    runway.isDestination = true;
    scene.runways.push_back(runway);
  }
  return scene;
}

Bounds interestOf(const document::Situation& situation) {
  Bounds box;
  if (situation.plan != nullptr) {
    for (const document::TourSample& sample : situation.plan->samples()) {
      box.add({sample.state.pose.x, sample.state.pose.y, sample.state.altitude});
    }
    for (const mission::DecisionPoint& point : situation.plan->plan().tour) {
      if (point.witness.site >= 0) {
        const mission::SiteInFrame& site = situation.plan->plan().sites[static_cast<std::size_t>(point.witness.site)];
        box.add({site.pose.x, site.pose.y, site.site.elevation.metres()});
      }
    }
  }
  if (!box.isEmpty() && situation.targets != nullptr) {
    for (const document::ShownTarget& target : *situation.targets) {
      if (target.altitude) {
        box.add({target.point.x, target.point.y, *target.altitude});
      }
    }
  }
  if (box.isEmpty() && situation.terrain != nullptr) {
    const geo::Box extent = situation.terrain->grid->extent();
    box.add({extent.minX, extent.minY, situation.terrain->lowest});
    box.add({extent.maxX, extent.maxY, situation.terrain->highest});
  }
  return box;
}

}  // namespace vp::scene3d
