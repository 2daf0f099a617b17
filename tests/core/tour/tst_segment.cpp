// Segments: the terrain segment never costs more than the safe one, which LAZY rests on ([1] (19)).
#include "core/base/quantity.h"
#include "core/landing/rrt_star.h"
#include "core/tour/segment.h"
#include "core/tour/segment_bound.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace vp;
using namespace vp::tour;

namespace {

constexpr unsigned kSeed = 23;

landing::TreeRoadmap build(const landing::World& world) {
  landing::RrtStarOptions options;
  options.area = world.terrain.grid().extent();
  options.samples = 800;
  return *landing::buildRrtStarRoadmap(world, options, Job{});
}

SegmentSettings settings(double beta) {
  SegmentSettings s;
  s.step = 250.0;
  s.beta = beta;
  s.pitch = {std::tan(0.52), std::tan(0.35)};
  return s;
}

/// The mountain with a block of unknown ground in the middle of the map.
landing::World holedWorld() {
  const auto full = test::makeGrid(5000.0, 20.0, test::mountainHeight);
  std::vector<float> values = full->values();
  for (int row = 60; row < 110; ++row) {
    for (int column = 90; column < 190; ++column) {
      values[static_cast<std::size_t>(row * full->columns() + column)] = terrain::kUnknownUpper;
    }
  }
  landing::World world = test::mountainWorld();
  world.terrain = terrain::TerrainPyramid(
      std::make_shared<const terrain::ElevationGrid>(full->originX(), full->originY(), 20.0, full->columns(), full->rows(), std::move(values)));
  return world;
}

struct RandomVisits {
  const landing::World& world;
  std::mt19937_64 engine{kSeed};
  VisitPose operator()(int target) {
    std::uniform_real_distribution<double> place(-2200.0, 2200.0);
    std::uniform_real_distribution<double> heading(0.0, 2.0 * Angle::kPi);
    const geo::Pose pose{place(engine), place(engine), heading(engine)};
    return {target, pose, world.terrain.grid().upperAt(pose.point()) + 100.0};
  }
};

}  // namespace

class TestSegment : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { qInfo("seed %u", kSeed); }

  void terrainSegment_underRandomPairs_isALowerBound() {
    const landing::World world = test::mountainWorld();
    const landing::TreeRoadmap roadmap = build(world);
    const Detours detours;
    SegmentBuilder builder(world, roadmap, detours, settings(2.0));
    RandomVisits visit{world};
    int raised = 0;
    for (int i = 0; i < 10000; ++i) {
      const VisitPose a = visit(0);
      const VisitPose b = visit(1);
      const SegmentCost terrain = builder.terrainSegment(a, b);
      const SegmentCost safe = builder.safeSegment(a, b);
      QVERIFY2(terrain.cost <= safe.cost * (1.0 + 1e-12), qPrintable(QString("case %1: %2 above %3").arg(i).arg(terrain.cost).arg(safe.cost)));
      QVERIFY(terrain.cost >= geo::distance(a.pose.point(), b.pose.point()));
      QVERIFY(terrain.peak <= safe.peak + 1e-9);
      raised += safe.cost > terrain.cost + 1.0 ? 1 : 0;
    }
    QVERIFY(raised > 1000);
  }

  void bounds_underRandomPairs_areBelowTheSafeSegment_data() {
    QTest::addColumn<double>("step");
    QTest::addColumn<double>("ceiling");
    QTest::addColumn<bool>("hasHole");
    QTest::addColumn<bool>("knowsEnds");
    QTest::addColumn<double>("reaction");
    QTest::newRow("steps of 50 m") << 50.0 << SegmentSettings{}.ceiling << false << true << 0.0;
    QTest::newRow("steps of 250 m, ends not asked") << 250.0 << SegmentSettings{}.ceiling << false << false << 0.0;
    QTest::newRow("near the ceiling") << 100.0 << 750.0 << false << true << 0.0;
    QTest::newRow("around unknown ground") << 100.0 << SegmentSettings{}.ceiling << true << true << 0.0;
    QTest::newRow("around unknown ground, ceiling") << 100.0 << 900.0 << true << false << 0.0;
    QTest::newRow("steps of 50 m, late") << 50.0 << SegmentSettings{}.ceiling << false << true << 180.0;
    QTest::newRow("around unknown ground, ceiling, late") << 100.0 << 950.0 << true << false << 180.0;
  }

  void bounds_underRandomPairs_areBelowTheSafeSegment() {
    QFETCH(double, step);
    QFETCH(double, ceiling);
    QFETCH(bool, hasHole);
    QFETCH(bool, knowsEnds);
    QFETCH(double, reaction);
    landing::World world = hasHole ? holedWorld() : test::mountainWorld();
    world.reactionLength = reaction;
    world.reactionLoss = 0.1 * reaction;
    const landing::TreeRoadmap roadmap = build(world);
    const landing::AltitudeFloor floor = *landing::AltitudeFloor::build(world, {}, Job{});
    RandomVisits visit{world};
    constexpr int kVisits = 46;
    std::vector<VisitPose> visits;
    std::vector<geo::Point> places;
    while (visits.size() < kVisits) {
      const VisitPose next = visit(static_cast<int>(visits.size()));
      if (world.terrain.grid().isKnownAt(next.pose.point())) {
        visits.push_back(next);
        places.push_back(next.pose.point());
      }
    }
    SegmentSettings s = settings(2.0);
    s.step = step;
    s.ceiling = ceiling;
    const Detours detours = *Detours::find(world, places, ceiling, Job{});
    SegmentBuilder builder(world, roadmap, detours, s, {}, &floor);
    for (VisitPose& each : visits) {
      if (knowsEnds) {
        builder.ask(each);
      }
    }
    SegmentBound bound(world, floor, detours, s);
    double legs = 0.0;
    double safeOnes = 0.0;
    int detoured = 0;
    int infinite = 0;
    for (const VisitPose& a : visits) {
      for (const VisitPose& b : visits) {
        const SegmentCost safe = builder.safeSegment(a, b);
        const SegmentCost leg = bound.leg(a, b);
        QVERIFY2(leg.cost <= safe.cost, qPrintable(QString("%1 to %2: %3 above %4").arg(a.target).arg(b.target).arg(leg.cost).arg(safe.cost)));
        QVERIFY(a.target == b.target || bound.plain(a, b) <= leg.cost * (1.0 + 1e-12));
        detoured += detours.between(a.target, b.target).empty() ? 0 : 1;
        infinite += std::isfinite(safe.cost) ? 0 : 1;
        if (std::isfinite(safe.cost)) {
          legs += leg.cost;
          safeOnes += safe.cost;
        }
      }
    }
    QCOMPARE(detoured > 0, hasHole || ceiling < 1000.0);
    QVERIFY(infinite > 0 || ceiling > 1000.0);
    qInfo("%d detours, %d without a safe leg; bounds reach %.2f %% of the safe costs", detoured, infinite, 100.0 * legs / safeOnes);
    QVERIFY(legs > 0.85 * safeOnes);
  }

  void safeSegment_underAnAltitudeFloor_costsTheSameForFewerQueries_data() {
    QTest::addColumn<double>("reaction");
    QTest::addColumn<int>("mostQueries");
    QTest::newRow("at once") << 0.0 << 500 * 50 / 2;
    QTest::newRow("late") << 180.0 << 500 * 50;  // two where one was
  }
  void safeSegment_underAnAltitudeFloor_costsTheSameForFewerQueries() {
    QFETCH(double, reaction);
    QFETCH(int, mostQueries);
    landing::World world = test::mountainWorld();
    world.reactionLength = reaction;
    world.reactionLoss = 0.1 * reaction;
    const landing::TreeRoadmap roadmap = build(world);
    const landing::AltitudeFloor floor = *landing::AltitudeFloor::build(world, {}, Job{});
    const Detours detours;
    SegmentSettings s = settings(2.0);
    s.step = 50.0;
    SegmentBuilder plain(world, roadmap, detours, s);
    SegmentBuilder lifted(world, roadmap, detours, s, {}, &floor);
    SegmentBuilder again(world, roadmap, detours, s, {}, &floor);
    RandomVisits visit{world};
    double worst = 0.0;
    for (int i = 0; i < 500; ++i) {
      VisitPose a = visit(0);
      VisitPose b = visit(1);
      const double asked = plain.safeSegment(a, b).cost;
      const double before = lifted.safeSegment(a, b).cost;
      worst = std::max(worst, std::abs(asked / before - 1.0));
      again.ask(a);
      again.ask(b);
      QCOMPARE(again.safeSegment(a, b).cost, before);  // whatever was asked before
    }
    qInfo("%lld queries with the floor, %lld without; costs differ by at most %.2g", static_cast<long long>(lifted.queries()),
          static_cast<long long>(plain.queries()), worst);
    QVERIFY(worst < 0.01);  // the hint of a query may lower an answer
    QVERIFY(lifted.queries() < plain.queries() && lifted.queries() < mostQueries);
  }

  void safePoints_underTheirGlides_areSafeAtBothEndsOfEveryInterval() {
    const landing::World world = test::mountainWorld();
    const landing::TreeRoadmap roadmap = build(world);
    const Detours detours;
    SegmentBuilder builder(world, roadmap, detours, settings(2.0));
    RandomVisits visit{world};
    for (int i = 0; i < 200; ++i) {
      const std::vector<SegmentPoint> points = builder.safePoints(visit(0), visit(1));
      for (std::size_t j = 0; j < points.size(); ++j) {
        QVERIFY(points[j].site >= 0 && !points[j].witness.empty());
        QVERIFY(points[j].lowest >= points[j].safeAltitude);
        if (j + 1 < points.size()) {
          const flight::Piece& piece = points[j].onward;
          QVERIFY(piece.length > 0.0 && piece.length <= 250.0 + 1e-9);
          QVERIFY(points[j].lowest >= points[j + 1].safeAltitude + world.glide.lossAt(piece.radius) * piece.length - 1e-9);
        }
      }
    }
  }

  void ceiling_underTheSafeAltitude_forbidsTheSegment() {
    const landing::World world = test::mountainWorld();
    const landing::TreeRoadmap roadmap = build(world);
    const Detours detours;
    SegmentBuilder open(world, roadmap, detours, settings(2.0));
    RandomVisits visit{world};
    const VisitPose a = visit(0);
    const VisitPose b = visit(1);
    const SegmentCost free = open.safeSegment(a, b);
    SegmentSettings low = settings(2.0);
    low.ceiling = free.peak - 1.0;
    QVERIFY(!std::isfinite(SegmentBuilder(world, roadmap, detours, low).safeSegment(a, b).cost));
    low.ceiling = free.peak;
    QCOMPARE(SegmentBuilder(world, roadmap, detours, low).safeSegment(a, b).cost, free.cost);
  }

  void penalty_underBeta_isChargedHalfAtEachEnd() {
    const landing::World world = test::mountainWorld();
    const landing::TreeRoadmap roadmap = build(world);
    const Detours detours;
    RandomVisits visit{world};
    SegmentBuilder two(world, roadmap, detours, settings(2.0));
    SegmentBuilder four(world, roadmap, detours, settings(4.0));
    for (int i = 0; i < 200; ++i) {
      const VisitPose a = visit(0);
      const VisitPose b = visit(1);
      const std::vector<SegmentPoint> points = two.safePoints(a, b);
      const double extra = four.safeSegment(a, b).cost - two.safeSegment(a, b).cost;
      QVERIFY(extra >= (points.front().lowest - a.altitude) + (points.back().lowest - b.altitude) - 1e-6);
    }
  }
};

QTEST_APPLESS_MAIN(TestSegment)
#include "tst_segment.moc"
