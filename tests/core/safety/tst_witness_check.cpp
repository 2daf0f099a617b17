#include "core/base/quantity.h"
#include "core/safety/witness_check.h"
#include "tests/support/path_check.h"
#include "tests/support/plan_builder.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace vp;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint64_t kSeed = 20240602;
constexpr int kCases = 10000;
constexpr double kClearance = 100.0;

/// Max formula of the safe altitude over dense samples, terrain taken `near` metres around each.
double denseRequired(const std::vector<test::FlownPoint>& points, const std::vector<flight::Piece>& pieces, const aircraft::GlideModel& model,
                     const terrain::ElevationGrid& grid, double arrival, double near, double ahead) {
  double loss = 0.0;
  double required = -kInfinity;
  double steepest = model.straightLoss();
  for (const flight::Piece& piece : pieces) {
    steepest = std::max(steepest, model.lossAt(piece.radius));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) {
      loss += model.lossAt(pieces[points[i].piece].radius) * (points[i].distance - points[i - 1].distance);
    }
    required = std::max(required, test::groundNear(grid, points[i].x, points[i].y, near) + kClearance + loss + steepest * ahead);
  }
  return std::max(required, arrival + loss);
}

}  // namespace

class TestWitnessCheck : public QObject {
  Q_OBJECT

private slots:
  void requiredStartHeight_againstDenseSampling_isNeverBelowAndTight() {
    qInfo("seed %llu, %d cases", static_cast<unsigned long long>(kSeed), kCases);
    const aircraft::GlideModel model(test::cessna());
    std::mt19937_64 random(kSeed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::uniform_real_distribution<float> height(0.0F, 800.0F);
    int known = 0;
    for (int number = 0; number < kCases; ++number) {
      std::vector<float> values(60 * 60);
      for (float& value : values) {
        value = height(random);
      }
      if (unit(random) < 0.2) {
        values[static_cast<std::size_t>(unit(random) * 3600.0)] = terrain::kUnknownUpper;
      }
      const terrain::ElevationGrid grid(-1500.0, -1500.0, 50.0, 60, 60, values);
      const geo::Pose start{1200.0 * (unit(random) - 0.5), 1200.0 * (unit(random) - 0.5), 2.0 * Angle::kPi * unit(random)};
      std::vector<flight::Piece> pieces;
      const int count = static_cast<int>(unit(random) * 5.0);
      for (int i = 0; i < count; ++i) {
        const auto turn = static_cast<flight::Turn>(static_cast<int>(unit(random) * 3.0) - 1);
        pieces.push_back({turn, turn == flight::Turn::Straight ? 0.0 : 65.7 + 200.0 * unit(random) * unit(random), 350.0 * unit(random)});
      }
      const double arrival = 600.0 * unit(random);
      const double found = safety::requiredStartHeight(start, pieces, arrival, grid, kClearance, model);
      const auto points = test::fly(start, pieces, 4.0);
      const double dense = denseRequired(points, pieces, model, grid, arrival, 0.0, 0.0);
      const double upper = denseRequired(points, pieces, model, grid, arrival, 4.0, 4.0);
      const QByteArray label = QString("case %1: found %2, dense %3, upper %4").arg(number).arg(found).arg(dense).arg(upper).toUtf8();
      QVERIFY2(found >= dense - 1e-6, label);
      QVERIFY2(found <= upper + 1e-6, label);
      known += std::isfinite(found) ? 1 : 0;
    }
    QVERIFY(known > kCases / 2);
  }

  void flatGround_givesTheLossByHand() {
    const aircraft::GlideModel model(test::cessna());
    const terrain::ElevationGrid grid = test::TestTerrain(200.0F).grid();
    const std::vector<flight::Piece> pieces{{flight::Turn::Straight, 0.0, 1000.0}, {flight::Turn::Left, 65.7, 100.0}};
    const double loss = 1000.0 * model.lossAt(0.0) + 100.0 * model.lossAt(65.7);
    QVERIFY(std::abs(safety::requiredStartHeight({0.0, 0.0, 1.0}, pieces, 230.0, grid, 100.0, model) - (300.0 + loss)) < 1e-9);
    QVERIFY(std::abs(safety::requiredStartHeight({0.0, 0.0, 1.0}, pieces, 350.0, grid, 100.0, model) - (350.0 + loss)) < 1e-9);
  }

  /// The papers' short form max(terrain, A + loss) forgets the loss up to the obstacle.
  void risingGround_countsTheLossUpToIt() {
    const aircraft::GlideModel model(test::cessna());
    const terrain::ElevationGrid grid = test::TestTerrain().setCell(1025.0, 25.0, 400.0F).grid();
    const double found = safety::requiredStartHeight({10.0, 25.0, 0.0}, {{flight::Turn::Straight, 0.0, 2000.0}}, 0.0, grid, 100.0, model);
    QVERIFY(std::abs(found - (500.0 + 1040.0 * model.straightLoss())) < 1e-5);
  }

  void uselessInput_givesInfinity_data() {
    QTest::addColumn<int>("turn");
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("length");
    QTest::newRow("no number") << 0 << 0.0 << std::nan("");
    QTest::newRow("huge length") << 0 << 0.0 << 1e300;
    QTest::newRow("negative length") << 0 << 0.0 << -1.0;
    QTest::newRow("turn without radius") << 1 << 0.0 << 10.0;
    QTest::newRow("tiny radius") << -1 << 1e-300 << 10.0;
    QTest::newRow("thousands of circles") << 1 << 1.0 << 1e6;
    QTest::newRow("straight with a radius") << 0 << 65.0 << 10.0;
    QTest::newRow("no such turn") << 7 << 65.0 << 10.0;
  }

  void uselessInput_givesInfinity() {
    QFETCH(int, turn);
    QFETCH(double, radius);
    QFETCH(double, length);
    const aircraft::GlideModel model(test::cessna());
    const std::vector<flight::Piece> pieces{{static_cast<flight::Turn>(turn), radius, length}};
    QCOMPARE(safety::requiredStartHeight({0.0, 0.0, 0.0}, pieces, 0.0, test::TestTerrain().grid(), 100.0, model), kInfinity);
    QCOMPARE(safety::requiredStartHeight({std::nan(""), 0.0, 0.0}, {}, 0.0, test::TestTerrain().grid(), 100.0, model), kInfinity);
  }
};

QTEST_APPLESS_MAIN(TestWitnessCheck)
#include "tst_witness_check.moc"
