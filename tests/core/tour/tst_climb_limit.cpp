// No step of a plan is steeper than what the aircraft has left at its altitude; planning again keeps what a plan must keep.
#include "core/aircraft/climb.h"
#include "core/mission/glide_conditions.h"
#include "core/safety/checker.h"
#include "core/tour/planner.h"
#include "tests/support/band_flight.h"
#include "tests/support/ring_mission.h"

#include <QTest>

#include <cmath>

using namespace vp;

namespace {

/// Four targets around the mountain, one of them high on it.
tour::PlanInput ringMission() {
  tour::PlanInput input = test::mountainInput();
  test::addTarget(input, "north", {200.0, 1500.0});
  test::addTarget(input, "east", {1700.0, -100.0});
  test::addTarget(input, "south", {0.0, -1800.0});
  test::addTarget(input, "high", {-300.0, 100.0});
  return input;
}

tour::PlanInput climbing(double rate, double serviceCeiling) {
  tour::PlanInput input = ringMission();
  input.mission.aircraft.climbRate = Speed::fromSi(rate);
  input.mission.aircraft.serviceCeiling = geo::HeightMsl::fromMetres(serviceCeiling);
  return input;
}

/// Greatest share of the climb that is left at the upper end of a step which a step needs, over the whole tour.
double mostUsed(const mission::Plan& plan) {
  const aircraft::GlideConditions conditions = mission::glideConditionsOf(plan.mission, plan.sites);
  const aircraft::GlideModel glide(plan.mission.aircraft, conditions);
  double most = 0.0;
  for (std::size_t i = 0; i < plan.tour.size(); ++i) {
    const mission::DecisionPoint& from = plan.tour[i];
    const mission::DecisionPoint& to = plan.tour[(i + 1) % plan.tour.size()];
    const double left =
        aircraft::climbSlopeOverGround(plan.mission.aircraft, conditions, glide, geo::HeightMsl::fromMetres(std::max(from.altitude, to.altitude)));
    most = std::max(most, (to.altitude - from.altitude) / from.onward.length / left);
  }
  return most;
}

}  // namespace

class TestClimbLimit : public QObject {
  Q_OBJECT

private slots:
  void plan_climbsNoSteeperThanTheAircraftCan_data() {
    QTest::addColumn<double>("rate");
    QTest::addColumn<double>("serviceCeiling");
    QTest::addColumn<bool>("isWindy");
    QTest::newRow("plenty") << 30.0 << 8000.0 << false;
    QTest::newRow("a trainer") << 3.9 << 4300.0 << false;
    QTest::newRow("a trainer in wind") << 3.9 << 4300.0 << true;
    QTest::newRow("a weak one") << 1.5 << 2600.0 << false;
  }

  void plan_climbsNoSteeperThanTheAircraftCan() {
    QFETCH(double, rate);
    QFETCH(double, serviceCeiling);
    QFETCH(bool, isWindy);
    tour::PlanInput input = climbing(rate, serviceCeiling);
    input.mission.atmosphere = air::Atmosphere{10.0, 1005.0};
    if (isWindy) {
      input.mission.wind = {{geo::HeightMsl(), {250.0, 20.0, 3.0, 6.0}}};
    }
    const auto plan = tour::planTour(input, Job{});
    QVERIFY2(plan.has_value(), plan ? "" : plan.error().message().c_str());
    QVERIFY2(mostUsed(*plan) <= 1.0 + 1e-9, qPrintable(QString::number(mostUsed(*plan))));
    const auto report = safety::check({*plan, *input.terrain, {input.terrainFiles.front().sha256}}, Job{});
    QVERIFY(report.has_value());
    QVERIFY2(report->certificate.has_value() || !test::kCheckerKnowsBands, report->findings.empty() ? "" : report->findings.front().text.c_str());
  }

  void limit_binds_whereTheAircraftIsWeak() {
    const auto strong = tour::planTour(climbing(30.0, 8000.0), Job{});
    const auto weak = tour::planTour(climbing(1.5, 2600.0), Job{});
    QVERIFY(strong && weak);
    QVERIFY(weak->metrics.cost > strong->metrics.cost);
    tour::PlanInput without = ringMission();
    const auto unlimited = tour::planTour(without, Job{});
    QVERIFY(unlimited);
    QCOMPARE(strong->metrics.cost, unlimited->metrics.cost);  // a limit that does not bind changes nothing
    QCOMPARE(strong->tour, unlimited->tour);
  }

  void tooHighForTheAircraft_isSaid() {
    const auto plan = tour::planTour(climbing(0.9, 500.0), Job{});
    QVERIFY(!plan);
    QCOMPARE(plan.error().code, Errc::NoSolution);
    QVERIFY2(plan.error().message().find("hardly climbs") != std::string::npos, plan.error().message().c_str());
  }
};

QTEST_APPLESS_MAIN(TestClimbLimit)
#include "tst_climb_limit.moc"
