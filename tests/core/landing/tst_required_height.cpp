// The height that a glide needs: never below dense sampling, never below the checker's own answer, and monotone.
#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"
#include "core/landing/required_height.h"
#include "core/safety/witness_check.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <array>
#include <cmath>
#include <random>

using namespace vp;

namespace {

constexpr unsigned kSeed = 31;

struct Cases {
  std::mt19937_64 engine{kSeed};
  double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
  geo::Pose pose(double side) { return {(*this)(-side, side), (*this)(-side, side), (*this)(0.0, 6.28)}; }
};

}  // namespace

class TestRequiredHeight : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { qInfo("seed %u", kSeed); }

  void piece_underDenseSampling_isAnUpperBound() {
    const landing::World world = test::mountainWorld();
    Cases random;
    int binding = 0;
    for (int i = 0; i < 10000; ++i) {
      const geo::Pose start = random.pose(2000.0);
      const int side = static_cast<int>(random.engine() % 3) - 1;
      const flight::Piece piece{static_cast<flight::Turn>(side), side == 0 ? 0.0 : random(60.0, 300.0), random(0.0, 600.0)};
      const double loss = random(0.0, 0.3);
      const double end = random(0.0, 1500.0);
      const double bound = landing::requiredStartHeight(world.terrain, start, piece, loss, 100.0, end);
      double dense = end + loss * piece.length;
      double highest = -1e9;
      for (int k = 0; k <= 300; ++k) {
        const double s = piece.length * k / 300.0;
        const double ground = world.terrain.grid().upperAt(flight::poseAfter(start, piece, s).point());
        dense = std::max(dense, ground + 100.0 + loss * s);
        highest = std::max(highest, ground);
      }
      if (!std::isfinite(dense)) {
        QVERIFY(!std::isfinite(bound));
        continue;
      }
      QVERIFY2(bound >= dense - 1e-6, qPrintable(QString("case %1: %2 below %3").arg(i).arg(bound).arg(dense)));
      QVERIFY(landing::maxTerrainAlong(world.terrain, start, piece) >= highest);
      binding += dense > end + loss * piece.length + 1.0 ? 1 : 0;
    }
    QVERIFY(binding > 1000);  // the terrain decides often enough for the test to mean something
  }

  void line_alongCellSidesAndAcross_countsWhatItTouchesOnly() {
    const landing::World world = test::mountainWorld();
    const double cell = world.terrain.grid().cellSize();
    Cases random;
    for (int i = 0; i < 10000; ++i) {
      // all but parallel to the axes every second time, and beginning on a corner of cells every third
      const double slight = std::array{0.0, 1e-14, -1e-14, 1e-9, -1e-9, 1e-6, -1e-6}[random.engine() % 7];
      geo::Pose start = random.pose(2400.0);
      start.heading = i % 2 == 0 ? start.heading : 0.5 * Angle::kPi * static_cast<double>(random.engine() % 4) + slight;
      start.x = i % 3 == 0 ? std::round(start.x / cell) * cell : start.x;
      start.y = i % 3 == 0 ? std::round(start.y / cell) * cell : start.y;
      const flight::Piece piece{flight::Turn::Straight, 0.0, i % 5 == 0 ? random(0.0, 1e-3) : random(0.0, 3000.0)};
      const double loss = random(0.0, 0.3);
      const double found = landing::requiredStartHeight(world.terrain, start, piece, loss, 100.0, -1e5);
      double least = -1e5 + loss * piece.length;
      double most = least;
      const int parts = 1 + static_cast<int>(piece.length / 0.5);
      geo::Point before = start.point();
      for (int k = 1; k <= parts; ++k) {
        const double s = piece.length * k / parts;
        geo::Box box;
        box.add(before);
        before = flight::poseAfter(start, piece, s).point();
        box.add(before);
        least = std::max(least, world.terrain.grid().upperAt(before) + 100.0 + loss * s);
        most = std::max(most, world.terrain.upperIn(box.grown(2e-3)) + 100.0 + loss * s);
      }
      QVERIFY2(found >= least - 1e-6, qPrintable(QString("case %1: %2 below %3").arg(i).arg(found).arg(least)));
      QVERIFY2(found <= most + 1e-6, qPrintable(QString("case %1: %2 above %3").arg(i).arg(found).arg(most)));
    }
  }

  void glide_underTheChecker_isNeverBelowItsAnswer() {
    const landing::World world = test::mountainWorld();
    Cases random;
    for (int i = 0; i < 10000; ++i) {
      const double radius = world.glide.glideRadii()[random.engine() % 4];
      const flight::TurnLoss losses{world.glide.straightLoss(), world.glide.lossAt(radius)};
      const flight::DubinsPath path = flight::leastLossDubins(random.pose(2300.0), random.pose(2300.0), radius, losses);
      const double end = random(0.0, 1500.0);
      const double bound = landing::requiredStartHeight(world, path, losses, end);
      const flight::Curve curve = flight::toCurve(path);
      const double checked = safety::requiredStartHeight(curve.start, curve.pieces, end, world.terrain.grid(), world.clearance, world.glide);
      if (std::isfinite(checked) || std::isfinite(bound)) {
        QVERIFY2(bound >= checked - 1e-6, qPrintable(QString("case %1: %2 below %3").arg(i).arg(bound).arg(checked)));
      }
    }
  }

  void height_underMoreOfAnything_neverFalls() {
    const landing::World world = test::mountainWorld();
    Cases random;
    for (int i = 0; i < 10000; ++i) {
      const double radius = world.glide.glideRadii()[random.engine() % 4];
      const flight::TurnLoss losses{world.glide.straightLoss(), world.glide.lossAt(radius)};
      const flight::DubinsPath path = flight::leastLossDubins(random.pose(2300.0), random.pose(2300.0), radius, losses);
      const double end = random(0.0, 1500.0);
      const double base = landing::requiredStartHeight(world, path, losses, end);
      landing::World higher = world;
      higher.clearance += 37.0;
      QVERIFY(landing::requiredStartHeight(higher, path, losses, end) >= base);
      QVERIFY(landing::requiredStartHeight(world, path, losses, end + 20.0) >= base);
      QVERIFY(landing::requiredStartHeight(world, path, {losses.straight * 1.1, losses.turn * 1.1}, end) >= base - 1e-9);
      const double given = landing::requiredStartHeight(world, path, losses, end, base - 0.5);
      QVERIFY(!std::isfinite(given));  // giving up early says infinity, never a number that is too low
      QCOMPARE(landing::requiredStartHeight(world, path, losses, end, base + 1e-6), base);
    }
  }

  void loss_upToThePeak_isCharged() {
    // [1]'s short form max[T, A + H] would ask for 400 m here; a glide from there meets the wall at 1 km well below it
    landing::World world = test::mountainWorld();
    world.terrain = terrain::TerrainPyramid(test::makeGrid(5000.0, 20.0, [](double x, double) { return x > 0.0 && x < 40.0 ? 300.0 : 0.0; }));
    const flight::TurnLoss losses{0.1, 0.3};
    const flight::DubinsPath path = flight::leastLossDubins({-1000.0, 5.0, 0.0}, {500.0, 5.0, 0.0}, 100.0, losses);
    const double needed = landing::requiredStartHeight(world, path, losses, 100.0);
    QVERIFY(needed >= 300.0 + 100.0 + 0.1 * 1000.0 && needed <= 300.0 + 100.0 + 0.1 * 1100.0);
  }
};

QTEST_APPLESS_MAIN(TestRequiredHeight)
#include "tst_required_height.moc"
