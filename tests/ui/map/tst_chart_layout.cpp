// Where the furniture of a map stands: swept over sizes of the map and of what stands on it, without painting.
#include "ui/map/chart_layout.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace vp::map;

namespace {

constexpr double kRounding = 1e-3;  // px

/// Free of the edge and of other boxes; shares no code with the layout.
/// @param slack  px that are forgiven; below zero: room that must be to spare
bool isClear(const QRectF& box, QSizeF map, const std::vector<QRectF>& others, double slack = -kRounding) {
  const bool inside = box.left() > kFurnitureEdge - slack && box.top() > kFurnitureEdge - slack &&
                      box.right() < map.width() - kFurnitureEdge + slack && box.bottom() < map.height() - kFurnitureEdge + slack;
  return inside && std::all_of(others.begin(), others.end(), [&](const QRectF& other) {
           const double across = std::max(box.left() - other.right(), other.left() - box.right());
           const double along = std::max(box.top() - other.bottom(), other.top() - box.bottom());
           return std::max(across, along) > kFurnitureGap - slack;
         });
}

QByteArray words(QSizeF map, const FurnitureSizes& sizes) {
  return QStringLiteral("map %1 x %2, legend %3, %4 groups, message %5")
      .arg(map.width())
      .arg(map.height())
      .arg(sizes.legendWidth)
      .arg(sizes.legendGroups.size())
      .arg(sizes.message ? sizes.message->width() : 0.0)
      .toUtf8();
}

double heightOf(const FurnitureSizes& sizes, std::size_t groups) {
  double height = sizes.legendPadding;
  for (std::size_t i = 0; i < groups; ++i) {
    height += sizes.legendGroups[i];
  }
  return height;
}

/// Sizes of letters up to three times as large as usual, in any mixture of furniture.
FurnitureSizes anySizes(QSizeF map, std::mt19937_64& random) {
  const auto between = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  const double most = map.width() - 2.0 * kFurnitureEdge;
  FurnitureSizes sizes;
  sizes.scale = {between(90.0, std::min(most, 400.0)), between(34.0, 70.0)};
  sizes.north = {between(30.0, 50.0), between(44.0, 80.0)};
  if (between(0.0, 1.0) < 0.5) {
    sizes.message = QSizeF(between(120.0, std::min(most, 900.0)), between(20.0, 110.0));
  }
  if (between(0.0, 1.0) < 0.5) {
    sizes.wind = QSizeF(between(90.0, 200.0), between(50.0, 150.0));
  }
  sizes.legendWidth = between(150.0, std::min(most, 700.0));
  sizes.legendPadding = 18.0;
  sizes.legendGroups.resize(std::uniform_int_distribution<std::size_t>(0, 5)(random));
  for (double& height : sizes.legendGroups) {
    height = between(18.0, 140.0);
  }
  return sizes;
}

}  // namespace

class TestChartLayout : public QObject {
  Q_OBJECT

private slots:
  void anyMapAndFurniture_neverOverlapsNorLeavesTheMap() {
    const unsigned seed = 20240511;
    qInfo("seed %u", seed);
    std::mt19937_64 random(seed);
    std::array<int, 3> missing{};
    for (int i = 0; i < 200'000; ++i) {
      // small maps often: there the room is short
      const double share = std::uniform_real_distribution<double>(0.0, 1.0)(random);
      const QSizeF map(320.0 + 3680.0 * share * share, 240.0 + 2160.0 * std::pow(std::uniform_real_distribution<double>(0.0, 1.0)(random), 2));
      const FurnitureSizes sizes = anySizes(map, random);
      const ChartLayout layout = layOutChart(map, sizes);
      const std::vector<QRectF> boxes = layout.boxes();
      for (std::size_t k = 0; k < boxes.size(); ++k) {
        QVERIFY2(isClear(boxes[k], map, {boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(k)}, kRounding), words(map, sizes));
      }
      QCOMPARE(layout.scale.size(), sizes.scale);
      QVERIFY2(layout.message.has_value() == sizes.message.has_value() ||
                   !isClear({{0.5 * (map.width() - sizes.message->width()), kFurnitureEdge}, *sizes.message}, map, {layout.scale}),
               words(map, sizes));
      checkLegend(map, sizes, layout);
      checkNorth(map, sizes, layout);
      if (QTest::currentTestFailed()) {
        return;
      }
      missing[0] += sizes.message && !layout.message ? 1 : 0;
      missing[1] += layout.legendGroups < sizes.legendGroups.size() ? 1 : 0;
      missing[2] += layout.north ? 0 : 1;
    }
    QVERIFY2(missing[1] > 1000 && missing[2] > 1000, "the sweep reaches maps without room");
    QVERIFY2(missing[0] == 0, "a message always fits into maps of these sizes");
  }

  void ampleRoom_givesTheCorners() {
    const ChartLayout layout = layOutChart({1000.0, 700.0}, {{200.0, 34.0}, {30.0, 44.0}, QSizeF(400.0, 22.0), 210.0, 18.0, {54.0, 18.0}});
    QCOMPARE(layout.scale, QRectF(12.0, 654.0, 200.0, 34.0));
    QCOMPARE(layout.message, std::optional(QRectF(300.0, 12.0, 400.0, 22.0)));
    QCOMPARE(layout.legend, std::optional(QRectF(778.0, 598.0, 210.0, 90.0)));
    QCOMPARE(layout.legendGroups, std::size_t{2});
    QCOMPARE(layout.north, std::optional(QRectF(958.0, 12.0, 30.0, 44.0)));
  }

  void wind_standsUpperLeftOrBelowTheMessage() {
    FurnitureSizes sizes{{200.0, 34.0}, {30.0, 44.0}, QSizeF(400.0, 22.0), 210.0, 18.0, {54.0}};
    sizes.wind = QSizeF(120.0, 50.0);
    QCOMPARE(layOutChart({1000.0, 700.0}, sizes).wind, std::optional(QRectF(12.0, 12.0, 120.0, 50.0)));
    QCOMPARE(layOutChart({600.0, 700.0}, sizes).wind, std::optional(QRectF(12.0, 42.0, 120.0, 50.0)));
  }

  void narrowMap_putsTheLegendAboveTheScaleBar() {
    // 420 px: the two used to lie on each other
    const ChartLayout layout = layOutChart({420.0, 600.0}, {{214.0, 34.0}, {30.0, 44.0}, {}, 210.0, 18.0, {54.0}});
    QCOMPARE(layout.scale, QRectF(12.0, 554.0, 214.0, 34.0));
    QCOMPARE(layout.legend, std::optional(QRectF(198.0, 474.0, 210.0, 72.0)));
    QVERIFY(layout.north.has_value());
  }

  void wideMessage_putsTheArrowBelowIt() {
    const ChartLayout layout = layOutChart({420.0, 600.0}, {{214.0, 34.0}, {30.0, 44.0}, QSizeF(390.0, 38.0), 0.0, 0.0, {}});
    QCOMPARE(layout.north, std::optional(QRectF(378.0, 58.0, 30.0, 44.0)));
    QVERIFY(!layout.legend);
  }

  void shortRoom_leavesOutTheLastGroupsFirst_thenTheArrow() {
    const FurnitureSizes sizes{{200.0, 34.0}, {30.0, 44.0}, {}, 210.0, 18.0, {70.0, 70.0, 70.0}};
    const auto at = [&](double height) { return layOutChart({400.0, height}, sizes); };
    // 24 of edges, 34 + 8 of the scale bar, 228 of the legend, 8 + 44 of the arrow
    QVERIFY(at(346.0).legendGroups == 3 && at(346.0).north);
    QVERIFY(at(345.0).legendGroups == 3 && !at(345.0).north);
    QVERIFY(at(294.0).legendGroups == 3);
    QVERIFY(at(293.0).legendGroups == 2);
  }

private:
  /// One group more would have had no room in either place.
  static void checkLegend(QSizeF map, const FurnitureSizes& sizes, const ChartLayout& layout) {
    std::vector<QRectF> before{layout.scale};
    if (layout.message) {
      before.push_back(*layout.message);
    }
    if (layout.wind) {
      before.push_back(*layout.wind);
    }
    if (sizes.wind && !layout.wind) {
      QVERIFY2(!isClear({{kFurnitureEdge, kFurnitureEdge}, *sizes.wind}, map, before), words(map, sizes));
    }
    QCOMPARE(layout.legend.has_value(), layout.legendGroups > 0);
    if (layout.legend) {
      QVERIFY(std::abs(layout.legend->height() - heightOf(sizes, layout.legendGroups)) < kRounding);
      QVERIFY2(layout.legend->width() * layout.legend->height() < 0.5 * map.width() * map.height() + 1.0, words(map, sizes));
    }
    if (layout.legendGroups < sizes.legendGroups.size()) {
      const QSizeF size(sizes.legendWidth, heightOf(sizes, layout.legendGroups + 1));
      const double left = map.width() - kFurnitureEdge - size.width();
      const bool isModest = size.width() * size.height() < 0.5 * map.width() * map.height() - 1.0;
      QVERIFY2(!isModest || !isClear({{left, map.height() - kFurnitureEdge - size.height()}, size}, map, before), words(map, sizes));
      QVERIFY2(!isModest || !isClear({{left, layout.scale.top() - kFurnitureGap - size.height()}, size}, map, before), words(map, sizes));
    }
  }

  static void checkNorth(QSizeF map, const FurnitureSizes& sizes, const ChartLayout& layout) {
    if (!layout.north) {
      QVERIFY2(!isClear({{map.width() - kFurnitureEdge - sizes.north.width(), kFurnitureEdge}, sizes.north}, map, layout.boxes()), words(map, sizes));
    }
  }
};

QTEST_APPLESS_MAIN(TestChartLayout)
#include "tst_chart_layout.moc"
