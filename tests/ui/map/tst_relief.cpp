// Terrain as pixels: light from the north-west, unknown ground hatched, no seams, no blocks, no lost voids.
#include "tests/ui/map/map_fixture.h"
#include "ui/map/relief_painter.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace vp;
using namespace vp::map;
using namespace vp::map::testing;

namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();

ReliefPainter painterOf(const std::shared_ptr<const document::TerrainData>& terrain, style::Theme theme = style::Theme::Light,
                        bool contours = false) {
  return {std::make_shared<const HeightLevels>(terrain->grid), {theme, style::UnitSystem::Metric, contours, 0.0, 4000.0}};
}

double rough(double x, double y) {
  return 1500.0 + 600.0 * std::sin(x / 700.0) * std::cos(y / 900.0) + 80.0 * std::sin(x / 130.0 + y / 170.0);
}

PixelWindow windowAt(geo::Point centre, double metresPerPixel, int width, int height) {
  return {std::llround(centre.x / metresPerPixel) - width / 2, std::llround(-centre.y / metresPerPixel) - height / 2, width, height, metresPerPixel};
}

}  // namespace

class TestRelief : public QObject {
  Q_OBJECT

private slots:
  void hillShade_underAllDirections_isBrightestTowardsTheNorthWest() {
    // ground that falls towards an azimuth faces it
    const auto facing = [](double azimuth_deg) {
      const double a = azimuth_deg * Angle::kPi / 180.0;
      return hillShade(static_cast<float>(-0.5 * std::sin(a)), static_cast<float>(-0.5 * std::cos(a)));
    };
    QCOMPARE(hillShade(0.0F, 0.0F), kLevelShade);
    for (int azimuth = 0; azimuth < 360; azimuth += 15) {
      QVERIFY2(azimuth == 315 || facing(azimuth) < facing(315.0), qPrintable(QString::number(azimuth)));
      QVERIFY2(azimuth == 135 || facing(azimuth) > facing(135.0), qPrintable(QString::number(azimuth)));
    }
    QVERIFY(facing(315.0) > kLevelShade && facing(135.0) < kLevelShade);
  }

  void paint_underARidge_litSideIsBrighter_data() {
    QTest::addColumn<int>("theme");
    QTest::addColumn<double>("scale");
    QTest::newRow("light, cells larger than pixels") << static_cast<int>(style::Theme::Light) << 10.0;
    QTest::newRow("light, cells smaller than pixels") << static_cast<int>(style::Theme::Light) << 120.0;
    QTest::newRow("dark") << static_cast<int>(style::Theme::Dark) << 30.0;
  }
  void paint_underARidge_litSideIsBrighter() {
    QFETCH(int, theme);
    QFETCH(double, scale);
    // a ridge from south-west to north-east: one side faces north-west
    const auto terrain = groundOf([](double x, double y) { return 2000.0 - 0.4 * std::abs(x - y); });
    const ReliefPainter painter = painterOf(terrain, static_cast<style::Theme>(theme));
    const auto at = [&](geo::Point p) { return qGray(painter.paint(windowAt(p, scale, 1, 1), 1.0).pixel(0, 0)); };
    const int lit = at({-1000.0, 1000.0});
    const int dark = at({1000.0, -1000.0});
    QVERIFY2(lit > dark + 30, qPrintable(QStringLiteral("%1 %2").arg(lit).arg(dark)));
  }

  void paint_underHeight_takesTheTintOfTheScale() {
    const ReliefPainter painter = painterOf(groundOf([](double, double) { return 3000.0; }));
    const QRgb pixel = painter.paint(windowAt({}, 20.0, 1, 1), 1.0).pixel(0, 0);
    QVERIFY(difference(pixel, style::ChartColors::tint(style::Theme::Light, 0.75).rgb()) <= 4);
  }

  void paint_underNeighbouringTiles_hasNoSeam_data() {
    QTest::addColumn<double>("scale");
    for (const double scale : {3.0, 27.0, 50.0, 90.0, 300.0}) {
      QTest::addRow("%g m per pixel", scale) << scale;
    }
  }
  void paint_underNeighbouringTiles_hasNoSeam() {
    QFETCH(double, scale);
    const auto terrain = groundOf([](double x, double y) { return std::hypot(x - 400.0, y) < 300.0 ? kUnknown : rough(x, y); });
    const ReliefPainter painter = painterOf(terrain, style::Theme::Light, true);
    const PixelWindow whole{-64, -64, 128, 128, scale};
    const QImage all = painter.paint(whole, 1.0);
    for (const auto& [left, top] : {std::pair(-64, -64), std::pair(0, -64), std::pair(-64, 0), std::pair(0, 0)}) {
      const QImage part = painter.paint({left, top, 64, 64, scale}, 1.0);
      QCOMPARE(part, all.copy(left + 64, top + 64, 64, 64));
    }
  }

  void paint_underUnknownGround_isHatched() {
    const auto terrain = groundOf([](double x, double y) { return std::abs(x) < 2000.0 && std::abs(y) < 2000.0 ? kUnknown : 1000.0; });
    for (const style::Theme theme : {style::Theme::Light, style::Theme::Dark}) {
      const style::ChartColors& colors = style::ChartColors::of(theme);
      const QImage image = painterOf(terrain, theme).paint(windowAt({}, 20.0, 120, 120), 1.0);
      const int base = countColor(image, colors.unknownBase, 3);
      QVERIFY2(base > 120 * 120 / 2, qPrintable(QString::number(base)));
      // lines as well: nowhere a run without ink longer than their spacing
      for (int y = 0; y < image.height(); ++y) {
        int run = 0;
        for (int x = 0; x < image.width(); ++x) {
          run = difference(image.pixel(x, y), colors.unknownBase.rgb()) <= 3 ? run + 1 : 0;
          QVERIFY(run < 20);
        }
      }
      const QRgb known = painterOf(terrain, theme).paint(windowAt({3500.0, 0.0}, 20.0, 1, 1), 1.0).pixel(0, 0);
      QVERIFY(difference(known, colors.unknownBase.rgb()) > 12);
    }
  }

  void sample_underASingleUnknownCell_keepsAllOfItUnknown() {
    constexpr int kSide = 9;
    std::vector<float> values(kSide * kSide, 1000.0F);
    values[4 * kSide + 4] = static_cast<float>(kUnknown);
    const Raster raster{0.0, 0.0, 100.0, kSide, kSide, values.data()};
    const Samples samples = sample(raster, {0, -90, 90, 90, 10.0}, Kernel::Smooth);
    int unknown = 0;
    for (std::size_t i = 0; i < samples.value.size(); ++i) {
      const int column = static_cast<int>(i % 90);
      const int row = static_cast<int>(i / 90);
      unknown += samples.isKnown(i) || column < 20 || column >= 70 || row < 20 || row >= 70 ? 0 : 1;
    }
    QVERIFY2(unknown >= 100, qPrintable(QString::number(unknown)));  // a cell is 10 x 10 pixels
    QVERIFY(unknown <= 160);
    QVERIFY(!samples.isKnown(samples.index(45, 45)));
    QVERIFY(samples.isKnown(samples.index(30, 45)));
  }

  void sample_underLargeCells_givesNoBlocks() {
    const auto terrain = groundOf(rough);
    const HeightLevels levels(terrain->grid);
    const Samples fine = sample(levels.levelFor(2.0), windowAt({}, 2.0, 200, 200), Kernel::Smooth);
    // second differences of blocks or facets would be as large as the slope itself; a smooth surface has small ones
    double largestStep = 0.0;
    double largestBend = 0.0;
    for (int row = 0; row < 200; ++row) {
      for (int column = 1; column + 1 < 200; ++column) {
        const auto value = [&](int c) { return static_cast<double>(fine.value[fine.index(c, row)]); };
        largestStep = std::max(largestStep, std::abs(value(column + 1) - value(column)));
        largestBend = std::max(largestBend, std::abs(value(column + 1) - 2.0 * value(column) + value(column - 1)));
      }
    }
    QVERIFY(largestStep > 0.5);
    QVERIFY2(largestBend < 0.1 * largestStep, qPrintable(QStringLiteral("%1 %2").arg(largestBend).arg(largestStep)));
  }

  void sample_bilinear_staysWithinItsNeighbours() {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> height(0.0F, 1000.0F);
    std::vector<float> values(20 * 20);
    for (float& value : values) {
      value = height(random);
    }
    const Raster raster{0.0, 0.0, 100.0, 20, 20, values.data()};
    const Samples samples = sample(raster, {20, -180, 150, 150, 10.0}, Kernel::Bilinear);
    for (int row = 0; row < 150; ++row) {
      for (int column = 0; column < 150; ++column) {
        const int c = static_cast<int>(std::floor((20 + column + 0.5) * 0.1 - 0.5));
        const int r = static_cast<int>(std::floor((180 - row - 0.5) * 0.1 - 0.5));
        const auto cell = [&](int i, int j) { return values[static_cast<std::size_t>(j * 20 + i)]; };
        const auto [low, high] = std::minmax({cell(c, r), cell(c + 1, r), cell(c, r + 1), cell(c + 1, r + 1)});
        const float value = samples.value[samples.index(column, row)];
        QVERIFY(value >= low - 0.01F && value <= high + 0.01F);
      }
    }
  }

  void levels_underCoarseScale_areMeansOfTheGrid() {
    const auto terrain = groundOf([](double x, double) { return 1000.0 + x / 10.0; });
    const HeightLevels levels(terrain->grid);
    QCOMPARE(levels.levelFor(10.0).cell, kFieldCell);
    const Raster coarse = levels.levelFor(420.0);
    QCOMPARE(coarse.cell, 8.0 * kFieldCell);
    QCOMPARE(coarse.columns, 25);
    const float first = coarse.values[0];
    QVERIFY(std::abs(first - (1000.0F + (-5000.0F + 200.0F) / 10.0F)) < 0.01F);
  }

  void contours_standAtRoundHeights() {
    const auto terrain = groundOf([](double x, double) { return 1000.0 + 0.1 * x; });
    const double scale = 10.0;
    QCOMPARE(contourInterval(scale, style::UnitSystem::Metric), 100.0);
    QVERIFY(std::abs(contourInterval(scale, style::UnitSystem::Aviation) - 500.0 * kMetresPerFoot) < 1e-9);
    const QImage with = painterOf(terrain, style::Theme::Light, true).paint(windowAt({}, scale, 300, 1), 1.0);
    const QImage without = painterOf(terrain, style::Theme::Light, false).paint(windowAt({}, scale, 300, 1), 1.0);
    for (int column = 0; column < 300; ++column) {
      const double height = 1000.0 + 0.1 * ((column - 150 + 0.5) * scale);
      const double away = std::abs(height - std::round(height / 100.0) * 100.0);  // 1 m of height to the pixel
      QCOMPARE(difference(with.pixel(column, 0), without.pixel(column, 0)) > 8, away < 0.6);
    }
  }
};

QTEST_APPLESS_MAIN(TestRelief)
#include "tst_relief.moc"
