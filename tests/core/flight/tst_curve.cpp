// Closed-form sampling of curves: boxes hold their curves, drift adds up, joints meet.
#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace vp;
using namespace vp::flight;

class TestCurve : public QObject {
  Q_OBJECT

private slots:
  void box_underDenseSampling_holdsAndTouches() {
    constexpr unsigned seed = 7;
    qInfo("seed %u", seed);
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 10000; ++i) {
      const geo::Pose start{1000.0 * unit(engine), 1000.0 * unit(engine), 6.3 * unit(engine)};
      const int side = static_cast<int>(engine() % 3) - 1;
      const Piece piece{static_cast<Turn>(side), side == 0 ? 0.0 : 50.0 + 200.0 * unit(engine), 800.0 * unit(engine)};
      const double from = piece.length * 0.5 * unit(engine);
      const double to = from + (piece.length - from) * unit(engine);
      const geo::Box box = boxOf(start, piece, from, to);
      geo::Box dense;
      for (int k = 0; k <= 400; ++k) {
        dense.add(poseAfter(start, piece, from + (to - from) * k / 400.0).point());
      }
      const geo::Box grown = box.grown(1e-6);
      QVERIFY(grown.contains({dense.minX, dense.minY}) && grown.contains({dense.maxX, dense.maxY}));
      QVERIFY(dense.minX - box.minX < 0.05 && box.maxX - dense.maxX < 0.05 && dense.minY - box.minY < 0.05 && box.maxY - dense.maxY < 0.05);
    }
  }

  void poseAlong_underWind_driftsWithTime() {
    const Curve curve{{0, 0, 0}, {{Turn::Straight, 0.0, 334.0}}, {0.0, 5.0}};
    const geo::Pose end = flight::endOf(curve, 33.4);
    QCOMPARE(end.x, 334.0);
    QCOMPARE(end.y, 50.0);
  }

  void sample_underStep_isDenseAndEndsAtTheEnd() {
    const Curve curve{{0, 0, 0}, {{Turn::Left, 100.0, 157.0}, {Turn::Straight, 0.0, 95.0}}, {}};
    const auto poses = sample(curve, 10.0, 33.4);
    for (std::size_t i = 1; i < poses.size(); ++i) {
      QVERIFY(geo::distance(poses[i - 1].point(), poses[i].point()) <= 10.0 + 1e-9);
    }
    const geo::Pose end = flight::endOf(curve, 33.4);
    QVERIFY(geo::distance(poses.back().point(), end.point()) < 1e-9);
    QCOMPARE(poses.size(), std::size_t(1 + 16 + 10));
  }
};

QTEST_APPLESS_MAIN(TestCurve)
#include "tst_curve.moc"
