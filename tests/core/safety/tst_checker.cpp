#include "core/aircraft/glide_model.h"
#include "core/safety/checker.h"
#include "core/safety/witness_check.h"
#include "tests/core/safety/interval_cases.h"
#include "tests/support/path_check.h"
#include "tests/support/plan_builder.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>
#include <thread>

using namespace vp;

namespace {

bool isNear(double a, double b, double tolerance) {
  return std::abs(a - b) <= tolerance;
}

}  // namespace

class TestChecker : public QObject {
  Q_OBJECT

private slots:
  void certificate_ofARacetrack_saysWhatWasFound() {
    test::PlanBuilder builder;
    builder.plan().sites[0].site.approximations = {"course from the runway's name"};
    builder.plan().mission.aircraft.stallSpeed = Speed::fromSi(25.0);
    builder.plan().mission.ceiling = geo::HeightMsl::fromMetres(700.0);
    const safety::SafetyReport report = test::checkedPlan(builder.plan(), test::TestTerrain().grid());
    QVERIFY(report.isSafe());
    const mission::Certificate& certificate = *report.certificate;
    QCOMPARE(certificate.pointsChecked, std::int64_t{30});
    QCOMPARE(certificate.glidesChecked, std::int64_t{30});
    QVERIFY(certificate.statement.find("30 decision points") != std::string::npos);
    QVERIFY(certificate.statement.find("at least 100 m above the terrain") != std::string::npos);
    QCOMPARE(certificate.warnings.size(), std::size_t{2});
    QVERIFY(certificate.warnings[0].find("stalls") != std::string::npos);
    QVERIFY(certificate.warnings[1].find("TEST/09 is approximate") != std::string::npos);

    // Margins by hand.
    QVERIFY(certificate.margins == report.margins);
    QVERIFY(isNear(test::marginOf(report, "tour.clearance"), 500.0, 1e-9));
    QVERIFY(isNear(test::marginOf(report, "tour.ceiling"), 100.0, 1e-9));
    QVERIFY(isNear(test::marginOf(report, "tour.climb"), 15.0, 1e-9));
    QVERIFY(isNear(test::marginOf(report, "tour.descent"), 15.0, 1e-9));
    QVERIFY(isNear(test::marginOf(report, "target.height"), 300.0, 1e-9));
    QVERIFY(isNear(test::marginOf(report, "glide.clearance"), 600.0 - builder.highestSafeAltitude(), 1e-6));
    QVERIFY(isNear(test::marginOf(report, "glide.arrival"), 650.0 - builder.highestSafeAltitude(), 1e-6));
    double between = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < builder.plan().tour.size(); ++i) {
      const mission::DecisionPoint& next = builder.plan().tour[(i + 1) % builder.plan().tour.size()];
      between = std::min(between, 600.0 - builder.lossOf({builder.plan().tour[i].onward}) - next.safeAltitude);
    }
    QVERIFY(isNear(test::marginOf(report, "tour.glide"), between, 1e-6));
  }

  void spiral_isCertifiedWithItsException() {
    test::PlanBuilder builder;
    builder.plan().mission.planner.lowTargets = mission::LowTargets::Descend;
    builder.plan().spirals = {{1, 600.0, 300.0, flight::Turn::Left, 200.0, 2, 2}};
    builder.updateMetrics();
    const safety::SafetyReport report = test::checkedPlan(builder.plan(), test::TestTerrain().grid());
    QVERIFY(report.isSafe());
    QVERIFY(report.certificate->statement.find("Exception: between 300 and 600 m MSL at target bridge") != std::string::npos);
    QVERIFY(isNear(test::marginOf(report, "spiral.clearance"), 200.0, 1e-6));
  }

  void certificateInThePlan_isIgnored() {
    test::PlanBuilder builder;
    builder.plan().certificate = mission::Certificate{"all is well", {}, {}, 30, 30};
    builder.plan().tour[4].witness.pieces.clear();
    QVERIFY(!test::checkedPlan(builder.plan(), test::TestTerrain().grid()).isSafe());
  }

  void manyFindings_areCountedNotListed() {
    test::PlanBuilder builder;
    builder.plan().mission.ceiling = geo::HeightMsl::fromMetres(500.0);
    const safety::SafetyReport report = test::checkedPlan(builder.plan(), test::TestTerrain().grid());
    QCOMPARE(report.findings.size(), std::size_t{21});
    QVERIFY(report.findings.back().text.find("10 more") != std::string::npos);
    QVERIFY(report.findings.front().where.has_value());
    QVERIFY(isNear(*report.findings.front().margin, -100.0, 1e-9));
  }

  void random_intervals_againstBruteForce_areJudgedAlike() { test::judgeRandomIntervals({20240603, 16000, 25.0, {}}); }

  void randomSpirals_againstBruteForce_haveTheSameMargin() {
    constexpr std::uint64_t kSeed = 20240605;
    constexpr int kCases = 2000;
    qInfo("seed %llu, %d cases", static_cast<unsigned long long>(kSeed), kCases);
    std::mt19937_64 random(kSeed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    test::PlanBuilder builder;
    mission::Plan plan = builder.plan();
    plan.mission.planner.lowTargets = mission::LowTargets::Descend;
    for (int number = 0; number < kCases; ++number) {
      std::vector<float> values(24 * 24);
      for (float& value : values) {
        value = static_cast<float>(200.0 * unit(random));
      }
      const terrain::ElevationGrid grid(-600.0, -600.0, 50.0, 24, 24, values);
      const geo::Pose pose{100.0 * unit(random), 100.0 * unit(random), 6.0 * unit(random)};
      const auto turn = unit(random) < 0.5 ? flight::Turn::Left : flight::Turn::Right;
      const double radius = 66.0 + 100.0 * unit(random);
      const int down = 1 + static_cast<int>(3.0 * unit(random));
      const int up = 1 + static_cast<int>(3.0 * unit(random));
      plan.tour[18].pose = pose;
      plan.spirals = {{1, 600.0, 300.0, turn, radius, down, up}};
      const double margin = test::marginOf(test::checkedPlan(plan, grid), "spiral.clearance");
      const double circle = 2.0 * Angle::kPi * radius;
      double worst = std::numeric_limits<double>::infinity();
      double bound = worst;
      for (const test::FlownPoint& point : test::fly(pose, {{turn, radius, circle}}, 1.0)) {
        const double lowest = 300.0 + std::min((circle - point.distance) * 300.0 / (circle * down), point.distance * 300.0 / (circle * up));
        worst = std::min(worst, lowest - test::groundNear(grid, point.x, point.y, 0.0) - 100.0);
        bound = std::min(bound, lowest - 300.0 / circle - test::groundNear(grid, point.x, point.y, 1.0) - 100.0);
      }
      const QByteArray label = QString("case %1: margin %2, brute force between %3 and %4").arg(number).arg(margin).arg(bound).arg(worst).toUtf8();
      QVERIFY2(margin <= worst + 1e-6 && margin >= bound - 1e-6, label);
    }
  }

  void absurdNumbers_neverCertifyCrashOrHang() {
    constexpr std::uint64_t kSeed = 20240604;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    std::mt19937_64 random(kSeed);
    const double inf = std::numeric_limits<double>::infinity();
    const std::vector<double> absurd{std::nan(""), inf, -inf, 1e300, -1e300, 1e-300, -1.0, 1e17, 5e-324};
    const terrain::ElevationGrid grid = test::TestTerrain().grid();
    int certified = 0;
    for (int number = 0; number < 4000; ++number) {
      test::PlanBuilder builder;
      mission::Plan& plan = builder.plan();
      mission::DecisionPoint& point = plan.tour[random() % plan.tour.size()];
      auto& pieces = point.witness.pieces;
      flight::Piece& piece = pieces[random() % pieces.size()];
      plan.spirals = {{1, 600.0, 300.0, flight::Turn::Left, 200.0, 2, 2}};
      plan.mission.planner.lowTargets = mission::LowTargets::Descend;
      const std::vector<double*> places{&point.pose.x,
                                        &point.pose.y,
                                        &point.pose.heading,
                                        &point.altitude,
                                        &point.safeAltitude,
                                        &point.onward.length,
                                        &piece.length,
                                        &plan.sites[0].pose.x,
                                        &plan.targets[0].point.y,
                                        &plan.targets[1].altitude,
                                        &plan.terrainCell,
                                        &plan.metrics.cost,
                                        &plan.metrics.lowerBound,
                                        &plan.spirals[0].radius,
                                        &plan.spirals[0].top,
                                        &plan.mission.aircraft.mass_kg,
                                        &plan.mission.aircraft.inducedDrag,
                                        &plan.frameOrigin.longitude_deg};
      const std::size_t chosen = random() % places.size();
      double* place = places[chosen];
      const double before = *place;
      *place = absurd[random() % absurd.size()];
      if (point.onward.turn != flight::Turn::Straight && random() % 4 == 0) {
        point.onward.radius = absurd[random() % absurd.size()];
      }
      const safety::SafetyReport report = test::checkedPlan(plan, grid);
      const bool harmless = isNear(*place, before, 1e-3);  // 1e-300 in place of 0, say
      const bool isBound = place == &plan.metrics.lowerBound && *place >= 0.0 && *place < 1.0;
      if (report.isSafe()) {
        ++certified;
        QVERIFY2(harmless || isBound,
                 QString("case %1: number %2 of the plan changed from %3 to %4").arg(number).arg(chosen).arg(before).arg(*place).toUtf8());
      } else {
        QVERIFY(!report.findings.empty());
      }
    }
    QVERIFY(certified < 800);
  }

  void uselessTerrain_isNeverSafe() {
    const test::PlanBuilder builder;
    QVERIFY(!test::checkedPlan(builder.plan(), terrain::ElevationGrid()).isSafe());
    QVERIFY(!test::checkedPlan(builder.plan(), terrain::ElevationGrid(0.0, 0.0, 1e-9, 2, 2, {0.0F, 0.0F, 0.0F, 0.0F})).isSafe());
    QVERIFY(!test::checkedPlan(builder.plan(), terrain::ElevationGrid(1e300, 0.0, 50.0, 1, 1, {0.0F})).isSafe());
    QVERIFY(!test::checkedPlan(builder.plan(), terrain::ElevationGrid(-6000.0, -6000.0, 50.0, 1, 1, {0.0F})).isSafe());
  }

  void stopBefore_isCancelled() {
    const test::PlanBuilder builder;
    std::stop_source stop;
    stop.request_stop();
    const terrain::ElevationGrid grid = test::TestTerrain().grid();
    const auto report = safety::check({builder.plan(), grid, builder.checksums()}, Job(stop.get_token()));
    QVERIFY(!report.has_value());
    QVERIFY(report.error().code == Errc::Cancelled);
  }

  /// Stops from inside the first progress report, so that what follows it must notice.
  void stopDuring_isCancelledSoon_data() {
    QTest::addColumn<double>("fraction");
    QTest::newRow("glides") << 0.0;
    QTest::newRow("tour") << 0.8;
  }

  void stopDuring_isCancelledSoon() {
    QFETCH(double, fraction);
    test::PlanBuilder builder;
    mission::Plan& plan = builder.plan();
    const std::vector<mission::DecisionPoint> lap = plan.tour;
    for (int i = 0; i < 100; ++i) {
      plan.tour.insert(plan.tour.end(), lap.begin(), lap.end());
    }
    std::stop_source stop;
    int reportsAfterStop = 0;
    const Job job(stop.get_token(), [&](double done, std::string_view) {
      reportsAfterStop += stop.stop_requested() ? 1 : 0;
      if (done >= fraction) {
        stop.request_stop();
      }
    });
    const terrain::ElevationGrid grid = test::TestTerrain().grid();
    const auto report = safety::check({plan, grid, builder.checksums()}, job);
    QVERIFY(!report.has_value());
    QVERIFY(report.error().code == Errc::Cancelled);
    QCOMPARE(reportsAfterStop, 0);
  }
};

QTEST_APPLESS_MAIN(TestChecker)
#include "tst_checker.moc"
