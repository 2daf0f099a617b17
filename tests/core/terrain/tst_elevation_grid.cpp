#include "core/base/expect.h"
#include "core/terrain/elevation_grid.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <vector>

namespace vp::terrain {

/// 3 x 2 cells of 10 m from (100, 200); values 1..6 from the south-west.
class TestElevationGrid : public QObject {
  Q_OBJECT

private slots:
  void upperAt_insideACell_isItsValue() {
    QCOMPARE(grid_.upperAt({105.0, 205.0}), 1.0);
    QCOMPARE(grid_.upperAt({129.9, 219.9}), 6.0);
  }

  void upperAt_onEdgeAndCorner_isTheHighestOfAllCellsThere() {
    QCOMPARE(grid_.upperAt({110.0, 205.0}), 2.0);
    QCOMPARE(grid_.upperAt({105.0, 210.0}), 4.0);
    QCOMPARE(grid_.upperAt({110.0, 210.0}), 5.0);
    const ElevationGrid falling(0.0, 0.0, 1.0, 2, 2, {9.0F, 1.0F, 2.0F, 3.0F});
    QCOMPARE(falling.upperAt({1.0, 1.0}), 9.0);
  }

  void upperAt_outsideAndOnTheOuterEdge_isUnknown() {
    for (const geo::Point p : {geo::Point{99.0, 205.0}, {100.0, 205.0}, {130.0, 205.0}, {105.0, 200.0}, {105.0, 220.0}, {105.0, 221.0}}) {
      QVERIFY(std::isinf(grid_.upperAt(p)));
      QVERIFY(!grid_.isKnownAt(p));
    }
  }

  void upperAt_hugeOrNoNumber_isUnknown() {
    const double inf = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double odd : {1e300, -1e300, 3e9, -3e9, inf, -inf, nan}) {
      QVERIFY(std::isinf(grid_.upperAt({odd, 205.0})));
      QVERIFY(std::isinf(grid_.upperAt({105.0, odd})));
      QVERIFY(std::isinf(grid_.upperAt({odd, odd})));
    }
  }

  void columnOf_anywhere_isHeldToOneBesideTheGrid() {
    QCOMPARE(grid_.columnOf(100.0), 0);
    QCOMPARE(grid_.columnOf(129.99), 2);
    QCOMPARE(grid_.columnOf(130.0), 3);
    QCOMPARE(grid_.columnOf(1e300), 3);
    QCOMPARE(grid_.columnOf(99.99), -1);
    QCOMPARE(grid_.columnOf(-std::numeric_limits<double>::infinity()), -1);
    QCOMPARE(grid_.columnOf(std::numeric_limits<double>::quiet_NaN()), -1);
    QCOMPARE(grid_.rowOf(219.0), 1);
    QCOMPARE(grid_.rowOf(1e18), 2);
    QCOMPARE(grid_.rowOf(-1e18), -1);
  }

  void constructor_valuesThatAreNoHeights_makesThemUnknown() {
    const float inf = std::numeric_limits<float>::infinity();
    const ElevationGrid odd(0.0, 0.0, 1.0, 3, 1, {std::numeric_limits<float>::quiet_NaN(), -inf, inf});
    for (int column = 0; column < 3; ++column) {
      QCOMPARE(odd.upperInCell(column, 0), inf);
    }
  }

  void constructor_sizesThatDisagree_isABug() {
    QVERIFY_EXCEPTION_THROWN(ElevationGrid(0.0, 0.0, 1.0, 2, 2, {1.0F}), LogicError);
    QVERIFY_EXCEPTION_THROWN(ElevationGrid(0.0, 0.0, 0.0, 1, 1, {1.0F}), LogicError);
    QVERIFY_EXCEPTION_THROWN(ElevationGrid(std::nan(""), 0.0, 1.0, 1, 1, {1.0F}), LogicError);
  }

  void defaultGrid_everywhere_isUnknown() { QVERIFY(std::isinf(ElevationGrid().upperAt({0.0, 0.0}))); }

private:
  ElevationGrid grid_{100.0, 200.0, 10.0, 3, 2, {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F}};
};

}  // namespace vp::terrain

using vp::terrain::TestElevationGrid;
QTEST_APPLESS_MAIN(TestElevationGrid)
#include "tst_elevation_grid.moc"
