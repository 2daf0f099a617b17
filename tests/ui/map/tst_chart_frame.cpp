// Scale bar, legend, north arrow and message as they are really drawn: inside their boxes, the boxes apart, at all sizes of the
// map, units, fonts and pixel ratios. With VOLPLANE_TEST_PICTURES the maps are kept to be looked at.
#include "tests/support/planned_tour.h"
#include "tests/ui/map/map_fixture.h"
#include "ui/map/chart_frame.h"
#include "ui/map/engine_out_label.h"
#include "ui/map/map_renderer.h"
#include "ui/map/render_map.h"
#include "ui/map/site_marks.h"

#include <QGuiApplication>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace vp;
using namespace vp::map;
using namespace vp::map::testing;

namespace {

const QString kMessage = QStringLiteral("No targets yet: right-click the map, or use the add-target tool and click");

/// Everything that a legend can hold.
MapScene fullScene(style::UnitSystem units = style::UnitSystem::Aviation) {
  MapScene scene;
  scene.situation = racetrack(790.0);  // with a glide that does not arrive
  scene.situation.safeAltitudes = fieldOf([](double x, double y, int) { return static_cast<float>(2400.0 + 0.2 * x - 0.1 * y); });
  scene.options.safeAltitude = true;
  scene.options.reachableFrom = 2500.0;
  scene.options.tourMargin = true;
  scene.options.decisionPoints = true;
  scene.units = style::Units(units);
  return scene;
}

/// A picture with nothing but the furniture, none of it outside its boxes.
bool staysInItsBoxes(const ChartFrame& frame, QSizeF map, double ratio) {
  QImage image((map * ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(ratio);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  frame.draw(painter);
  painter.setCompositionMode(QPainter::CompositionMode_Clear);
  for (const QRectF& box : frame.covered()) {
    painter.fillRect(box.adjusted(-1.0, -1.0, 1.0, 1.0), Qt::transparent);  // with its border
  }
  painter.end();
  QImage blank(image.size(), image.format());
  blank.fill(Qt::transparent);
  blank.setDevicePixelRatio(ratio);
  return image == blank;
}

bool areApart(const std::vector<QRectF>& boxes, QSizeF map) {
  const QRectF whole = QRectF(QPointF(), map).adjusted(1.0, 1.0, -1.0, -1.0);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!whole.contains(boxes[i])) {
      return false;
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (boxes[i].adjusted(-2.0, -2.0, 2.0, 2.0).intersects(boxes[k])) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

class TestChartFrame : public QObject {
  Q_OBJECT

private slots:
  void init() { original_ = QGuiApplication::font(); }
  void cleanup() { QGuiApplication::setFont(original_); }

  void furniture_isDrawnInsideItsBoxes_data() {
    QTest::addColumn<int>("stretch");
    QTest::addColumn<int>("units");
    QTest::newRow("aviation") << 100 << static_cast<int>(style::UnitSystem::Aviation);
    QTest::newRow("metric") << 100 << static_cast<int>(style::UnitSystem::Metric);
    QTest::newRow("wide letters") << 180 << static_cast<int>(style::UnitSystem::Aviation);
  }
  void furniture_isDrawnInsideItsBoxes() {
    QFETCH(int, stretch);
    QFETCH(int, units);
    QFont font = original_;
    font.setStretch(stretch);
    QGuiApplication::setFont(font);
    const MapScene scene = fullScene(static_cast<style::UnitSystem>(units));
    const SafeAltitudeLayer layer(*scene.situation.safeAltitudes, {});
    for (const QSizeF& map : {QSizeF(320.0, 240.0), QSizeF(420.0, 600.0), QSizeF(470.0, 300.0), QSizeF(1024.0, 700.0), QSizeF(2560.0, 1440.0)}) {
      for (const double metresPerPixel : {0.05, 0.7, 11.0, 240.0, 5000.0}) {
        const MapCamera camera({0.0, 0.0}, metresPerPixel, map);
        const ChartFrame frame(scene, camera, &layer, kMessage);
        const QByteArray words = QStringLiteral("%1 x %2, %3 m/px").arg(map.width()).arg(map.height()).arg(metresPerPixel).toUtf8();
        QVERIFY2(areApart(frame.covered(), map), words);
        QVERIFY2(frame.layout().message.has_value(), words);
        for (const double ratio : {1.0, 1.5, 2.0}) {
          QVERIFY2(staysInItsBoxes(frame, map, ratio), words);
        }
      }
    }
  }

  void sizesOfTheMap_keepTheBoxesApart() {
    const MapScene scene = fullScene();
    const SafeAltitudeLayer layer(*scene.situation.safeAltitudes, {});
    for (int width = 320; width <= 4000; width += width < 900 ? 7 : 211) {
      for (int height = 240; height <= 2400; height += height < 700 ? 23 : 301) {
        for (const QString& message : {QString(), kMessage}) {
          const QSizeF map(width, height);
          const MapCamera camera({0.0, 0.0}, 20.0, map);
          const ChartFrame frame(scene, camera, &layer, message);
          QVERIFY2(areApart(frame.covered(), map), qPrintable(QStringLiteral("%1 x %2").arg(width).arg(height)));
          QVERIFY2(frame.layout().legend.has_value(), qPrintable(QStringLiteral("%1 x %2").arg(width).arg(height)));
        }
      }
    }
  }

  void wordsOnAGlide_keepOffTheFurniture() {
    MapScene scene = fullScene();
    scene.situation = racetrack();
    scene.cursor = 1800.0;
    const document::EngineOut glide = scene.situation.plan->engineOutAt(*scene.cursor);
    const geo::Point end = scene.situation.plan->plan().sites[static_cast<std::size_t>(glide.site)].pose.point();
    for (const QSizeF& map : {QSizeF(420.0, 600.0), QSizeF(900.0, 700.0)}) {
      for (double x = -0.1; x < 1.1; x += 0.04) {
        for (double y = -0.1; y < 1.1; y += 0.04) {
          // the runway anywhere on the map, or out of it
          const double scale = 25.0;
          const MapCamera camera({end.x - (x - 0.5) * map.width() * scale, end.y + (y - 0.5) * map.height() * scale}, scale, map);
          const ChartFrame frame(scene, camera, nullptr);
          const auto label = engineOutLabel(scene, camera, glide, frame.covered());
          QVERIFY(label.has_value());
          QVERIFY(camera.screen().contains(label->box));
          for (const QRectF& box : frame.covered()) {
            QVERIFY2(!box.intersects(label->box), qPrintable(QStringLiteral("%1 px, runway at %2, %3").arg(map.width()).arg(x).arg(y)));
          }
        }
      }
    }
  }

  void wordsOnAGlide_keepOffTheRunway() {
    MapScene scene = fullScene();
    scene.situation = racetrack();
    scene.cursor = 1800.0;
    const document::EngineOut glide = scene.situation.plan->engineOutAt(*scene.cursor);
    mission::SiteInFrame site = scene.situation.plan->plan().sites[static_cast<std::size_t>(glide.site)];
    const QSizeF map(900.0, 700.0);
    int clear = 0;
    int all = 0;
    for (const double scale : {0.5, 4.0, 25.0, 120.0}) {
      for (double x = 0.02; x < 1.0; x += 0.06) {
        for (double y = 0.02; y < 1.0; y += 0.06) {
          const geo::Point end = site.pose.point();
          const MapCamera camera({end.x - (x - 0.5) * map.width() * scale, end.y + (y - 0.5) * map.height() * scale}, scale, map);
          const auto label = engineOutLabel(scene, camera, glide, {});
          QVERIFY(label.has_value());
          const QPointF ring = camera.toScreen(end);
          const QByteArray words = QStringLiteral("%1 m/px, runway at %2, %3").arg(scale).arg(ring.x()).arg(ring.y()).toUtf8();
          QVERIFY2(!label->box.intersects(QRectF(ring.x() - 10.5, ring.y() - 10.5, 21.0, 21.0)), words);
          for (const QRectF& box : runwayBoxes(site, camera)) {
            QVERIFY2(!box.intersects(label->box), words);
          }
          // the words of the runway itself stay readable nearly everywhere
          for (const SiteLabel& own : SiteMarks(scene, camera).labelsOf(site.site.airportIdent)) {
            ++all;
            clear += own.firstBox().intersects(label->box) ? 0 : 1;
          }
        }
      }
    }
    QVERIFY(all > 1000);
    QVERIFY2(clear > 0.97 * all, qPrintable(QStringLiteral("%1 of %2").arg(clear).arg(all)));
  }

  void wordsOnAGlide_keepOffOtherRunways() {
    MapScene scene = fullScene();
    scene.situation = racetrack();
    scene.cursor = 1800.0;
    const document::EngineOut glide = scene.situation.plan->engineOutAt(*scene.cursor);
    const geo::Point end = scene.situation.plan->plan().sites[static_cast<std::size_t>(glide.site)].pose.point();
    const MapCamera camera(end, 60.0, {900.0, 700.0});
    const QRectF before = engineOutLabel(scene, camera, glide, {})->box;
    auto sites = std::make_shared<std::vector<document::ShownSite>>(*scene.situation.sites);
    document::ShownSite other = sites->front();
    const geo::Point taken = camera.toGround(before.center());
    other.site.pose = {taken.x, taken.y, 0.0};
    other.site.site.airportIdent = "LSZB";
    other.usable = true;
    sites->push_back(other);
    scene.situation.sites = sites;
    const QRectF after = engineOutLabel(scene, camera, glide, {})->box;
    const QPointF symbol = before.center();
    QVERIFY(!after.intersects(QRectF(symbol.x() - kSiteRadius, symbol.y() - kSiteRadius, 2.0 * kSiteRadius, 2.0 * kSiteRadius)));
  }

  void runwayBoxes_lieAlongTheStrip() {
    mission::SiteInFrame site = racetrack().plan->plan().sites.front();
    site.pose.heading = 0.25 * Angle::kPi;
    site.site.length = Length::fromSi(800.0);
    const MapCamera near({site.pose.x, site.pose.y}, 4.0, {900.0, 700.0});
    const QPointF end = near.toScreen({site.pose.x + 800.0 * std::cos(site.pose.heading), site.pose.y + 800.0 * std::sin(site.pose.heading)});
    const std::vector<QRectF> boxes = runwayBoxes(site, near);
    QVERIFY(boxes.front().contains(near.toScreen(site.pose.point()) + QPointF(10.5, 0.0)));
    for (const double share : {0.1, 0.5, 0.99}) {
      const QPointF at = near.toScreen(site.pose.point()) + (end - near.toScreen(site.pose.point())) * share;
      QVERIFY(std::any_of(boxes.begin(), boxes.end(), [&](const QRectF& box) { return box.contains(at); }));
    }
    QVERIFY(std::none_of(boxes.begin(), boxes.end(), [&](const QRectF& box) { return box.contains(QPointF(end.x(), near.screen().center().y())); }));
    QCOMPARE(runwayBoxes(site, MapCamera({site.pose.x, site.pose.y}, 200.0, {900.0, 700.0})).size(), std::size_t(1));
  }

  void longRow_isBrokenIntoLines() {
    const MapScene scene = fullScene();
    const SafeAltitudeLayer layer(*scene.situation.safeAltitudes, {});
    const MapCamera camera({0.0, 0.0}, 20.0, {320.0, 600.0});
    const std::vector<double> wide = ChartLegend(scene, camera, &layer, 600.0).groupHeights();
    const ChartLegend narrow(scene, camera, &layer, 150.0);
    QCOMPARE(narrow.width(), 150.0);
    QCOMPARE(narrow.groupHeights().size(), wide.size());
    QVERIFY(narrow.groupHeights().front() > wide.front());
    const QFont font = chartFont(TextSize::Small);
    for (const QString& text : {QStringLiteral("Lowest safe altitude on the worst course, ft MSL"), QString(60, QLatin1Char('W'))}) {
      const QStringList lines = brokenLines(text, font, 120.0);
      QVERIFY(lines.size() > 1);
      for (const QString& line : lines) {
        QVERIFY(QFontMetricsF(font).horizontalAdvance(line) <= 120.0);
      }
      QCOMPARE(lines.join(QString()).remove(QLatin1Char(' ')), QString(text).remove(QLatin1Char(' ')));
    }
  }

  void maps_areDrawn_data() {
    QTest::addColumn<QSize>("size");
    QTest::newRow("320x240") << QSize(320, 240);
    QTest::newRow("420x600") << QSize(420, 600);
    QTest::newRow("1024x700") << QSize(1024, 700);
    QTest::newRow("2560x1440") << QSize(2560, 1440);
  }
  void maps_areDrawn() {
    QFETCH(QSize, size);
    MapScene scene = fullScene();
    for (const style::Theme theme : {style::Theme::Light, style::Theme::Dark}) {
      scene.theme = theme;
      const MapCamera camera = homeCamera(scene.situation, size);
      const QImage image = renderMap(scene, camera, 1.0);
      const QString name = QStringLiteral("map-%1-%2").arg(QLatin1String(QTest::currentDataTag())).arg(static_cast<int>(theme));
      test::keepPicture(image, name);
      test::keepPicture(image.convertToFormat(QImage::Format_Grayscale8), name + QStringLiteral("-grey"));
      const SafeAltitudeLayer layer(*scene.situation.safeAltitudes, {});
      for (const QRectF& box : ChartFrame(scene, camera, &layer).covered()) {
        QVERIFY(hasColorNear(image, box.center(), static_cast<int>(0.5 * std::min(box.width(), box.height())), scene.colors().text, 60));
      }
    }
  }

private:
  QFont original_;
};

QTEST_MAIN(TestChartFrame)
#include "tst_chart_frame.moc"
