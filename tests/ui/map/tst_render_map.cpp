// What a picture of the map shows: looked for where the data says it is, without reference pictures.
#include "tests/ui/map/map_fixture.h"
#include "ui/map/margin_pattern.h"
#include "ui/map/render_map.h"
#include "ui/map/safe_altitude_layer.h"
#include "ui/style/short_name.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace vp;
using namespace vp::map;
using namespace vp::map::testing;

namespace {

constexpr QSize kSize(900, 700);

MapScene sceneOf(document::Situation situation) {
  MapScene scene;
  scene.situation = std::move(situation);
  scene.options.contours = false;
  return scene;
}

MapCamera cameraOf(const MapScene& scene) {
  return homeCamera(scene.situation, kSize);
}

/// Share of the tour's samples that have a colour next to them.
double tourShare(const MapScene& scene, const QImage& image, const QColor& color, int reach = 2) {
  const MapCamera camera = cameraOf(scene);
  const auto& samples = scene.situation.plan->samples();
  const auto found = std::count_if(samples.begin(), samples.end(), [&](const document::TourSample& sample) {
    return hasColorNear(image, camera.toScreen(sample.state.pose.point()), reach, color);
  });
  return static_cast<double>(found) / static_cast<double>(samples.size());
}

}  // namespace

class TestRenderMap : public QObject {
  Q_OBJECT

private slots:
  void tour_isMagentaWhereThePlanSaysItIs_data() {
    QTest::addColumn<int>("theme");
    QTest::newRow("light") << static_cast<int>(style::Theme::Light);
    QTest::newRow("dark") << static_cast<int>(style::Theme::Dark);
  }
  void tour_isMagentaWhereThePlanSaysItIs() {
    QFETCH(int, theme);
    MapScene scene = sceneOf(racetrack());
    scene.theme = static_cast<style::Theme>(theme);
    const QImage image = renderMap(scene, kSize, 1.0);
    QCOMPARE(image.size(), kSize);
    QVERIFY(tourShare(scene, image, scene.colors().route) > 0.93);  // target symbols cover the rest
    scene.situation.plan.reset();
    const QImage without = renderMap(scene, kSize, 1.0);
    QCOMPARE(countColor(without, scene.colors().route), 0);
  }

  void tour_underHighPixelDensity_isTheSamePicture() {
    const MapScene scene = sceneOf(racetrack());
    const QImage image = renderMap(scene, kSize, 2.0);
    QCOMPARE(image.size(), kSize * 2);
    const MapCamera camera = cameraOf(scene);
    int found = 0;
    for (const document::TourSample& sample : scene.situation.plan->samples()) {
      found += hasColorNear(image, camera.toScreen(sample.state.pose.point()) * 2.0, 3, scene.colors().route) ? 1 : 0;
    }
    QVERIFY(found > 0.93 * static_cast<double>(scene.situation.plan->samples().size()));
  }

  void outdatedPlan_isGreyBrokenAndSaysSo() {
    MapScene scene = sceneOf(racetrack());
    const int plates = countColor(renderMap(scene, kSize, 1.0), scene.colors().panel, 2);
    scene.situation.planIsCurrent = false;
    const QImage image = renderMap(scene, kSize, 1.0);
    QCOMPARE(countColor(image, scene.colors().route), 0);
    const double grey = tourShare(scene, image, scene.colors().routeOutdated, 1);
    QVERIFY2(grey > 0.4 && grey < 0.95, qPrintable(QString::number(grey)));  // dashed: neither all nor nothing
    QVERIFY(countColor(image, scene.colors().panel, 2) > plates + 200);      // the plate that says so
  }

  void unverifiedPlan_saysSo() {
    MapScene scene = sceneOf(racetrack());
    const int plates = countColor(renderMap(scene, kSize, 1.0), scene.colors().panel, 2);
    auto plan = std::make_shared<mission::Plan>(scene.situation.plan->plan());
    plan->certificate.reset();
    scene.situation.plan = std::make_shared<const document::PlanView>(plan, scene.situation.terrain);
    QVERIFY(countColor(renderMap(scene, kSize, 1.0), scene.colors().panel, 2) > plates + 200);
  }

  void glide_isDrawnWhereTheDataSaysInTheColourOfItsMargin_data() {
    QTest::addColumn<double>("altitude");
    QTest::newRow("ample") << 1000.0;
    QTest::newRow("modest") << 900.0;
    QTest::newRow("tight") << 810.0;
    QTest::newRow("violated") << 790.0;
  }
  void glide_isDrawnWhereTheDataSaysInTheColourOfItsMargin() {
    QFETCH(double, altitude);
    MapScene scene = sceneOf(racetrack(altitude));
    scene.options.legend = false;
    const QImage before = renderMap(scene, kSize, 1.0);
    scene.cursor = 1800.0;
    const QImage image = renderMap(scene, kSize, 1.0);
    const document::EngineOut glide = scene.situation.plan->engineOutAt(*scene.cursor);
    const QColor color = scene.colors().glide(altitude - 800.0);
    const MapCamera camera = cameraOf(scene);
    int found = 0;
    int changed = 0;
    int points = 0;
    for (const document::GlidePoint& point : glide.path) {
      const QPointF at = camera.toScreen(point.pose.point());
      if (point.distance > 150.0) {  // beside the tour and clear of the aircraft
        ++points;
        found += hasColorNear(image, at, 1, color) ? 1 : 0;
        changed += image.pixel(at.toPoint()) != before.pixel(at.toPoint()) ? 1 : 0;
      }
    }
    QVERIFY(points > 20);
    QCOMPARE(changed, points);
    const double share = static_cast<double>(found) / points;
    const bool isSolid = marginClass(altitude - 800.0) == MarginClass::Ample;
    QVERIFY2(isSolid ? share > 0.97 : share > 0.3 && share < 0.97, qPrintable(QString::number(share)));
  }

  void roundedMargin_isTightAndNoViolation() {
    const style::ChartColors& colors = style::ChartColors::of(style::Theme::Light);
    QVERIFY(marginClass(-0.0005) == MarginClass::Tight);  // a verified tour may lie on the lowest safe altitude
    QCOMPARE(marginPen(-0.0005, colors, 2.0).color(), colors.glide(0.0));
    QVERIFY(marginClass(-0.01) == MarginClass::Violated);
    QCOMPARE(marginPen(-0.01, colors, 2.0).color(), colors.violation);
  }

  void marginPens_differWithoutColour() {
    const style::ChartColors& colors = style::ChartColors::of(style::Theme::Light);
    QList<QList<qreal>> patterns;
    for (const double margin : {-5.0, 10.0, 100.0, 200.0}) {
      patterns.push_back(marginPen(margin, colors, 2.0).dashPattern());
    }
    for (qsizetype i = 0; i < patterns.size(); ++i) {
      for (qsizetype j = 0; j < i; ++j) {
        QVERIFY(patterns[i] != patterns[j]);
      }
    }
  }

  void marginOverlay_colorsTheTour() {
    MapScene scene = sceneOf(racetrack(830.0));
    scene.options.tourMargin = true;
    scene.options.legend = false;
    const QImage image = renderMap(scene, kSize, 1.0);
    QVERIFY(tourShare(scene, image, scene.colors().glide(30.0), 4) > 0.9);
    QVERIFY(!hasColorNear(image, cameraOf(scene).toScreen({-1500.0, 0.0}), 20, scene.colors().glide(30.0)));
  }

  void targets_areDrawnWithMarksOfProblems() {
    MapScene scene = sceneOf(racetrack());
    scene.situation.plan.reset();
    const MapCamera camera = MapCamera({0.0, 0.0}, 10.0, kSize);
    const QImage image = renderMap(scene, camera, 1.0);
    for (const document::ShownTarget& target : *scene.situation.targets) {
      QVERIFY(hasColorNear(image, camera.toScreen(target.point), 2, scene.colors().target));
    }
    QCOMPARE(countColor(image, scene.colors().glideTight), 0);
    auto targets = *scene.situation.targets;
    targets[1].problem = "Unknown ground.";
    scene.situation.targets = std::make_shared<const std::vector<document::ShownTarget>>(targets);
    QVERIFY(hasColorNear(renderMap(scene, camera, 1.0), camera.toScreen(targets[1].point) + QPointF(11.0, -11.0), 5, scene.colors().glideTight));
  }

  void longNames_areShortenedInTheDrawing() {
    const auto pictureOf = [](const std::string& name) {
      MapScene scene = sceneOf(racetrack());
      auto targets = *scene.situation.targets;
      targets[0].target.name = name;
      scene.situation.targets = std::make_shared<const std::vector<document::ShownTarget>>(targets);
      auto sites = *scene.situation.sites;
      for (document::ShownSite& site : sites) {
        site.site.site.airportName = name;
      }
      scene.situation.sites = std::make_shared<const std::vector<document::ShownSite>>(sites);
      return renderMap(scene, kSize, 1.0);
    };
    const std::string name = "Wolkenspitze north-eastern glacier tongue station number seven";
    QCOMPARE(pictureOf(name), pictureOf(style::shortName(QString::fromStdString(name)).toStdString()));
    QVERIFY(pictureOf(name) != pictureOf("T7"));
  }

  void runway_isDrawnToScaleAndDirection() {
    MapScene scene = sceneOf(racetrack());
    const document::ShownSite& site = scene.situation.sites->front();  // 800 m to the east
    const MapCamera camera({-3200.0, -3000.0}, 4.0, kSize);
    const QImage image = renderMap(scene, camera, 1.0);
    for (double along = 20.0; along < 790.0; along += 40.0) {
      QVERIFY(hasColorNear(image, camera.toScreen({site.site.pose.x + along, site.site.pose.y}), 1, scene.colors().runway));
    }
    QVERIFY(!hasColorNear(image, camera.toScreen({site.site.pose.x + 400.0, site.site.pose.y + 60.0}), 3, scene.colors().runway));
    // 30 m wide at 4 m per pixel
    const QPointF middle = camera.toScreen({site.site.pose.x + 430.0, site.site.pose.y});
    int across = 0;
    for (int dy = -12; dy <= 12; ++dy) {
      across += difference(image.pixel(middle.toPoint() + QPoint(0, dy)), scene.colors().runway.rgb()) < 60 ? 1 : 0;
    }
    QVERIFY2(across >= 6 && across <= 9, qPrintable(QString::number(across)));
  }

  void runway_underSmallScale_isASymbol_excludedOnesWeaker() {
    MapScene scene = sceneOf(racetrack());
    scene.situation.plan.reset();
    scene.situation.targets.reset();
    const MapCamera camera({0.0, 0.0}, 80.0, {300.0, 300.0});
    const QImage image = renderMap(scene, camera, 1.0);
    QVERIFY(hasColorNear(image, camera.toScreen(scene.situation.sites->front().site.pose.point()), 3, scene.colors().runway));
    const QPointF excluded = camera.toScreen(scene.situation.sites->back().site.pose.point());
    QVERIFY(hasColorNear(image, excluded, 3, scene.colors().runwayExcluded, 40));
    QVERIFY(!hasColorNear(image, excluded, 8, scene.colors().runway, 40));
    scene.options.excludedSites = false;
    QVERIFY(!hasColorNear(renderMap(scene, camera, 1.0), excluded, 8, scene.colors().runwayExcluded, 25));
  }

  void safeAltitude_isTintedByAltitudeAndHatchedWithoutGlide() {
    MapScene scene = sceneOf(racetrack());
    scene.situation.plan.reset();
    scene.situation.sites.reset();
    scene.situation.targets.reset();
    scene.options.legend = false;
    scene.situation.safeAltitudes =
        fieldOf([](double x, double y, int) { return y > 3000.0 ? std::numeric_limits<float>::infinity() : static_cast<float>(2000.0 + 0.2 * x); });
    const MapCamera camera({0.0, 0.0}, 20.0, {600.0, 560.0});
    const QImage plain = renderMap(scene, camera, 1.0);
    scene.options.safeAltitude = true;
    const QImage image = renderMap(scene, camera, 1.0);
    const auto middle = [&](double x) {
      // half of the tint, half of the ground
      const QColor ground = plain.pixelColor(camera.toScreen({x, -1700.0}).toPoint());
      const QColor tint = style::ChartColors::altitudeScale((x + 4875.0) / 9750.0);
      return QColor((ground.red() + tint.red()) / 2, (ground.green() + tint.green()) / 2, (ground.blue() + tint.blue()) / 2);
    };
    for (const double x : {-4100.0, -1333.0, 1500.0, 3777.0}) {
      QVERIFY2(hasColorNear(image, camera.toScreen({x, -1700.0}), 1, middle(x), 8), qPrintable(QString::number(x)));
    }
    // hatched where no glide arrives: light and dark pixels next to each other
    int lines = 0;
    for (int x = 200; x < 400; ++x) {
      const int y = static_cast<int>(camera.toScreen({0.0, 4200.0}).y());
      lines += qGray(image.pixel(x, y)) + 20 < qGray(image.pixel(x + 1, y)) ? 1 : 0;
    }
    QVERIFY2(lines >= 10, qPrintable(QString::number(lines)));
    QVERIFY(difference(image.pixel(camera.toScreen({0.0, 4200.0}).toPoint()), plain.pixel(camera.toScreen({0.0, 4200.0}).toPoint())) > 10);
  }

  void safeAltitude_underAChosenCourse_usesThatHeading() {
    const auto field = fieldOf([](double, double, int heading) { return 1000.0F + 100.0F * static_cast<float>(heading); });
    const auto at = [&](std::optional<double> course) { return SafeAltitudeLayer(*field, course).at({0.0, 0.0}).value(); };
    QCOMPARE(at(std::nullopt), 1300.0);
    QCOMPARE(at(90.0), 1000.0);  // east is heading 0
    QCOMPARE(at(0.0), 1100.0);   // north is a quarter turn on
    QCOMPARE(at(270.0), 1200.0);
    QCOMPARE(at(180.0), 1300.0);
    QCOMPARE(at(45.0), 1100.0);  // between two headings the higher counts
    QVERIFY(!SafeAltitudeLayer(*field, {}).at({5100.0, 0.0}));
  }

  void reachableArea_isMarkedOnItsSideOfTheEdgeOnly() {
    MapScene scene = sceneOf(racetrack());
    scene.situation.plan.reset();
    scene.situation.sites.reset();
    scene.situation.targets.reset();
    scene.options.legend = false;
    scene.situation.safeAltitudes = fieldOf([](double x, double, int) { return static_cast<float>(2000.0 + 0.2 * x); });
    const MapCamera camera({0.0, 0.0}, 20.0, {600.0, 560.0});
    const QImage plain = renderMap(scene, camera, 1.0);
    scene.options.reachableFrom = 2200.0;  // up to x = 1000
    const QImage image = renderMap(scene, camera, 1.0);
    QVERIFY(hasColorNear(image, camera.toScreen({1000.0, 0.0}), 2, scene.colors().glideAmple));
    const QPoint outside = camera.toScreen({2500.0, 300.0}).toPoint();
    const QPoint inside = camera.toScreen({-1500.0, 300.0}).toPoint();
    QCOMPARE(image.pixel(outside), plain.pixel(outside));
    QVERIFY(difference(image.pixel(inside), plain.pixel(inside)) > 8);
  }

  void sketch_drawsSafeLegsSolidAndBoundsDashed() {
    MapScene scene = sceneOf(racetrack());
    scene.situation.plan.reset();
    scene.situation.sites.reset();
    scene.situation.targets.reset();
    scene.options.legend = false;
    auto sketch = std::make_shared<document::PlanningSketch>();
    auto legs = std::make_shared<std::vector<document::PlanningSketch::Leg>>();
    legs->push_back({{{-4000.0, 1000.0}, {4000.0, 1000.0}}, true});
    legs->push_back({{{-4000.0, -1000.0}, {4000.0, -1000.0}}, false});
    sketch->tour = legs;
    auto roadmap = std::make_shared<std::vector<document::PlanningSketch::Edge>>();
    roadmap->push_back({{-4000.0, 3000.0}, {4000.0, 3000.0}, 900.0F});
    sketch->roadmap = roadmap;
    const MapCamera camera({0.0, 0.0}, 20.0, {600.0, 560.0});
    const QImage without = renderMap(scene, camera, 1.0);
    scene.situation.sketch = sketch;
    const QImage image = renderMap(scene, camera, 1.0);
    const auto shareAlong = [&](double y) {
      int found = 0;
      for (double x = -3500.0; x <= 3500.0; x += 50.0) {
        found += hasColorNear(image, camera.toScreen({x, y}), 0, scene.colors().route, 90) ? 1 : 0;
      }
      return found / 141.0;
    };
    QVERIFY(shareAlong(1000.0) > 0.98);
    QVERIFY(shareAlong(-1000.0) > 0.3 && shareAlong(-1000.0) < 0.8);
    const QPoint edge = camera.toScreen({100.0, 3000.0}).toPoint();
    QVERIFY(image.pixel(edge) != without.pixel(edge) || image.pixel(edge - QPoint(0, 1)) != without.pixel(edge - QPoint(0, 1)));
  }

  void nothingAtAll_isStillAPicture() {
    const QImage image = renderMap(MapScene{}, QSize(300, 200), 1.0);
    QCOMPARE(image.size(), QSize(300, 200));
  }

  void home_showsTourTargetsAndTheRunwaysInUse() {
    const document::Situation situation = racetrack();
    const MapCamera camera = homeCamera(situation, kSize);
    for (const document::TourSample& sample : situation.plan->samples()) {
      QVERIFY(camera.screen().contains(camera.toScreen(sample.state.pose.point())));
    }
    QVERIFY(camera.screen().contains(camera.toScreen(situation.sites->front().site.pose.point())));
  }
};

QTEST_MAIN(TestRenderMap)
#include "tst_render_map.moc"
