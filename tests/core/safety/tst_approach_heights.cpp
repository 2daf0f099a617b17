// Start heights of glides with an approach, against dense samples of their paths.

#include "core/safety/witness_check.h"
#include "tests/support/path_check.h"
#include "tests/support/plan_builder.h"

#include <QTest>

#include <limits>
#include <random>

using namespace vp;

namespace {

constexpr double kStep = 4.0;  // m, at most, between samples
constexpr double kClearance = 100.0;

/// A glide whose last piece is its last part, and what is asked for there.
struct Case {
  mission::Mission mission;
  mission::LandingSite site;
  geo::Pose start;
  std::vector<flight::Piece> pieces;
};

/// The start height over samples, terrain taken `near` metres around each and losses and clearances `ahead` metres further.
double denseRequired(const Case& one, const aircraft::GlideModel& model, const terrain::ElevationGrid& grid, double near, double ahead) {
  const mission::ApproachSettings& approach = one.mission.approach;
  const bool isStraight = approach.kind == mission::ApproachKind::Straight;
  const auto points = test::fly(one.start, one.pieces, kStep);
  const std::size_t last = one.pieces.size() - 1;
  const double whole = points.back().distance;
  const double gate = whole - one.pieces[last].length;
  double loss = 0.0;
  double required = -std::numeric_limits<double>::infinity();
  double steepest = model.straightLoss();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool isLast = points[i].piece == last && i > 0;
    if (i > 0) {
      const double rate = isLast && isStraight && approach.slope ? tan(*approach.slope) : model.lossAt(one.pieces[points[i].piece].radius);
      steepest = std::max(steepest, rate);
      loss += rate * (points[i].distance - points[i - 1].distance);
    }
    double asked = kClearance;
    if (isLast && approach.surfaceSlope) {
      asked = std::min(asked, *approach.surfaceSlope * std::max(0.0, whole - points[i].distance + ahead - approach.surfaceStart.si()));
    }
    required = std::max(required, test::groundNear(grid, points[i].x, points[i].y, near) + asked + loss + steepest * ahead);
    if (std::abs(points[i].distance - gate) < 1e-6 && !isStraight && approach.keyHeight) {
      required = std::max(required, one.site.elevation.metres() + approach.keyHeight->si() + loss);
    }
  }
  return std::max(required, one.site.elevation.metres() + one.mission.safety.arrivalMargin.si() + loss) + one.mission.safety.reactionLoss.si();
}

class Cases {
public:
  explicit Cases(std::uint64_t seed) : random_(seed) {}

  double unit() { return unit_(random_); }

  Case next() {
    Case one;
    one.mission.aircraft = test::cessna();
    one.mission.safety.clearance = Length::fromSi(kClearance);
    one.mission.safety.arrivalMargin = Length::fromSi(80.0 * unit());
    one.mission.safety.reactionLoss = Length::fromSi(unit() < 0.5 ? 0.0 : 30.0 * unit());
    one.site.elevation = geo::HeightMsl::fromMetres(500.0 * unit());
    one.start = {1000.0 * (unit() - 0.5), 1000.0 * (unit() - 0.5), 2.0 * Angle::kPi * unit()};
    for (double count = 3.0 * unit(); count > 0.0; count -= 1.0) {
      one.pieces.push_back(piece());
    }
    mission::ApproachSettings& approach = one.mission.approach;
    if (unit() < 0.7) {
      approach.surfaceSlope = 0.02 + 0.3 * unit();
      approach.surfaceStart = Length::fromSi(100.0 * unit());
    }
    if (unit() < 0.5) {
      approach.kind = mission::ApproachKind::Straight;
      approach.finalLength = Length::fromSi(100.0 + 700.0 * unit());
      one.pieces.push_back({flight::Turn::Straight, 0.0, approach.finalLength.si()});
      if (unit() < 0.5) {
        approach.slope = Angle::degrees(5.0 + 15.0 * unit());
      }
    } else {
      approach.kind = mission::ApproachKind::Overhead;
      const double radius = 65.7 + 60.0 * unit();
      one.pieces.push_back({unit() < 0.5 ? flight::Turn::Left : flight::Turn::Right, radius, 2.0 * Angle::kPi * radius});
      if (unit() < 0.5) {
        approach.keyHeight = Length::fromSi(600.0 * unit());
      }
    }
    return one;
  }
  std::vector<float> ground() {
    std::vector<float> values(60 * 60);
    const double roughness = unit() < 0.5 ? 600.0 : 60.0;
    for (float& value : values) {
      value = static_cast<float>(roughness * unit());
    }
    if (unit() < 0.1) {
      values[static_cast<std::size_t>(unit() * 3600.0)] = terrain::kUnknownUpper;
    }
    return values;
  }

private:
  flight::Piece piece() {
    const auto turn = static_cast<flight::Turn>(static_cast<int>(unit() * 3.0) - 1);
    return {turn, turn == flight::Turn::Straight ? 0.0 : 65.7 + 200.0 * unit() * unit(), 300.0 * unit()};
  }

  std::mt19937_64 random_;
  std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

/// The same glide with straights joined to one piece.
std::vector<flight::Piece> joined(const std::vector<flight::Piece>& pieces) {
  std::vector<flight::Piece> all;
  for (const flight::Piece& piece : pieces) {
    if (!all.empty() && all.back().turn == flight::Turn::Straight && piece.turn == flight::Turn::Straight) {
      all.back().length += piece.length;
    } else {
      all.push_back(piece);
    }
  }
  return all;
}

}  // namespace

class TestApproachHeights : public QObject {
  Q_OBJECT

private slots:
  void startHeight_againstDenseSampling_isNeverBelowAndTight() {
    constexpr std::uint64_t kSeed = 20261202;
    constexpr int kCases = 10000;
    qInfo("seed %llu, %d cases", static_cast<unsigned long long>(kSeed), kCases);
    Cases cases(kSeed);
    const aircraft::GlideModel model(test::cessna());
    int known = 0;
    int lowered = 0;
    for (int number = 0; number < kCases; ++number) {
      Case one = cases.next();
      const terrain::ElevationGrid grid(-2000.0, -2000.0, 4000.0 / 60.0, 60, 60, cases.ground());
      safety::GlideRates rates(model);
      const std::vector<flight::Piece> pieces = number % 2 == 0 ? one.pieces : joined(one.pieces);
      const double found = safety::requiredStartHeight(one.start, pieces, one.site, one.mission, grid, rates);
      const double dense = denseRequired(one, model, grid, 0.0, 0.0);
      const double upper = denseRequired(one, model, grid, kStep, kStep);
      const QByteArray label = QString("case %1: found %2, dense %3, upper %4").arg(number).arg(found).arg(dense).arg(upper).toUtf8();
      QVERIFY2(found >= dense - 1e-6, label);
      QVERIFY2(found <= upper + 1e-6, label);
      known += std::isfinite(found) ? 1 : 0;
      const bool hasSurface = one.mission.approach.surfaceSlope.has_value();
      one.mission.approach.surfaceSlope.reset();
      const double whole = safety::requiredStartHeight(one.start, pieces, one.site, one.mission, grid, rates);
      QVERIFY2(hasSurface ? whole >= found : whole == found, label);
      lowered += whole > found ? 1 : 0;
    }
    qInfo("%d known, %d lower for their obstacle surface", known, lowered);
    QVERIFY(known > kCases / 2 && lowered > 500);
  }

  void withoutAnApproach_isTheStartHeightToTheThreshold() {
    Cases cases(20261203);
    const aircraft::GlideModel model(test::cessna());
    safety::GlideRates rates(model);
    for (int number = 0; number < 1000; ++number) {
      Case one = cases.next();
      one.mission.approach = {};
      one.mission.safety.reactionLoss = {};
      const terrain::ElevationGrid grid(-2000.0, -2000.0, 4000.0 / 60.0, 60, 60, cases.ground());
      const double arrival = one.site.elevation.metres() + one.mission.safety.arrivalMargin.si();
      QVERIFY(safety::requiredStartHeight(one.start, one.pieces, one.site, one.mission, grid, rates) ==
              safety::requiredStartHeight(one.start, one.pieces, arrival, grid, kClearance, rates));
    }
  }

  void otherEndThanTheApproach_givesInfinity() {
    mission::Mission mission;
    mission.approach.kind = mission::ApproachKind::Straight;
    const terrain::ElevationGrid grid = test::TestTerrain().grid();
    const aircraft::GlideModel model(test::cessna());
    safety::GlideRates rates(model);
    const auto heightOf = [&](const std::vector<flight::Piece>& pieces) {
      return safety::requiredStartHeight({0.0, 0.0, 0.0}, pieces, {}, mission, grid, rates);
    };
    QVERIFY(std::isfinite(heightOf({{flight::Turn::Straight, 0.0, 1000.0}})));
    QVERIFY(!std::isfinite(heightOf({{flight::Turn::Straight, 0.0, 999.0}})));
    QVERIFY(!std::isfinite(heightOf({})));
    mission.approach.kind = mission::ApproachKind::Overhead;
    QVERIFY(std::isfinite(heightOf({{flight::Turn::Left, 100.0, 200.0 * Angle::kPi}})));
    QVERIFY(!std::isfinite(heightOf({{flight::Turn::Straight, 0.0, 1000.0}})));
  }
};

QTEST_APPLESS_MAIN(TestApproachHeights)
#include "tst_approach_heights.moc"
