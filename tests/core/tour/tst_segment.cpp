// Segments: the terrain segment never costs more than the safe one, which LAZY rests on ([1] (19)).
#include "core/base/quantity.h"
#include "core/landing/rrt_star.h"
#include "core/tour/segment.h"
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
