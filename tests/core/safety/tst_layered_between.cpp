// Where the loss depends on the altitude: engine failures between two points, and last parts whose clearance falls, against dense samples flown in
// small steps.

#include "core/safety/failures.h"
#include "core/safety/ground_path.h"
#include "core/safety/witness_check.h"
#include "tests/core/safety/layered_cases.h"
#include "tests/support/path_check.h"

#include <QTest>

#include <limits>

using namespace vp;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Glides flown in small steps, each losing what its band loses there.
class SmallSteps {
public:
  SmallSteps(safety::GlideRates& rates, double course, const flight::Piece& piece, int count) : edges_(rates.edges()), count_(count) {
    for (std::size_t band = 0; band < rates.bandCount(); ++band) {
      const safety::LossAlong loss = rates.alongIn(band, course, piece);
      lost_.emplace_back();
      for (int i = 0; i < count; ++i) {
        lost_.back().push_back(loss.upTo(piece.length * (i + 1) / count) - loss.upTo(piece.length * i / count));
        greatest_ = std::max(greatest_, lost_.back().back());
      }
    }
  }
  /// Height at the end of a glide begun at a step.
  [[nodiscard]] double down(int from, double height, int to) const {
    for (int i = from; i < to; ++i) {
      height -= lost_[bandOf(height)][static_cast<std::size_t>(i)];
    }
    return height;
  }
  [[nodiscard]] double greatestStep() const { return greatest_; }

private:
  [[nodiscard]] std::size_t bandOf(double height) const {
    return static_cast<std::size_t>(std::lower_bound(edges_.begin(), edges_.end(), height) - edges_.begin());
  }

  std::vector<double> edges_;
  int count_ = 0;
  std::vector<std::vector<double>> lost_;
  double greatest_ = 0.0;
};

/// A height on which bands change is near.
double nearAnEdge(test::LayeredCases& cases, const safety::GlideRates& rates) {
  if (!rates.isLayered()) {
    return 1000.0 * cases.unit();
  }
  return rates.edges()[static_cast<std::size_t>(cases.below(static_cast<int>(rates.edges().size())))] + cases.between(-60.0, 120.0);
}

}  // namespace

class TestLayeredBetween : public QObject {
  Q_OBJECT

private slots:
  void failuresAtAllPlaces_areNeverBelowTheLowest_andOneReachesIt() {
    constexpr std::uint64_t kSeed = 20261211;
    constexpr int kSteps = 400;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::LayeredCases cases(kSeed);
    int inner = 0;
    for (int number = 0; number < 25; ++number) {
      const mission::Plan plan = cases.plan();
      safety::GlideRates rates(safety::conditionsOf(plan), plan.mission.aircraft);
      for (int i = 0; i < 400; ++i) {
        const flight::Piece piece{static_cast<flight::Turn>(cases.below(3) - 1), rates.leastTourRadius(), 50.0 + 1500.0 * cases.unit()};
        const double course = 12.0 * cases.unit() - 6.0;
        const double start = nearAnEdge(cases, rates);
        const double end = start + piece.length * (cases.below(2) == 0 ? cases.between(-0.25, 0.15) : cases.between(-0.13, -0.07));
        const double reaction = cases.below(2) * 30.0 * cases.unit();
        safety::Descent descent(rates, course, piece);
        safety::Failures failures(start, end, piece.length, descent, reaction);
        const SmallSteps steps(rates, course, piece, kSteps);
        for (const int to : {kSteps / 3, kSteps}) {
          const double found = failures.lowestAt(piece.length * to / kSteps);
          const double there = start + (end - start) * to / kSteps;
          const double lowest = std::min(found, there);  // the place itself is the tour's own
          double flown = there;
          for (int k = 0; k <= to; ++k) {
            flown = std::min(flown, steps.down(k, start + (end - start) * k / kSteps - reaction, to) + reaction);
          }
          const double apart = 3.0 * steps.greatestStep();
          QVERIFY2(std::abs(flown - lowest) < apart, QString("set %1, %2: %3 flown, %4").arg(number).arg(i).arg(flown).arg(lowest).toUtf8());
          const double first = steps.down(0, start - reaction, to) + reaction;
          inner += flown < std::min(first, there) - apart ? 1 : 0;
        }
      }
    }
    qInfo("in %d the worst failure is neither at the start nor at the end", inner);
    QVERIFY(inner > 30);
  }

  /// The last part's clearance falls along an obstacle surface: heights asked for at dense places, flown back up in small steps, are never above the
  /// lowest start and come near it.
  void lastPartOverAnObstacleSurface_isDecidedWhereDenseSamplesAre() {
    constexpr std::uint64_t kSeed = 20261212;
    constexpr int kSteps = 3000;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::LayeredCases cases(kSeed);
    int decided = 0;
    for (int number = 0; number < 25; ++number) {
      mission::Plan plan = cases.plan();
      plan.mission.approach.kind = cases.below(2) == 0 ? mission::ApproachKind::Straight : mission::ApproachKind::Overhead;
      safety::GlideRates rates(safety::conditionsOf(plan), plan.mission.aircraft);
      const terrain::ElevationGrid grid = cases.ground(500.0);
      for (int i = 0; i < 20; ++i) {
        const double radius = rates.leastGlideRadius();
        const flight::Piece piece = plan.mission.approach.kind == mission::ApproachKind::Straight
                                        ? flight::Piece{flight::Turn::Straight, 0.0, 500.0 + 1500.0 * cases.unit()}
                                        : flight::Piece{flight::Turn::Left, radius, 2.0 * Angle::kPi * radius};
        plan.mission.approach.finalLength = Length::fromSi(piece.length);
        plan.mission.approach.surfaceSlope = cases.between(0.02, 0.4);
        plan.mission.approach.surfaceStart = Length::fromSi(100.0 * cases.unit());
        plan.mission.safety.clearance = Length::fromSi(300.0);
        const geo::Pose start = cases.start();
        mission::LandingSite site;
        site.elevation = geo::HeightMsl::fromMetres(100.0 * cases.unit());
        const double found = safety::requiredStartHeight(start, {piece}, site, plan.mission, grid, rates);
        double sampled = site.elevation.metres();
        safety::Descent descent(rates, start.heading, piece);
        sampled = std::max(descent.up(piece.length, sampled, 0.0), grid.upperAt(start.point()) + 300.0);  // where a glide begins, it is the tour's
        const double arrival = sampled;
        double above = sampled;
        for (int k = 0; k <= kSteps; ++k) {
          const double at = piece.length * k / kSteps;
          const double toGo = piece.length - at - plan.mission.approach.surfaceStart.si();
          const double asked = std::min(300.0, *plan.mission.approach.surfaceSlope * std::max(0.0, toGo));
          const geo::Point there = safety::poseOn(start, piece, at).point();
          sampled = std::max(sampled, descent.up(at, grid.upperAt(there) + asked, 0.0));
          const double ground = test::groundNear(grid, there.x, there.y, piece.length / kSteps);
          above = std::max(above, descent.up(at, ground + asked, 0.0));
        }
        above += (0.4 + 0.4) * piece.length / kSteps;  // steepest surface and glide, over a step
        QVERIFY2(found >= sampled - 1e-6 && found <= above,
                 QString("set %1, %2: %3, sampled %4 to %5").arg(number).arg(i).arg(found).arg(sampled).arg(above).toUtf8());
        decided += sampled > arrival ? 1 : 0;
      }
    }
    QVERIFY(decided > 150);
  }

  void glideUp_isInfiniteWhereNoGlideExists() {
    test::LayeredCases cases(20261213);
    mission::Plan plan = cases.plan();
    plan.mission.wind = {test::layerOf(0.0, 90.0, 0.0, 5.0, 5.0), test::layerOf(500.0, 90.0, 0.0, 25.0, 25.0)};
    safety::GlideRates rates(safety::conditionsOf(plan), plan.mission.aircraft);
    safety::Descent descent(rates, 0.0, {flight::Turn::Left, 25.0, 500.0});  // so tight that the drag exceeds the weight
    QCOMPARE(descent.up(500.0, 100.0, 0.0), kInfinity);
    QCOMPARE(descent.down(0.0, 100.0, 500.0), -kInfinity);
    QCOMPARE(descent.down(100.0, 100.0, 100.0), 100.0);
  }
};

QTEST_APPLESS_MAIN(TestLayeredBetween)
#include "tst_layered_between.moc"
