#include "core/aircraft/glide_model.h"
#include "core/safety/checker.h"
#include "core/safety/witness_check.h"
#include "tests/support/path_check.h"
#include "tests/support/plan_builder.h"

#include <QtTest>

#include <cmath>
#include <limits>
#include <random>
#include <thread>

using namespace vp;

namespace {

safety::SafetyReport checked(const mission::Plan& plan, const terrain::ElevationGrid& grid) {
  return safety::check({plan, grid, {std::string(64, 'a')}}, Job()).value();
}

double marginOf(const std::vector<mission::Margin>& margins, const std::string& kind) {
  for (const mission::Margin& margin : margins) {
    if (margin.kind == kind) {
      return margin.value;
    }
  }
  return std::nan("");
}

bool isNear(double a, double b, double tolerance) {
  return std::abs(a - b) <= tolerance;
}

/// Margin of the worst engine failure anywhere on an interval, by brute force: fail at each of `count` places, glide along the
/// tour to the next point watching the ground `near` metres around, and be there not below what its glide needs.
double worstFailure(const mission::Plan& plan, std::size_t index, const terrain::ElevationGrid& grid, double required, int count, double near) {
  const aircraft::GlideModel model(plan.mission.aircraft);
  const mission::DecisionPoint& from = plan.tour[index];
  const mission::DecisionPoint& to = plan.tour[(index + 1) % plan.tour.size()];
  const double length = from.onward.length;
  const double rate = model.lossAt(from.onward.radius);
  const auto points = test::fly(from.pose, {from.onward}, length / count);
  std::vector<double> ground;
  for (const test::FlownPoint& point : points) {
    ground.push_back(test::groundNear(grid, point.x, point.y, near) + plan.mission.safety.clearance.si());
  }
  double worst = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double altitude = from.altitude + (to.altitude - from.altitude) * points[i].distance / length;
    for (std::size_t k = i; k < points.size(); ++k) {
      const double height = altitude - rate * (points[k].distance - points[i].distance);
      worst = std::min(worst, height - ground[k]);
    }
    worst = std::min(worst, altitude - rate * (length - points[i].distance) - required);
  }
  return worst;
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
    const safety::SafetyReport report = checked(builder.plan(), test::TestTerrain().grid());
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
    QVERIFY(isNear(marginOf(certificate.margins, "tour.clearance"), 500.0, 1e-9));
    QVERIFY(isNear(marginOf(certificate.margins, "tour.ceiling"), 100.0, 1e-9));
    QVERIFY(isNear(marginOf(certificate.margins, "tour.climb"), 15.0, 1e-9));
    QVERIFY(isNear(marginOf(certificate.margins, "tour.descent"), 15.0, 1e-9));
    QVERIFY(isNear(marginOf(certificate.margins, "target.height"), 300.0, 1e-9));
    QVERIFY(isNear(marginOf(certificate.margins, "glide.clearance"), 600.0 - builder.highestSafeAltitude(), 1e-6));
    QVERIFY(isNear(marginOf(certificate.margins, "glide.arrival"), 650.0 - builder.highestSafeAltitude(), 1e-6));
    double between = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < builder.plan().tour.size(); ++i) {
      const mission::DecisionPoint& next = builder.plan().tour[(i + 1) % builder.plan().tour.size()];
      between = std::min(between, 600.0 - builder.lossOf({builder.plan().tour[i].onward}) - next.safeAltitude);
    }
    QVERIFY(isNear(marginOf(certificate.margins, "tour.glide"), between, 1e-6));
  }

  void spiral_isCertifiedWithItsException() {
    test::PlanBuilder builder;
    builder.plan().mission.planner.lowTargets = mission::LowTargets::Descend;
    builder.plan().spirals = {{1, 600.0, 300.0, flight::Turn::Left, 200.0, 2, 2}};
    builder.updateMetrics();
    const safety::SafetyReport report = checked(builder.plan(), test::TestTerrain().grid());
    QVERIFY(report.isSafe());
    QVERIFY(report.certificate->statement.find("Exception: between 300 and 600 m MSL at target bridge") != std::string::npos);
    QVERIFY(isNear(marginOf(report.certificate->margins, "spiral.clearance"), 200.0, 1e-6));
  }

  void certificateInThePlan_isIgnored() {
    test::PlanBuilder builder;
    builder.plan().certificate = mission::Certificate{"all is well", {}, {}, 30, 30};
    builder.plan().tour[4].witness.pieces.clear();
    QVERIFY(!checked(builder.plan(), test::TestTerrain().grid()).isSafe());
  }

  void manyFindings_areCountedNotListed() {
    test::PlanBuilder builder;
    builder.plan().mission.ceiling = geo::HeightMsl::fromMetres(500.0);
    const safety::SafetyReport report = checked(builder.plan(), test::TestTerrain().grid());
    QCOMPARE(report.findings.size(), std::size_t{21});
    QVERIFY(report.findings.back().text.find("10 more") != std::string::npos);
    QVERIFY(report.findings.front().where.has_value());
    QVERIFY(isNear(*report.findings.front().margin, -100.0, 1e-9));
  }

  void random_intervals_againstBruteForce_areJudgedAlike() {
    constexpr std::uint64_t kSeed = 20240603;
    constexpr int kCases = 16000;
    qInfo("seed %llu, %d cases", static_cast<unsigned long long>(kSeed), kCases);
    std::mt19937_64 random(kSeed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    test::PlanBuilder builder;
    mission::Plan plan = builder.plan();
    const aircraft::GlideModel model(plan.mission.aircraft);
    // One interval of a two-point tour; everything else about it is wrong, and only its own findings are read.
    const mission::DecisionPoint sample = plan.tour[0];
    int broken = 0;
    int kept = 0;
    for (int number = 0; number < kCases; ++number) {
      std::vector<float> values(24 * 24);
      for (float& value : values) {
        value = static_cast<float>(20.0 * unit(random));
      }
      const terrain::ElevationGrid grid(-600.0, -600.0, 50.0, 24, 24, values);
      const auto turn = static_cast<flight::Turn>(static_cast<int>(unit(random) * 3.0) - 1);
      mission::DecisionPoint from = sample;
      from.pose = {200.0 * unit(random) - 100.0, 200.0 * unit(random) - 100.0, 6.0 * unit(random)};
      from.onward = {turn, turn == flight::Turn::Straight ? 0.0 : 70.0 + 300.0 * unit(random), 20.0 + 150.0 * unit(random)};
      from.altitude = 120.0 + 25.0 * unit(random);
      mission::DecisionPoint to = sample;
      const test::FlownPoint end = test::fly(from.pose, {from.onward}, 5.0).back();
      to.pose = {end.x, end.y, wrapTwoPi(end.heading)};
      to.altitude = from.altitude + 30.0 * (unit(random) - 0.5);
      to.witness.pieces = {{flight::Turn::Straight, 0.0, 150.0 * unit(random)}};
      plan.tour = {from, to};
      plan.sites[0].site.elevation = geo::HeightMsl::fromMetres(-1000.0);
      const double required = safety::requiredStartHeight(to.pose, to.witness.pieces, -950.0, grid, 100.0, model);
      if (!(to.altitude >= required + 0.01)) {
        continue;  // the glide of the next point has rules of its own, which stand in for the interval's
      }
      bool found = false;
      for (const safety::Finding& finding : checked(plan, grid).findings) {
        found = found || (finding.tourPoint == 0 && (finding.rule.starts_with("between.") || finding.rule == "tour.clearance"));
      }
      // Samples are less than 3 m apart, so the truth lies between the two.
      const double worst = worstFailure(plan, 0, grid, required, 60, 0.0);
      const double bound = worstFailure(plan, 0, grid, required, 60, 3.0) - 1.0;
      const QByteArray label = QString("case %1: worst margin between %2 and %3, %4").arg(number).arg(bound).arg(worst).arg(found).toUtf8();
      if (worst < -0.0011) {
        ++broken;
        QVERIFY2(found, label);
      } else if (bound > 0.0) {
        ++kept;
        QVERIFY2(!found, label);
      }
    }
    qInfo("%d broken, %d kept", broken, kept);
    QVERIFY(broken > 1000);
    QVERIFY(kept > 500);
  }

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
      const double margin = marginOf(checked(plan, grid).margins, "spiral.clearance");
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
      const safety::SafetyReport report = checked(plan, grid);
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
    QVERIFY(!checked(builder.plan(), terrain::ElevationGrid()).isSafe());
    QVERIFY(!checked(builder.plan(), terrain::ElevationGrid(0.0, 0.0, 1e-9, 2, 2, {0.0F, 0.0F, 0.0F, 0.0F})).isSafe());
    QVERIFY(!checked(builder.plan(), terrain::ElevationGrid(1e300, 0.0, 50.0, 1, 1, {0.0F})).isSafe());
    QVERIFY(!checked(builder.plan(), terrain::ElevationGrid(-6000.0, -6000.0, 50.0, 1, 1, {0.0F})).isSafe());
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
