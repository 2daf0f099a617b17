// Dubins paths from turning circles against the words of Shkel and Lumelsky, which are computed another way.
#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/pose_pair.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace vp;
using namespace vp::flight;

namespace {

constexpr unsigned kSeed = 20261124;

double leastOfWords(const geo::Pose& a, const geo::Pose& b, double radius, TurnLoss loss) {
  double least = 1e300;
  for (const Word word : kWords) {
    if (const auto path = dubinsWord(a, b, radius, word)) {
      least = std::min(least, lossOf(*path, loss));
    }
  }
  return least;
}

}  // namespace

class TestPosePair : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { qInfo("seed %u", kSeed); }

  void leastLoss_underAllWords_isLeastAndEndsAtTheGoal_data() {
    QTest::addColumn<double>("side");
    QTest::newRow("one circle") << 20.0;
    QTest::newRow("near") << 150.0;
    QTest::newRow("middle") << 600.0;
    QTest::newRow("far") << 10000.0;
  }

  void leastLoss_underAllWords_isLeastAndEndsAtTheGoal() {
    QFETCH(double, side);
    std::mt19937_64 engine(kSeed);
    std::uniform_real_distribution<double> place(-side, side);
    std::uniform_real_distribution<double> heading(-10.0, 10.0);
    const TurnLoss loss{0.0857, 0.232};
    double sumBounds = 0.0;
    double sumLeast = 0.0;
    for (int i = 0; i < 10000; ++i) {
      const geo::Pose a{place(engine), place(engine), heading(engine)};
      const geo::Pose b{place(engine), place(engine), heading(engine)};
      const PosePair pair(a, b);
      const DubinsPath path = pair.leastLoss(65.7, loss);
      const double least = leastOfWords(a, b, 65.7, loss);
      QVERIFY2(std::abs(lossOf(path, loss) - least) < 1e-6, qPrintable(QString("case %1: %2 against %3").arg(i).arg(lossOf(path, loss)).arg(least)));
      const double bound = pair.lossBound(65.7, loss);
      QVERIFY2(bound <= least + 1e-6, qPrintable(QString("case %1: bound %2 above %3").arg(i).arg(bound).arg(least)));
      sumBounds += bound;
      sumLeast += least;
      const geo::Pose end = flight::endOf(toCurve(path), 33.4);
      QVERIFY(geo::distance(end.point(), b.point()) < 1e-6);
      QVERIFY(std::abs(wrapPi(end.heading - b.heading)) < 2e-9);
    }
    qInfo("the bounds are %.1f %% of the losses on average", 100.0 * sumBounds / sumLeast);
    QVERIFY(sumBounds > (side < 10000.0 ? 0.25 : 0.95) * sumLeast);  // and worth having
  }

  void alignedPoses_haveNoFullCircles_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("turn");
    QTest::addColumn<double>("length");
    QTest::newRow("straight on") << 500.0 << 0.0 << 0.0 << 500.0;
    QTest::newRow("where it is") << 0.0 << 0.0 << 0.0 << 0.0;
    QTest::newRow("quarter to the left") << 100.0 << 100.0 << 0.5 * Angle::kPi << 50.0 * Angle::kPi;
    QTest::newRow("quarter to the right") << 100.0 << -100.0 << -0.5 * Angle::kPi << 50.0 * Angle::kPi;
    QTest::newRow("half to the left") << 0.0 << 200.0 << Angle::kPi << 100.0 * Angle::kPi;
  }

  void alignedPoses_haveNoFullCircles() {
    // degenerate words, turned and moved: rounding may push a turn of nothing below zero, which must not become a circle
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, turn);
    QFETCH(double, length);
    std::mt19937_64 engine(kSeed);
    std::uniform_real_distribution<double> any(-3.0, 3.0);
    for (int i = 0; i < 10000; ++i) {
      const geo::Pose a{3000.0 * any(engine), 3000.0 * any(engine), any(engine)};
      const double c = std::cos(a.heading);
      const double s = std::sin(a.heading);
      const geo::Pose b{a.x + c * x - s * y, a.y + s * x + c * y, a.heading + turn};
      const double found = PosePair(a, b).leastLoss(100.0, {1.0, 1.0}).length();
      QVERIFY2(std::abs(found - length) < 1e-5, qPrintable(QString("case %1: %2").arg(i).arg(found)));
    }
  }

  void knownDirections_giveTheSamePath() {
    const geo::Pose a{10.0, 20.0, 0.7};
    const geo::Pose b{-300.0, 420.0, 4.0};
    const DubinsPath one = PosePair(a, b).leastLoss(80.0, {0.1, 0.2});
    const DubinsPath two = PosePair(a, Direction(a.heading), b, Direction(b.heading)).leastLoss(80.0, {0.1, 0.2});
    QCOMPARE(one.word, two.word);
    QCOMPARE(one.lengths, two.lengths);
  }
};

QTEST_APPLESS_MAIN(TestPosePair)
#include "tst_pose_pair.moc"
