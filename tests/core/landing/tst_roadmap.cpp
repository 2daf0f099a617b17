// The roadmap and its queries: every answer comes with a glide that the checker confirms.
#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"
#include "core/landing/rrt_star.h"
#include "core/safety/witness_check.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace vp;

namespace {

constexpr unsigned kSeed = 99;

landing::TreeRoadmap build(const landing::World& world, int samples, std::uint64_t seed = 1) {
  landing::RrtStarOptions options;
  options.area = world.terrain.grid().extent();
  options.samples = samples;
  options.seed = seed;
  return *landing::buildRrtStarRoadmap(world, options, Job{});
}

}  // namespace

class TestRoadmap : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { qInfo("seed %u", kSeed); }

  void witness_underTheChecker_provesTheAltitude() {
    const landing::World world = test::mountainWorld();
    const landing::TreeRoadmap roadmap = build(world, 1500);
    std::mt19937_64 engine(kSeed);
    std::uniform_real_distribution<double> place(-2400.0, 2400.0);
    std::uniform_real_distribution<double> heading(0.0, 2.0 * Angle::kPi);
    landing::QueryScratch scratch;
    int answered = 0;
    for (int i = 0; i < 10000; ++i) {
      const geo::Pose pose{place(engine), place(engine), heading(engine)};
      const auto answer = roadmap.query(world, pose, scratch);
      if (!answer) {
        continue;
      }
      ++answered;
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

  void edges_underLoss_onlyGoDown() {
    // least-altitude monotonicity: a node is at least the loss of its edge above the node it glides to
    const landing::World world = test::mountainWorld();
    const landing::TreeRoadmap roadmap = build(world, 10000);
    QCOMPARE(roadmap.nodes().size(), std::size_t(10005));
    for (const landing::RoadmapNode& node : roadmap.nodes()) {
      if (node.parent < 0) {
        continue;
      }
      const landing::RoadmapNode& parent = roadmap.nodes()[static_cast<std::size_t>(node.parent)];
      const flight::TurnLoss losses{world.glide.straightLoss(), world.glide.lossAt(node.toParent.radius)};
      QVERIFY(node.altitude >= parent.altitude + flight::lossOf(node.toParent, losses) - 1e-6);
      QVERIFY(node.altitude >= world.terrain.grid().upperAt(node.pose.point()) + world.clearance - 1e-6);
      QCOMPARE(node.site, parent.site);
    }
  }

  void altitude_underMoreSamples_improvesOnAverage() {
    const landing::World world = test::mountainWorld();
    const landing::TreeRoadmap few = build(world, 0);
    const landing::TreeRoadmap many = build(world, 2000);
    std::mt19937_64 engine(kSeed);
    std::uniform_real_distribution<double> place(-2300.0, 2300.0);
    std::uniform_real_distribution<double> heading(0.0, 2.0 * Angle::kPi);
    landing::QueryScratch scratch;
    double sumFew = 0.0;
    double sumMany = 0.0;
    for (int i = 0; i < 2000; ++i) {
      const geo::Pose pose{place(engine), place(engine), heading(engine)};
      const auto a = few.query(world, pose, scratch);
      const auto b = many.query(world, pose, scratch);
      if (a && b) {
        QVERIFY(b->altitude <= a->altitude + 1e-9);  // the sites stay candidates, so more nodes never hurt
        sumFew += a->altitude;
        sumMany += b->altitude;
      }
    }
    QVERIFY2(sumMany < 0.99 * sumFew, qPrintable(QString("%1 against %2").arg(sumMany).arg(sumFew)));
  }

  void flatGround_underNoObstacle_givesTheDirectGlide() {
    // above flat ground the least altitude is clearance plus the loss of the best Dubins glide to the best site
    landing::World world = test::mountainWorld();
    world.terrain = terrain::TerrainPyramid(test::makeGrid(5000.0, 20.0, [](double, double) { return 0.0; }));
    world.sites = {test::site("E", 0.0, 0.0, 0.0, 0.0)};
    const landing::TreeRoadmap roadmap = build(world, 500);
    landing::QueryScratch scratch;
    std::mt19937_64 engine(kSeed);
    std::uniform_real_distribution<double> place(-1500.0, 1500.0);
    for (int i = 0; i < 1000; ++i) {
      const geo::Pose pose{place(engine), place(engine), place(engine)};
      double direct = 1e300;
      for (const double radius : world.glide.glideRadii()) {
        const flight::TurnLoss losses{world.glide.straightLoss(), world.glide.lossAt(radius)};
        direct = std::min(direct, 100.0 + flight::lossOf(flight::leastLossDubins(pose, world.sites[0].pose, radius, losses), losses));
      }
      const auto answer = roadmap.query(world, pose, scratch);
      QVERIFY(answer && answer->altitude <= direct + 1e-6);
      QVERIFY(answer->altitude >= 100.0 + geo::distance(pose.point(), {0.0, 0.0}) * world.glide.straightLoss() - 1e-6);
    }
  }

  void sameSeed_givesTheSameRoadmap() {
    const landing::World world = test::mountainWorld();
    const landing::TreeRoadmap a = build(world, 800, 5);
    const landing::TreeRoadmap b = build(world, 800, 5);
    const landing::TreeRoadmap c = build(world, 800, 6);
    bool differs = false;
    for (std::size_t i = 0; i < a.nodes().size(); ++i) {
      QVERIFY(a.nodes()[i].pose == b.nodes()[i].pose && a.nodes()[i].altitude == b.nodes()[i].altitude);
      differs = differs || !(a.nodes()[i].pose == c.nodes()[i].pose);
    }
    QVERIFY(differs);
  }

  void unknownGround_isNeverUsed() {
    landing::World world = test::mountainWorld();
    std::vector<float> values(250 * 250, 0.0F);
    for (int j = 0; j < 250; ++j) {
      for (int i = 120; i < 130; ++i) {
        values[static_cast<std::size_t>(j * 250 + i)] = terrain::kUnknownUpper;  // a band of no data from south to north
      }
    }
    world.terrain = terrain::TerrainPyramid(std::make_shared<const terrain::ElevationGrid>(-2500.0, -2500.0, 20.0, 250, 250, std::move(values)));
    world.sites = {test::site("W", -1500.0, 0.0, 0.0, 0.0)};
    const landing::TreeRoadmap roadmap = build(world, 500);
    landing::QueryScratch scratch;
    QVERIFY(roadmap.query(world, {-800.0, 0.0, Angle::kPi}, scratch).has_value());
    QVERIFY(!roadmap.query(world, {800.0, 0.0, Angle::kPi}, scratch).has_value());
    world.sites = {test::site("V", 0.0, 0.0, 0.0, 0.0)};
    landing::RrtStarOptions options;
    options.area = world.terrain.grid().extent();
    const auto none = landing::buildRrtStarRoadmap(world, options, Job{});
    QVERIFY(!none && none.error().code == Errc::NoLandingSite);
  }

  void cancel_stopsWithoutResult() {
    const landing::World world = test::mountainWorld();
    std::stop_source stop;
    landing::RrtStarOptions options;
    options.area = world.terrain.grid().extent();
    options.samples = 1'000'000'000;
    const Job job(stop.get_token(), [&stop](double, std::string_view) { stop.request_stop(); });
    const auto result = landing::buildRrtStarRoadmap(world, options, job);
    QVERIFY(!result && result.error().code == Errc::Cancelled);
  }
};

QTEST_APPLESS_MAIN(TestRoadmap)
#include "tst_roadmap.moc"
