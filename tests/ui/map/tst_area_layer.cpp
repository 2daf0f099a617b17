// Population and weather as they are painted into tiles: classes, no seams, and many of them in time to be panned over.
#include "core/risk/population.h"
#include "ui/map/area_layer.h"

#include <QElapsedTimer>
#include <QGuiApplication>
#include <QTest>

#include <cmath>
#include <memory>

using namespace vp;
using map::PixelWindow;
using map::PopulationLayer;

namespace {

const geo::LatLon kPlace{46.6, 9.9};

std::vector<geo::LatLon> ringAt(geo::Point middle, double radius, int corners) {
  const geo::LocalFrame frame(kPlace);
  std::vector<geo::LatLon> ring;
  for (int i = 0; i < corners; ++i) {
    const double at = 2.0 * Angle::kPi * i / corners;
    ring.push_back(frame.toLatLon({middle.x + radius * std::cos(at), middle.y + radius * std::sin(at)}));
  }
  return ring;
}

document::ShownWeather cellAt(geo::Point middle, double radius, int corners, double success = 0.9) {
  mission::WeatherCell cell;
  cell.outline = ringAt(middle, radius, corners);
  cell.success = success;
  return document::shownWeather(std::move(cell), geo::LocalFrame(kPlace));
}

QImage painted(const PixelWindow& window, const std::vector<document::ShownWeather>& cells, double ratio = 1.0) {
  QImage image(window.width, window.height, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  map::paintWeather(painter, window, ratio, cells, style::Theme::Light);
  return image;
}

}  // namespace

class TestAreaLayer : public QObject {
  Q_OBJECT

private slots:
  void classes_beginAtTheirLimits() {
    QCOMPARE(PopulationLayer::classOf(9.9e-6), -1);
    QCOMPARE(PopulationLayer::classOf(10.001e-6), 0);
    QCOMPARE(PopulationLayer::classOf(199e-6), 1);
    QCOMPARE(PopulationLayer::classOf(201e-6), 2);
    QCOMPARE(PopulationLayer::classOf(1.0), 4);
  }

  /// Readable without colour vision: by lightness alone.
  void classes_areInAnOrderOfLightness() {
    for (int i = 1; i < static_cast<int>(PopulationLayer::kClasses.size()); ++i) {
      QVERIFY(PopulationLayer::colorOf(i, style::Theme::Light).lightnessF() < PopulationLayer::colorOf(i - 1, style::Theme::Light).lightnessF());
      QVERIFY(PopulationLayer::colorOf(i, style::Theme::Dark).lightnessF() > PopulationLayer::colorOf(i - 1, style::Theme::Dark).lightnessF());
    }
  }

  void population_isPaintedWithItsHoles_whereItIs() {
    mission::PopulationArea area;
    area.perSquareKm = 300.0;
    area.parts.push_back({ringAt({0.0, 0.0}, 1000.0, 64), {ringAt({0.0, 0.0}, 400.0, 64)}});
    auto people = risk::Population::from({area}, geo::LocalFrame(kPlace));
    QVERIFY2(people, people ? "" : people.error().message().c_str());
    const PopulationLayer layer(std::make_shared<const risk::Population>(std::move(*people)));
    QImage image(240, 240, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    layer.paint(painter, {-120, -120, 240, 240, 10.0}, style::Theme::Light);
    painter.end();
    QCOMPARE(qAlpha(image.pixel(120, 120)), 0);            // the hole
    QCOMPARE(qAlpha(image.pixel(120 + 110, 120)), 0);      // outside
    const QColor there = image.pixelColor(120 + 70, 120);  // 700 m east
    QVERIFY(std::abs(there.alphaF() - PopulationLayer::kOpacity) < 0.02F);
    QVERIFY(std::abs(there.red() - PopulationLayer::colorOf(2, style::Theme::Light).red()) < 4);
  }

  void tiles_fitTogether() {
    const std::vector<document::ShownWeather> cells{cellAt({100.0, -300.0}, 2500.0, 7), cellAt({900.0, 300.0}, 900.0, 24, 0.5)};
    const QImage whole = painted({-301, -205, 512, 256, 12.5}, cells);
    const QImage left = painted({-301, -205, 256, 256, 12.5}, cells);
    const QImage right = painted({-45, -205, 256, 256, 12.5}, cells);
    int differing = 0;
    for (int y = 0; y < 256; ++y) {
      for (int x = 0; x < 512; ++x) {
        const QColor a = whole.pixelColor(x, y);
        const QColor b = x < 256 ? left.pixelColor(x, y) : right.pixelColor(x - 256, y);
        differing += std::abs(a.alpha() - b.alpha()) > 24 ? 1 : 0;
      }
    }
    QVERIFY2(differing < 20, qPrintable(QString::number(differing)));  // of 131072: rounding of antialiased edges
  }

  void lesserChance_isHatchedDenser() {
    QVERIFY(map::weatherHatchPeriod(0.5, 1.0) < map::weatherHatchPeriod(0.9, 1.0));
    QVERIFY(map::weatherHatchPeriod(0.9, 1.0) < map::weatherHatchPeriod(0.99, 1.0));
    QCOMPARE(map::weatherHatchPeriod(0.9, 2.0), 2 * map::weatherHatchPeriod(0.9, 1.0));
  }

  void withoutRisk_theOutlineStandsAlone() {
    const QImage image = painted({-100, -100, 200, 200, 10.0}, {cellAt({0.0, 0.0}, 800.0, 32, 1.0)});
    QCOMPARE(qAlpha(image.pixel(100, 100)), 0);
    QVERIFY(qAlpha(image.pixel(100 + 80, 100)) > 200);
  }

  /// Three thousand cells of forty corners, a hundred tiles: told, and far from what would be felt.
  void manyCells_arePaintedInTime() {
    std::vector<document::ShownWeather> cells;
    for (int i = 0; i < 3000; ++i) {
      cells.push_back(cellAt({-40000.0 + 1600.0 * (i % 50), -48000.0 + 1600.0 * (i / 50)}, 700.0, 40));
    }
    QElapsedTimer clock;
    clock.start();
    constexpr int kTiles = 100;
    for (int i = 0; i < kTiles; ++i) {
      painted({-1280 + 256 * (i % 10), -1280 + 256 * (i / 10), 256, 256, 32.0}, cells);
    }
    const double perTile = static_cast<double>(clock.nsecsElapsed()) * 1e-6 / kTiles;
    qInfo("%.2f ms a tile", perTile);
    QVERIFY2(perTile < 150.0, "a tile of weather takes as long as a second of panning has for ten");
  }
};

QTEST_MAIN(TestAreaLayer)
#include "tst_area_layer.moc"
