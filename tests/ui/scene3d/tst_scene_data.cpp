#include "tests/ui/scene3d/scene_fixture.h"
#include "ui/scene3d/camera_presets.h"
#include "ui/scene3d/label_placement.h"
#include "ui/scene3d/scene_data.h"
#include "ui/scene3d/scene_picking.h"

#include <QTest>

#include <cmath>
#include <numbers>

namespace vp::scene3d {
namespace {

const document::Situation& situation() {
  static const document::Situation made = test::sceneSituation();
  return made;
}

std::shared_ptr<const TerrainModel> model() {
  static const auto made = TerrainModel::build(situation().terrain);
  return made;
}

SceneData sceneOf(const document::Situation& from, const SceneOptions& options = {}) {
  return buildScene(from, model(), options, {}).value();
}

CameraController controllerFor(Preset preset, double exaggeration = 1.0, std::optional<double> cursor = {}) {
  CameraController controller;
  controller.setPicture(1280.0, 720.0);
  controller.setGround(cameraGround(model(), exaggeration));
  controller.jumpTo(presetOrbit(preset, situation(), model().get(), exaggeration, cursor, controller));
  return controller;
}

}  // namespace

class TstSceneData : public QObject {
  Q_OBJECT

private slots:
  void tour_isThatOfThePlanView();
  void curtain_reachesFromTheTourToTheGround();
  void outdatedPlan_isGreyed();
  void allGlides_endAtTheRunway();
  void runwayEnds_ofOneRunwayAreDrawnOnce();
  void airspaces_areVolumesBetweenFloorAndCeiling();
  void excludedRunways_areWeakerAndCanBeLeftOut();
  void targets_standOnTheGround();
  void unplacedTarget_isShownWithTheReason();
  void cursorScene_isTheGlideFromThere();
  void spirals_leadDownToTheTargetAndBack();
  void altitudeRange_spansRunwaysAndTour();
  void presets_lookWhereTheySay();
  void presets_withoutAPlan_showTheTerrain();
  void pickTour_findsWhatIsUnderThePointer();
  void pickTour_leavesOutWhatTheGroundHides();
  void pickTarget_findsTheHead();
  void labels_neverCoverEachOther();
  void build_stopsWhenAsked();
};

void TstSceneData::tour_isThatOfThePlanView() {
  const SceneData scene = sceneOf(situation());
  const SceneLine& tour = scene.lines.front();
  const auto& samples = situation().plan->samples();
  QCOMPARE(tour.points.size(), samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    QCOMPARE(tour.points[i], (ScenePoint{samples[i].state.pose.x, samples[i].state.pose.y, samples[i].state.altitude}));
  }
  QCOMPARE(tour.color, style::ChartColors::of(style::Theme::Light).route);
}

void TstSceneData::curtain_reachesFromTheTourToTheGround() {
  const SceneData scene = sceneOf(situation());
  QCOMPARE(scene.curtains.size(), std::size_t{1});
  const SceneCurtain& curtain = scene.curtains.front();
  QCOMPARE(curtain.top.size(), scene.lines.front().points.size());
  for (std::size_t i = 0; i < curtain.top.size(); ++i) {
    QVERIFY(std::abs(curtain.bottom[i] - model()->surfaceAt(curtain.top[i].ground())) < 1e-6);
    QVERIFY(curtain.bottom[i] < curtain.top[i].z);
  }
  SceneOptions without;
  without.curtain = false;
  QVERIFY(sceneOf(situation(), without).curtains.empty());
}

void TstSceneData::outdatedPlan_isGreyed() {
  document::Situation old = situation();
  old.planIsCurrent = false;
  QCOMPARE(sceneOf(old).lines.front().color, style::ChartColors::of(style::Theme::Light).routeOutdated);
}

void TstSceneData::allGlides_endAtTheRunway() {
  SceneOptions options;
  options.allGlides = true;
  const SceneData scene = sceneOf(situation(), options);
  QCOMPARE(scene.lines.size(), 1 + situation().plan->plan().tour.size());
  for (std::size_t i = 1; i < scene.lines.size(); ++i) {
    QVERIFY(!scene.lines[i].color.isValid());  // by altitude
    const ScenePoint& end = scene.lines[i].points.back();
    QVERIFY(std::hypot(end.x - 0.0, end.y + 1000.0) < 1.0);
    for (std::size_t k = 1; k < scene.lines[i].points.size(); ++k) {
      QVERIFY(scene.lines[i].points[k].z <= scene.lines[i].points[k - 1].z);
    }
  }
}

void TstSceneData::runwayEnds_ofOneRunwayAreDrawnOnce() {
  document::Situation two = situation();
  auto sites = std::make_shared<std::vector<document::ShownSite>>(*situation().sites);
  sites->front().site.site.length = Length::fromSi(800.0);
  document::ShownSite other = sites->front();
  other.site.site.id = "TEST/27";
  other.site.site.runwayIdent = "27";
  other.site.pose = {800.0, -1000.0, std::numbers::pi};
  sites->push_back(other);
  two.sites = sites;
  const SceneData scene = sceneOf(two);
  QCOMPARE(scene.runways.size(), std::size_t{1});
  QVERIFY(scene.runways.front().usable && scene.runways.front().usableBack);
  QCOMPARE(scene.runways.front().length, 800.0);
  const auto count = [&](SceneLabel::Kind kind) {
    return std::count_if(scene.labels.begin(), scene.labels.end(), [kind](const SceneLabel& label) { return label.kind == kind; });
  };
  QCOMPARE(count(SceneLabel::Kind::Airport), 1);
  QCOMPARE(count(SceneLabel::Kind::RunwayEnd), 2);
}

void TstSceneData::airspaces_areVolumesBetweenFloorAndCeiling() {
  using Kind = mission::AirspaceLimit::Kind;
  document::Situation with = situation();
  const geo::LocalFrame& frame = with.terrain->frame;
  const auto zone = [&](mission::AirspaceUse use, mission::AirspaceLimit floor, mission::AirspaceLimit ceiling) {
    mission::Airspace airspace{"ZONE", "R", floor, ceiling, {}};
    for (const geo::Point& corner : {geo::Point{-900.0, -500.0}, {900.0, -500.0}, {900.0, 700.0}, {0.0, 0.0}, {-900.0, 700.0}}) {
      airspace.outline.push_back(frame.toLatLon(corner));
    }
    mission::AirspaceSettings settings;
    settings.otherwise = use;
    return document::shownAirspace(airspace, settings, frame);
  };
  with.airspaces = std::make_shared<const std::vector<document::ShownAirspace>>(std::vector<document::ShownAirspace>{
      zone(mission::AirspaceUse::Forbid, {Kind::Msl, 700.0}, {Kind::Msl, 1100.0}),
      zone(mission::AirspaceUse::Warn, {Kind::AboveGround, 300.0}, {Kind::Unlimited, 0.0}), zone(mission::AirspaceUse::Show, {}, {})});
  const SceneData scene = sceneOf(with);
  QCOMPARE(scene.volumes.size(), std::size_t{2});
  const SceneVolume& forbidden = scene.volumes.front();
  QCOMPARE(forbidden.top.size(), std::size_t{5});
  for (std::size_t i = 0; i < forbidden.top.size(); ++i) {
    QCOMPARE(forbidden.top[i].z, 1100.0);
    QCOMPARE(forbidden.bottom[i], 700.0);
  }
  QCOMPARE(forbidden.color, style::ChartColors::airspace(style::Theme::Light, "R"));
  const SceneVolume& warned = scene.volumes.back();
  QVERIFY(warned.opacity < forbidden.opacity);
  QVERIFY(warned.top.size() > 20);  // follows the ground between its corners
  for (std::size_t i = 0; i < warned.top.size(); ++i) {
    QVERIFY(std::abs(warned.bottom[i] - 300.0 - model()->surfaceAt(warned.top[i].ground())) < 1.0);
    QVERIFY(warned.top[i].z > situation().terrain->highest);
  }
  const auto isZone = [](const SceneLabel& label) { return label.kind == SceneLabel::Kind::Airspace && label.text == QStringLiteral("R ZONE"); };
  QCOMPARE(std::count_if(scene.labels.begin(), scene.labels.end(), isZone), 2);
}

void TstSceneData::excludedRunways_areWeakerAndCanBeLeftOut() {
  document::Situation excluded = situation();
  auto sites = std::make_shared<std::vector<document::ShownSite>>(*situation().sites);
  sites->front().usable = false;
  excluded.sites = sites;
  const SceneData scene = sceneOf(excluded);
  QCOMPARE(scene.runways.size(), std::size_t{1});
  QVERIFY(!scene.runways.front().usable);
  SceneOptions without;
  without.excludedRunways = false;
  QVERIFY(sceneOf(excluded, without).runways.empty());
}

void TstSceneData::targets_standOnTheGround() {
  const SceneData scene = sceneOf(situation());
  QCOMPARE(scene.poles.size(), std::size_t{2});
  for (std::size_t i = 0; i < 2; ++i) {
    const document::ShownTarget& target = (*situation().targets)[i];
    QCOMPARE(scene.poles[i].foot.ground(), target.point);
    QVERIFY(std::abs(scene.poles[i].foot.z - model()->surfaceAt(target.point)) < 1e-6);
    QVERIFY(scene.poles[i].head.z >= *target.altitude);
  }
  QCOMPARE(scene.labels.front().text, QStringLiteral("mill"));
  QVERIFY(scene.labels.front().detail.endsWith(QStringLiteral("ft MSL")));
}

void TstSceneData::unplacedTarget_isShownWithTheReason() {
  document::Situation lost = situation();
  auto targets = std::make_shared<std::vector<document::ShownTarget>>(*situation().targets);
  targets->front().altitude.reset();
  lost.targets = targets;
  const SceneData scene = sceneOf(lost);
  QCOMPARE(scene.poles.size(), std::size_t{2});
  QCOMPARE(scene.labels.front().detail, QStringLiteral("no terrain here"));
}

void TstSceneData::cursorScene_isTheGlideFromThere() {
  const SceneData scene = buildCursorScene(situation(), model(), 1234.5, -1, {});
  const document::EngineOut glide = situation().plan->engineOutAt(1234.5);
  QCOMPARE(scene.lines.front().points.size(), glide.path.size());
  QCOMPARE(scene.lines.front().points.back(), (ScenePoint{glide.path.back().pose.x, glide.path.back().pose.y, glide.path.back().altitude}));
  QVERIFY(scene.aircraft.has_value());
  QCOMPARE(scene.aircraft->position, scene.lines.front().points.front());
  QCOMPARE(scene.runways.size(), std::size_t{1});
  QVERIFY(scene.runways.front().isDestination);
  QVERIFY(buildCursorScene(situation(), model(), std::nullopt, -1, {}).lines.empty());
  document::Situation noPlan = situation();
  noPlan.plan = nullptr;
  QVERIFY(buildCursorScene(noPlan, model(), 10.0, -1, {}).lines.empty());
  const SceneData selected = buildCursorScene(noPlan, model(), std::nullopt, 1, {});
  QCOMPARE(selected.poles.size(), std::size_t{1});
  QVERIFY(selected.poles.front().isSelected);
  QCOMPARE(selected.poles.front().head.ground(), (*noPlan.targets)[1].point);
  QVERIFY(buildCursorScene(noPlan, model(), std::nullopt, 99, {}).poles.empty());
}

void TstSceneData::spirals_leadDownToTheTargetAndBack() {
  document::Situation low = situation();
  auto plan = std::make_shared<mission::Plan>(situation().plan->plan());
  plan->spirals.push_back({0, 900.0, 110.0, flight::Turn::Left, 150.0, 3, 2});
  low.plan = std::make_shared<const document::PlanView>(plan, situation().terrain);
  const SceneData scene = sceneOf(low);
  QCOMPARE(scene.lines.size(), std::size_t{2});
  const std::vector<ScenePoint>& spiral = scene.lines.back().points;
  const auto lowest = std::min_element(spiral.begin(), spiral.end(), [](const ScenePoint& a, const ScenePoint& b) { return a.z < b.z; });
  QCOMPARE(lowest->z, 110.0);
  QCOMPARE(spiral.front().z, 900.0);
  QVERIFY(std::abs(spiral.back().z - 900.0) < 1e-9);
  for (const ScenePoint& p : spiral) {  // all on one circle through the target
    QVERIFY(geo::distance(p.ground(), spiral.front().ground()) <= 300.0 + 1e-6);
  }
}

void TstSceneData::altitudeRange_spansRunwaysAndTour() {
  const AltitudeRange range = altitudeRangeOf(situation());
  QCOMPARE(range.low, 0.0);  // the runway
  QCOMPARE(range.high, situation().plan->highestAltitude());
  QCOMPARE(range.fraction(range.low), 0.0);
  QCOMPARE(range.fraction(range.high), 1.0);
}

void TstSceneData::presets_lookWhereTheySay() {
  const CameraState top = controllerFor(Preset::Top).camera();
  QVERIFY(top.forward.z < -0.99 && top.up.y > 0.99);
  const CameraState north = controllerFor(Preset::North).camera();
  QVERIFY(north.forward.y > 0.5 && std::abs(north.forward.x) < 1e-9);
  for (const document::TourSample& sample : situation().plan->samples()) {
    const auto at = north.project({sample.state.pose.x, sample.state.pose.y, sample.state.altitude});
    QVERIFY(at && at->x > 0.0 && at->x < 1280.0 && at->y > 0.0 && at->y < 720.0);
  }
  const document::TourState state = situation().plan->at(700.0);
  const CameraController along = controllerFor(Preset::AlongTour, 2.0, 700.0);
  QVERIFY(length(along.orbit().pivot - Vec3{state.pose.x, state.pose.y, 2.0 * state.altitude}) < 1e-9);
  QVERIFY(std::cos(along.orbit().azimuth - state.pose.heading) > 0.9);
  const CameraState runway = controllerFor(Preset::FromRunway).camera();
  QVERIFY(runway.eye.x > 0.0 && runway.eye.x < 2000.0 && std::abs(runway.eye.y + 1000.0) < 1.0);  // above it, past the threshold
  QVERIFY(runway.forward.x < -0.9);                                                               // against landing eastwards
}

void TstSceneData::presets_withoutAPlan_showTheTerrain() {
  document::Situation bare;
  bare.terrain = situation().terrain;
  CameraController controller;
  controller.setPicture(1280.0, 720.0);
  controller.setGround(cameraGround(model(), 1.0));
  for (const Preset preset : {Preset::Top, Preset::North, Preset::AlongTour, Preset::FromRunway}) {
    const CameraOrbit orbit = presetOrbit(preset, bare, model().get(), 1.0, {}, controller);
    controller.jumpTo(orbit);
    for (const Vec3 corner : {Vec3{-6000.0, -6000.0, 100.0}, Vec3{5000.0, -6000.0, 100.0}, Vec3{-6000.0, 6000.0, 100.0}}) {
      const auto at = controller.camera().project(corner);
      QVERIFY(at && at->x > 0.0 && at->x < 1280.0 && at->y > 0.0 && at->y < 720.0);
    }
    QVERIFY(orbit.distance < 40000.0);
  }
}

void TstSceneData::pickTour_findsWhatIsUnderThePointer() {
  const CameraState camera = controllerFor(Preset::North).camera();
  for (const double distance : {120.0, 1500.0, 3210.0, 5000.0}) {
    const document::TourState state = situation().plan->at(distance);
    const auto at = camera.project({state.pose.x, state.pose.y, state.altitude});
    QVERIFY(at.has_value());
    const auto picked = pickTour(*situation().plan, model().get(), camera, 1.0, at->x + 2.0, at->y - 2.0, 12.0);
    QVERIFY(picked.has_value());
    QVERIFY2(std::abs(*picked - distance) < 40.0, qPrintable(QStringLiteral("%1 for %2").arg(*picked).arg(distance)));
    QVERIFY(!pickTour(*situation().plan, model().get(), camera, 1.0, at->x, at->y - 300.0, 12.0).has_value());
  }
}

void TstSceneData::pickTour_leavesOutWhatTheGroundHides() {
  CameraState camera = controllerFor(Preset::North).camera();
  camera.eye = {-5200.0, -5000.0, 500.0};  // behind the mountain
  camera.forward = normalized(Vec3{-500.0, 1000.0, 800.0} - camera.eye);
  camera.up = normalized(cross(cross(camera.forward, {0.0, 0.0, 1.0}), camera.forward));
  const document::TourState state = situation().plan->at(600.0);
  const auto at = camera.project({state.pose.x, state.pose.y, state.altitude});
  QVERIFY(at.has_value());
  QVERIFY(!model()->isClear(camera.eye, {state.pose.x, state.pose.y, state.altitude}, 1.0));
  QVERIFY(!pickTour(*situation().plan, model().get(), camera, 1.0, at->x, at->y, 3.0).has_value());
  QVERIFY(pickTour(*situation().plan, nullptr, camera, 1.0, at->x, at->y, 3.0).has_value());
}

void TstSceneData::pickTarget_findsTheHead() {
  const CameraState camera = controllerFor(Preset::North).camera();
  const document::ShownTarget& target = (*situation().targets)[1];
  const auto at = camera.project({target.point.x, target.point.y, *target.altitude});
  QCOMPARE(pickTarget(*situation().targets, model().get(), camera, 1.0, at->x + 3.0, at->y, 12.0).value_or(-1), 1);
  QVERIFY(!pickTarget(*situation().targets, model().get(), camera, 1.0, 5.0, 5.0, 12.0).has_value());
}

void TstSceneData::labels_neverCoverEachOther() {
  SceneData scene;
  for (int i = 0; i < 40; ++i) {
    SceneLabel label;
    label.anchor = {100.0 * i, 50.0 * (i % 5), 300.0};
    label.text = QStringLiteral("T%1").arg(i);
    label.detail = QStringLiteral("1 234 ft MSL");
    label.color = Qt::black;
    label.priority = i == 17 ? 60.0 : 50.0;
    scene.labels.push_back(label);
  }
  const LabelAtlas atlas = buildLabelAtlas(scene, 1.0);
  QVERIFY(!atlas.image.isNull());
  CameraState camera;
  camera.eye = {2000.0, -6000.0, 4000.0};
  camera.forward = normalized(Vec3{2000.0, 0.0, 300.0} - camera.eye);
  camera.up = normalized(cross(cross(camera.forward, {0.0, 0.0, 1.0}), camera.forward));
  const auto placed = placeLabels({&atlas}, camera, 1.0, {}, [](Vec3) { return true; });
  QVERIFY(placed.size() > 5 && placed.size() < 40);
  for (std::size_t a = 0; a < placed.size(); ++a) {
    const QRectF first(QPointF(placed[a].corners[0][0], placed[a].corners[0][1]), QPointF(placed[a].corners[2][0], placed[a].corners[2][1]));
    for (std::size_t b = a + 1; b < placed.size(); ++b) {
      const QRectF second(QPointF(placed[b].corners[0][0], placed[b].corners[0][1]), QPointF(placed[b].corners[2][0], placed[b].corners[2][1]));
      QVERIFY(!first.intersects(second));
    }
  }
  QCOMPARE(placed.front().piece, &atlas.items[17].full);  // the most important has its place, and its second line
  for (const PlacedLabel& label : placed) {               // none is cut off
    QVERIFY(label.corners[0][0] >= 0.0 && label.corners[0][1] >= 0.0);
    QVERIFY(label.corners[2][0] <= camera.width && label.corners[2][1] <= camera.height);
  }
  const QRectF legend(0.0, 0.0, 0.5 * camera.width, camera.height);
  for (const PlacedLabel& label : placeLabels({&atlas}, camera, 1.0, {legend}, [](Vec3) { return true; })) {
    QVERIFY(label.corners[0][0] >= legend.right());
  }
  for (const PlacedLabel& label : placeLabels({&atlas}, camera, 1.0, {}, [](Vec3) { return false; })) {
    QVERIFY(label.opacity < 0.5);
  }
}

void TstSceneData::build_stopsWhenAsked() {
  std::stop_source source;
  source.request_stop();
  QVERIFY(!buildScene(situation(), model(), {}, {}, source.get_token()).has_value());
}

}  // namespace vp::scene3d

QTEST_MAIN(vp::scene3d::TstSceneData)
#include "tst_scene_data.moc"
