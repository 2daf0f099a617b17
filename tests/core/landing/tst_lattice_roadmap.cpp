// The lattice roadmap: every answer comes with a glide that the checker confirms, and none is missed that RRT* finds.
#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"
#include "core/landing/lattice_ground.h"
#include "core/landing/lattice_roadmap.h"
#include "core/landing/required_height.h"
#include "core/landing/rrt_star.h"
#include "core/safety/witness_check.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace vp;

namespace {

constexpr unsigned kSeed = 1124;

landing::LatticeRoadmap build(const landing::World& world, std::optional<double> step = std::nullopt) {
  return *landing::buildLatticeRoadmap(world, {world.terrain.grid().extent(), step}, Job{});
}

struct RandomPoses {
  std::mt19937_64 engine{kSeed};
  double side = 2400.0;
  geo::Pose operator()() {
    std::uniform_real_distribution<double> place(-side, side);
    std::uniform_real_distribution<double> heading(0.0, 2.0 * Angle::kPi);
    return {place(engine), place(engine), heading(engine)};
  }
};

landing::World flatWorld() {
  landing::World world = test::mountainWorld();
  world.terrain = terrain::TerrainPyramid(test::makeGrid(5000.0, 20.0, [](double, double) { return 0.0; }));
  world.sites = {test::site("E", 0.0, 0.0, 0.0, 0.0)};
  return world;
}

/// The mountain with a band of no data from south to north.
landing::World bandWorld() {
  landing::World world = test::mountainWorld();
  std::vector<float> values(250 * 250, 0.0F);
  for (int j = 0; j < 250; ++j) {
    for (int i = 120; i < 130; ++i) {
      values[static_cast<std::size_t>(j * 250 + i)] = terrain::kUnknownUpper;
    }
  }
  world.terrain = terrain::TerrainPyramid(std::make_shared<const terrain::ElevationGrid>(-2500.0, -2500.0, 20.0, 250, 250, std::move(values)));
  world.sites = {test::site("W", -1500.0, 0.0, 0.0, 0.0)};
  return world;
}

}  // namespace

class TestLatticeRoadmap : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { qInfo("seed %u", kSeed); }

  void witness_underTheChecker_provesTheAltitude_data() {
    QTest::addColumn<double>("step");
    QTest::newRow("as chosen") << 100.0;
    QTest::newRow("fine") << 60.0;
    QTest::newRow("coarse") << 260.0;
  }

  void witness_underTheChecker_provesTheAltitude() {
    QFETCH(double, step);
    const landing::World world = test::mountainWorld();
    const landing::LatticeRoadmap roadmap = build(world, step);
    RandomPoses poses;
    landing::QueryScratch scratch;
    int answered = 0;
    int hint = -1;
    for (int i = 0; i < 10000; ++i) {
      const geo::Pose pose = poses();
      const auto answer = roadmap.query(world, pose, scratch, i % 2 == 0 ? -1 : hint);
      if (!answer) {
        continue;
      }
      ++answered;
      hint = answer->node;
      const std::vector<flight::Piece> pieces = roadmap.witnessPieces(*answer);
      const mission::SiteInFrame& site = world.sites[static_cast<std::size_t>(answer->site)];
      const geo::Pose end = flight::endOf(flight::Curve{pose, pieces, {}}, world.glide.airspeed());
      QVERIFY(geo::distance(end.point(), site.pose.point()) < 1e-3);
      QVERIFY(std::abs(wrapPi(end.heading - site.pose.heading)) < 1e-6);
      const double checked =
          safety::requiredStartHeight(pose, pieces, site.site.elevation.metres(), world.terrain.grid(), world.clearance, world.glide);
      QVERIFY2(answer->altitude >= checked - 1e-6, qPrintable(QString("case %1: %2 below %3").arg(i).arg(answer->altitude).arg(checked)));
      QVERIFY(answer->altitude <= checked + 60.0);  // and not wildly above it
    }
    QVERIFY(answered > 9000);
    QCOMPARE(scratch.queries, std::int64_t(10000));
  }

  void stateAltitudes_underTheChecker_areNotBelowTheirGlides() {
    const landing::World world = test::mountainWorld();
    const landing::LatticeRoadmap roadmap = build(world);
    const landing::LatticeGlides& glides = roadmap.glides();
    int checkedStates = 0;
    for (int state = 0; state < glides.states(); state += 3) {
      const int next = glides.nextOf(state);
      if (next < 0) {
        continue;
      }
      QVERIFY(glides.altitudeOf(next) < glides.altitudeOf(state));  // so no chain of glides can run in a circle
      landing::SafeAltitude answer;
      answer.node = next;
      answer.first = glides.legOf(state);
      const std::vector<flight::Piece> pieces = roadmap.witnessPieces(answer);
      const mission::SiteInFrame& site = world.sites[static_cast<std::size_t>(glides.siteOf(state))];
      const double checked =
          safety::requiredStartHeight(glides.poseOf(state), pieces, site.site.elevation.metres(), world.terrain.grid(), world.clearance, world.glide);
      QVERIFY2(glides.altitudeOf(state) >= checked - 1e-6,
               qPrintable(QString("state %1: %2 below %3").arg(state).arg(glides.altitudeOf(state)).arg(checked)));
      ++checkedStates;
    }
    QVERIFY(checkedStates > 10000);
  }

  void ground_underEveryPrimitive_isNotBelowTheExactBound() {
    const landing::World world = test::mountainWorld();
    const landing::LatticeRoadmap roadmap = build(world);
    const landing::LatticeGlides& glides = roadmap.glides();
    const landing::LatticeGround ground(world, glides);
    std::mt19937_64 engine(kSeed);
    double excess = 0.0;
    int cases = 0;
    while (cases < 10000) {
      const int column = static_cast<int>(engine() % static_cast<unsigned>(glides.columns));
      const int row = static_cast<int>(engine() % static_cast<unsigned>(glides.rows));
      const int heading = static_cast<int>(engine() % static_cast<unsigned>(glides.headings()));
      const auto& arrivals = glides.primitives.arrivals[static_cast<std::size_t>(heading)];
      const std::size_t i = engine() % arrivals.size();
      const landing::GlidePrimitive& primitive = arrivals[i];
      if (!glides.isInside(column - primitive.columns, row - primitive.rows)) {
        continue;
      }
      const geo::Pose start = glides.poseOf(glides.stateAt(column - primitive.columns, row - primitive.rows, primitive.from));
      const geo::Pose end = glides.poseOf(glides.stateAt(column, row, heading));
      const landing::RadiusLoss& radius = glides.radii[primitive.radius];
      const auto path = flight::dubinsWord(start, end, radius.radius, primitive.word);
      QVERIFY(path);
      std::vector<flight::Piece> pieces;
      flight::appendPieces(*path, pieces);
      // far below the ground on arrival, so that the ground alone decides
      const double exact = safety::requiredStartHeight(start, pieces, -1e5, world.terrain.grid(), world.clearance, world.glide);
      const double found = static_cast<double>(ground.arrivalsAt(heading, column, row).required(i));
      if (!std::isfinite(exact)) {
        QVERIFY(!std::isfinite(found));
        continue;
      }
      QVERIFY2(found >= exact, qPrintable(QString("case %1: %2 below %3").arg(cases).arg(found).arg(exact)));
      QVERIFY(found <= static_cast<double>(ground.highestAround(column, row)) + primitive.loss + 0.01);
      excess += std::isfinite(found) ? found - exact : 0.0;
      ++cases;
    }
    qInfo("mean excess %.3f m", excess / cases);
    QVERIFY(excess / cases < 1.5);  // a few cells more than the curve touches, not many
  }

  void lattice_againstRrtStar_findsLowerAltitudes() {
    const landing::World world = test::mountainWorld();
    const landing::LatticeRoadmap lattice = build(world);
    landing::RrtStarOptions options;
    options.area = world.terrain.grid().extent();
    options.samples = 4000;
    const landing::TreeRoadmap tree = *landing::buildRrtStarRoadmap(world, options, Job{});
    RandomPoses poses;
    landing::QueryScratch scratch;
    double sumLattice = 0.0;
    double sumTree = 0.0;
    for (int i = 0; i < 3000; ++i) {
      const geo::Pose pose = poses();
      const auto a = lattice.query(world, pose, scratch);
      const auto b = tree.query(world, pose, scratch);
      QVERIFY2(!b || a, qPrintable(QString("no glide in case %1").arg(i)));
      if (a && b) {
        sumLattice += a->altitude;
        sumTree += b->altitude;
      }
    }
    QVERIFY2(sumLattice < sumTree, qPrintable(QString("%1 against %2").arg(sumLattice).arg(sumTree)));
  }

  void flatGround_underNoObstacle_givesTheDirectGlide() {
    const landing::World world = flatWorld();
    const landing::LatticeRoadmap roadmap = build(world);
    landing::QueryScratch scratch;
    RandomPoses poses;
    poses.side = 1500.0;
    double excess = 0.0;
    for (int i = 0; i < 1000; ++i) {
      const geo::Pose pose = poses();
      double direct = 1e300;
      for (const double radius : world.glide.glideRadii()) {
        const flight::TurnLoss losses{world.glide.straightLoss(), world.glide.lossAt(radius)};
        direct = std::min(direct, 100.0 + flight::lossOf(flight::leastLossDubins(pose, world.sites[0].pose, radius, losses), losses));
      }
      const auto answer = roadmap.query(world, pose, scratch);
      QVERIFY(answer);
      QVERIFY(answer->altitude >= 100.0 + geo::distance(pose.point(), {0.0, 0.0}) * world.glide.straightLoss() - 1e-6);
      QVERIFY(answer->altitude <= direct + 20.0);
      excess += answer->altitude - direct;
    }
    QVERIFY2(excess / 1000 < 0.5, qPrintable(QString::number(excess / 1000)));
  }

  void unknownGround_isNeverUsed() {
    landing::World world = bandWorld();
    const landing::LatticeRoadmap roadmap = build(world);
    landing::QueryScratch scratch;
    QVERIFY(roadmap.query(world, {-800.0, 0.0, Angle::kPi}, scratch).has_value());
    QVERIFY(!roadmap.query(world, {800.0, 0.0, Angle::kPi}, scratch).has_value());
    QVERIFY(!roadmap.query(world, {9000.0, 0.0, Angle::kPi}, scratch).has_value());  // outside the terrain
    world.sites = {test::site("V", 0.0, 0.0, 0.0, 0.0)};
    const auto none = landing::buildLatticeRoadmap(world, {world.terrain.grid().extent(), std::nullopt}, Job{});
    QVERIFY(!none && none.error().code == Errc::NoLandingSite);
  }

  void twoBuilds_areTheSame() {
    const landing::World world = test::mountainWorld();
    const landing::LatticeRoadmap a = build(world);
    const landing::LatticeRoadmap b = build(world);
    QVERIFY(a.glides().altitude == b.glides().altitude && a.glides().via == b.glides().via && a.glides().leg == b.glides().leg);
    QVERIFY(a.size() > 30000);
  }

  void primitives_areTheSameTurnedByQuarters() {
    const landing::GlidePrimitives set = landing::makeGlidePrimitives(landing::radiusLossesOf(test::mountainWorld().glide), 100.0);
    QCOMPARE(set.headings.size(), std::size_t(16));
    for (std::size_t h = 0; h < 16; ++h) {
      QCOMPARE(set.arrivals[h].size(), set.arrivals[(h + 4) % 16].size());
      QVERIFY(set.arrivals[h].size() > 10);
    }
  }

  void emptyArea_isRefused() {
    const auto result = landing::buildLatticeRoadmap(test::mountainWorld(), {}, Job{});
    QVERIFY(!result && result.error().code == Errc::OutOfRange);
  }

  void cancel_stopsWithoutResult() {
    const landing::World world = test::mountainWorld();
    std::stop_source stop;
    const Job job(stop.get_token(), [&stop](double, std::string_view) { stop.request_stop(); });
    const auto result = landing::buildLatticeRoadmap(world, {world.terrain.grid().extent(), 40.0}, job);
    QVERIFY(!result && result.error().code == Errc::Cancelled);
  }
};

QTEST_APPLESS_MAIN(TestLatticeRoadmap)
#include "tst_lattice_roadmap.moc"
