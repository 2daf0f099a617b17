// Runways one by one: the best of them is what the roadmap over all of them finds, every glide holds under the checker, and
// only runways that can matter are built.
#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"
#include "core/landing/site_roadmaps.h"
#include "core/safety/witness_check.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <cmath>
#include <random>
#include <set>
#include <thread>

using namespace vp;

namespace {

constexpr unsigned kSeed = 4711;

landing::RrtStarOptions optionsFor(const landing::World& world, int samples) {
  landing::RrtStarOptions options;
  options.area = world.terrain.grid().extent();
  options.samples = samples;
  return options;
}

std::shared_ptr<const landing::World> shared(landing::World world) {
  return std::make_shared<const landing::World>(std::move(world));
}

/// Flat ground, 40 km across, one runway every 3 km along the x axis.
landing::World rowOfRunways() {
  landing::World world = test::mountainWorld();
  world.terrain = terrain::TerrainPyramid(test::makeGrid(40000.0, 100.0, [](double, double) { return 0.0; }));
  world.sites.clear();
  for (int i = 0; i < 10; ++i) {
    const double x = -15000.0 + 3000.0 * i;
    const std::string ident = "R" + std::to_string(i);
    world.sites.push_back(test::site((ident + "/09").c_str(), x, 0.0, 0.0, 0.0));
    world.sites.push_back(test::site((ident + "/27").c_str(), x + 600.0, 0.0, Angle::kPi, 0.0));
  }
  return world;
}

}  // namespace

class TestSiteRoadmaps : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { qInfo("seed %u", kSeed); }

  void ends_ofOneStrip_areOneRunway() {
    landing::World world = test::mountainWorld();
    const landing::SiteRoadmaps mountain(shared(world), optionsFor(world, 0));
    QCOMPARE(mountain.runways().size(), std::size_t(3));
    QCOMPARE(mountain.runwayOf(0), mountain.runwayOf(1));
    QVERIFY(mountain.runwayOf(1) != mountain.runwayOf(2));
    // parallel runways 210 m apart, listed in an order that tempts to pair the wrong ends
    world.sites = {test::site("P/09L", 0.0, 210.0, 0.0, 0.0), test::site("P/27L", 900.0, 0.0, Angle::kPi, 0.0),
                   test::site("P/27R", 900.0, 210.0, Angle::kPi - 0.05, 0.0), test::site("P/09R", 0.0, 0.0, 0.0, 0.0)};
    const landing::SiteRoadmaps parallel(shared(world), optionsFor(world, 0));
    QCOMPARE(parallel.runways().size(), std::size_t(2));
    QCOMPARE(parallel.runwayOf(0), parallel.runwayOf(2));
    QCOMPARE(parallel.runwayOf(1), parallel.runwayOf(3));
  }

  void best_underRandomPoses_isCloseToAllSitesTogether() {
    const auto world = shared(test::mountainWorld());
    landing::SiteRoadmaps each(world, optionsFor(*world, 1500));
    const landing::TreeRoadmap together = *landing::buildRrtStarRoadmap(*world, optionsFor(*world, 4500), Job{});
    std::mt19937_64 engine(kSeed);
    std::uniform_real_distribution<double> place(-2300.0, 2300.0);
    std::uniform_real_distribution<double> heading(0.0, 2.0 * Angle::kPi);
    landing::QueryScratch scratch;
    double sumEach = 0.0;
    double sumTogether = 0.0;
    int answered = 0;
    for (int i = 0; i < 10000; ++i) {
      const geo::Pose pose{place(engine), place(engine), heading(engine)};
      const auto answers = each.alternatives(pose, 1000.0, 3, Job{});
      QVERIFY(answers.has_value());
      const auto all = together.query(*world, pose, scratch);
      if (answers->empty() || !all) {
        continue;
      }
      ++answered;
      sumEach += answers->front().altitude;
      sumTogether += all->altitude;
      double before = -1e9;
      std::set<int> runways;
      for (const landing::SiteAnswer& answer : *answers) {
        const mission::SiteInFrame& site = world->sites[static_cast<std::size_t>(answer.site)];
        const double checked =
            safety::requiredStartHeight(pose, answer.pieces, site.site.elevation.metres(), world->terrain.grid(), world->clearance, world->glide);
        QVERIFY2(answer.altitude >= checked - 1e-6, qPrintable(QString("case %1: %2 below %3").arg(i).arg(answer.altitude).arg(checked)));
        const geo::Pose end = flight::endOf(flight::Curve{pose, answer.pieces, {}}, world->glide.airspeed());
        QVERIFY(geo::distance(end.point(), site.pose.point()) < 1e-3);
        QVERIFY(answer.altitude >= before);
        QCOMPARE(answer.margin, 1000.0 - answer.altitude);
        QVERIFY(answer.directAltitude >= answer.altitude - 1e-6);
        QVERIFY(answer.seconds >= answer.length / world->glide.airspeed());
        before = answer.altitude;
        QVERIFY(runways.insert(each.runwayOf(answer.site)).second);
      }
    }
    QVERIFY(answered > 9000);
    QVERIFY2(std::abs(sumEach - sumTogether) < 0.03 * sumTogether, qPrintable(QString("%1 against %2").arg(sumEach).arg(sumTogether)));
    QCOMPARE(each.builtCount(), std::size_t(3));
  }

  void farRunways_areNotBuilt_andNothingBetterIsLeftOut() {
    const auto world = shared(rowOfRunways());
    landing::SiteRoadmaps few(world, optionsFor(*world, 200));
    const geo::Pose pose{-14000.0, 500.0, 0.3};
    const auto nearest = few.alternatives(pose, 800.0, 2, Job{});
    QVERIFY(nearest && nearest->size() == 2);
    QVERIFY2(few.builtCount() >= 2 && few.builtCount() <= 4, qPrintable(QString::number(few.builtCount())));
    landing::SiteRoadmaps all(world, optionsFor(*world, 200));
    const auto every = all.alternatives(pose, 800.0, 100, Job{});
    QVERIFY(every && every->size() == 10);
    QCOMPARE(all.builtCount(), std::size_t(10));
    QCOMPARE((*every)[0].site, (*nearest)[0].site);
    QCOMPARE((*every)[1].site, (*nearest)[1].site);
    QCOMPARE((*every)[1].altitude, (*nearest)[1].altitude);
    QVERIFY((*every)[9].margin < 0.0 && !(*every)[9].isReachable());
    QVERIFY((*every)[0].isReachable() && !(*every)[0].isAroundTerrain());  // flat ground: nothing to go around
  }

  void runwayBehindARidge_isReachableOnlyAroundIt() {
    landing::World world = test::mountainWorld();
    world.terrain =
        terrain::TerrainPyramid(test::makeGrid(8000.0, 20.0, [](double x, double y) { return std::abs(x) < 100.0 && y > -1500.0 ? 2000.0 : 0.0; }));
    world.sites = {test::site("E/09", 1500.0, 0.0, 0.0, 0.0)};
    landing::SiteRoadmaps roadmaps(shared(world), optionsFor(world, 3000));
    const auto answers = roadmaps.alternatives({-1500.0, 0.0, 1.5 * Angle::kPi}, 1200.0, 1, Job{});
    QVERIFY(answers && answers->size() == 1);
    QVERIFY(answers->front().directAltitude > 2000.0);
    QVERIFY2(answers->front().isAroundTerrain(), qPrintable(QString::number(answers->front().altitude)));
  }

  void siteOnUnknownGround_hasNoAnswer() {
    landing::World world = rowOfRunways();
    world.sites.push_back(test::site("V/09", 90000.0, 0.0, 0.0, 0.0));
    landing::SiteRoadmaps roadmaps(shared(world), optionsFor(world, 50));
    const auto answers = roadmaps.alternatives({0.0, 0.0, 0.0}, 500.0, 100, Job{});
    QVERIFY(answers && answers->size() == 10);
  }

  void cancel_stopsWithoutResult_andLaterCallsWork() {
    const auto world = shared(rowOfRunways());
    landing::SiteRoadmaps roadmaps(world, optionsFor(*world, 300));
    std::stop_source stop;
    const Job job(stop.get_token(), [&stop](double, std::string_view) { stop.request_stop(); });
    const auto result = roadmaps.alternatives({0.0, 0.0, 0.0}, 500.0, 5, job);
    QVERIFY(!result && result.error().code == Errc::Cancelled);
    QVERIFY(roadmaps.alternatives({0.0, 0.0, 0.0}, 500.0, 1, Job{}).has_value());
  }

  void cancel_whileAnotherBuilds_returns() {
    const auto world = shared(rowOfRunways());
    landing::SiteRoadmaps roadmaps(world, optionsFor(*world, 1'000'000'000));
    std::stop_source first;
    std::stop_source second;
    std::atomic_bool building = false;
    std::jthread other([&] {
      const Job job(first.get_token(), [&](double, std::string_view) { building = true; });
      (void)roadmaps.alternatives({0.0, 0.0, 0.0}, 500.0, 1, job);
    });
    QTRY_VERIFY(building);
    second.request_stop();
    const auto waiting = roadmaps.alternatives({0.0, 0.0, 0.0}, 500.0, 1, Job(second.get_token()));
    QVERIFY(!waiting && waiting.error().code == Errc::Cancelled);
    first.request_stop();
  }
};

QTEST_APPLESS_MAIN(TestSiteRoadmaps)
#include "tst_site_roadmaps.moc"
