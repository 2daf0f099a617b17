// What is left of the climb with altitude, by hand and in plans that break a rule by it.

#include "core/safety/climb_left.h"
#include "core/safety/standard_air.h"
#include "tests/core/safety/plan_fixture.h"

#include <QTest>

using namespace vp;

namespace {

using Fixture = test::PlanFixture;
using Change = test::PlanChange;

/// A rate of climb [m/s] at sea level, and a service ceiling [m].
void setClimb(aircraft::AircraftProfile& profile, double rate, double ceiling) {
  profile.climbRate = Speed::fromSi(rate);
  profile.serviceCeiling = geo::HeightMsl::fromMetres(ceiling);
}

void descendAt(Fixture& f, double radius, int down, int up) {
  f.mission().planner.lowTargets = mission::LowTargets::Descend;
  f.plan().spirals = {{1, 600.0, 300.0, flight::Turn::Left, radius, down, up}};
  f.builder.updateMetrics();
}

double slopeAt(const mission::Mission& mission, double altitude) {
  return tan(safety::steepestClimb(mission, altitude));
}

}  // namespace

Q_DECLARE_METATYPE(Change)

class TestClimbLeft : public QObject {
  Q_OBJECT

  static void row(const char* name, const char* rule, Change change) { QTest::newRow(name) << QString(rule) << change; }

private slots:
  void densityAltitude_isWhereTheStandardAtmosphereIsAsDense() {
    for (const air::Atmosphere& air : {air::Atmosphere{}, air::Atmosphere{30.0, 990.0}, air::Atmosphere{-40.0, 1040.0}}) {
      for (double altitude = 0.0; altitude <= 15000.0; altitude += 250.0) {
        const double felt = safety::densityAltitudeOf(air, altitude);
        QVERIFY(std::abs(safety::densityAt({}, felt) / safety::densityAt(air, altitude) - 1.0) < 1e-9);
        QVERIFY(felt < safety::densityAltitudeOf(air, altitude + 1.0));
      }
    }
    QVERIFY(std::abs(safety::densityAltitudeOf({}, 3000.0) - 3000.0) < 1e-6);
    // The rule of thumb: 120 ft for each degree. Density falls by 0.96 % in the first 100 m.
    QVERIFY(std::abs(safety::densityAltitudeOf({20.0, 1013.25}, 0.0) - 20.0 * 120.0 * 0.3048) < 50.0);
    QVERIFY(std::abs(safety::densityAltitudeOf({0.0, 993.25}, 0.0) - 20.0 / 1013.25 / 0.96e-4) < 3.0);
  }

  void slope_isTheRateOfClimbAtTheAirspeedOfTheTour() {
    mission::Mission mission;
    mission.aircraft = test::cessna();
    QCOMPARE(safety::steepestClimb(mission, 3000.0), mission.aircraft.maxClimb);
    setClimb(mission.aircraft, 3.5, 4000.0);
    const double ofSpeed = 1.0 / 33.4;
    QVERIFY(std::abs(slopeAt(mission, 0.0) - std::tan(std::asin(3.5 * ofSpeed))) < 1e-12);
    QVERIFY(std::abs(slopeAt(mission, 4000.0) - std::tan(std::asin(0.508 * ofSpeed))) < 1e-12);
    QVERIFY(std::abs(slopeAt(mission, 2000.0) - std::tan(std::asin(2.004 * ofSpeed))) < 1e-12);
    QVERIFY(slopeAt(mission, 5000.0) < 0.0);  // it cannot keep its height up there
    mission.aircraft.maxClimb = Angle::degrees(4.0);
    QCOMPARE(safety::steepestClimb(mission, 1000.0), mission.aircraft.maxClimb);
    mission.aircraft.powerSettings = {{"65 %", Speed::fromSi(55.0), 30.0, aircraft::PowerSetting::Unit::Litres}};
    mission.powerSetting = "65 %";
    QVERIFY(std::abs(slopeAt(mission, 2000.0) - std::tan(std::asin(2.004 / 55.0))) < 1e-12);
  }

  /// 2000 m in the standard atmosphere: density 1.00649 kg/m^3.
  void slope_inAnAtmosphere_isOfTheDensityAltitudeAndTheAirspeedThere() {
    mission::Mission mission;
    mission.aircraft = test::cessna();
    setClimb(mission.aircraft, 3.5, 4000.0);
    mission.atmosphere = air::Atmosphere{};
    QVERIFY(std::abs(slopeAt(mission, 2000.0) - std::tan(std::asin(2.004 / (33.4 * std::sqrt(1.225 / 1.00649))))) < 1e-6);
    const double standard = slopeAt(mission, 2000.0);
    mission.atmosphere->temperatureOffset_K = 20.0;
    QVERIFY(slopeAt(mission, 2000.0) < 0.85 * standard);  // some 700 m higher by density
    for (double altitude = 0.0; altitude < 6000.0; altitude += 100.0) {
      QVERIFY(slopeAt(mission, altitude + 100.0) <= slopeAt(mission, altitude));
    }
  }

  /// The tour rises behind point 4 and falls behind point 5, 200 m each. 3.4 m/s at sea level and 0.508 at 1000 m leave 9.98 m at 600 m, and 9.81
  /// at 610 m.
  void plan_breaksExactlyItsRule_data() {
    QTest::addColumn<QString>("rule");
    QTest::addColumn<Change>("change");
    row("more than the rate of climb leaves at the upper end", "tour.climb", [](Fixture& f) {
      setClimb(f.mission().aircraft, 3.4, 1000.0);
      f.raise(5, 9.9);
    });
    row("level where the aircraft cannot keep its height", "tour.climb", [](Fixture& f) { setClimb(f.mission().aircraft, 3.4, 450.0); });
    row("climb on a hot day", "tour.climb", [](Fixture& f) {
      setClimb(f.mission().aircraft, 3.4, 1500.0);
      f.mission().atmosphere = air::Atmosphere{20.0, 1013.25};
      f.raise(5, 9.9);
      f.refit();
    });
    row("climb with the wind from behind", "tour.climb", [](Fixture& f) {
      setClimb(f.mission().aircraft, 3.4, 1000.0);
      f.mission().wind = {test::layerOf(0.0, 270.0, 0.0, 4.0, 4.0)};
      f.refit();
      f.raise(5, 9.0);
    });
    row("climb at a faster power setting", "tour.climb", [](Fixture& f) {
      setClimb(f.mission().aircraft, 3.4, 1000.0);
      f.mission().aircraft.powerSettings = {{"65 %", Speed::fromSi(40.0), 30.0, aircraft::PowerSetting::Unit::Litres}};
      f.mission().powerSetting = "65 %";
      f.raise(5, 9.0);
    });
    // 300 m up in circles of 1257 m: 6 need 2.28 degrees; what is left at 600 m is 2.86 degrees, with 5 circles 2.73, with 4 3.41.
    row("spiral that the rate of climb does not get out of", "spiral.pitch", [](Fixture& f) {
      setClimb(f.mission().aircraft, 3.4, 1000.0);
      descendAt(f, 200.0, 2, 4);
    });
    row("climb that grows with altitude", "aircraft.profile", [](Fixture& f) { setClimb(f.mission().aircraft, 0.5, 4000.0); });
    row("service ceiling under the sea", "aircraft.profile", [](Fixture& f) { setClimb(f.mission().aircraft, 3.4, -10.0); });
    row("rate of climb that is no number", "aircraft.profile", [](Fixture& f) { setClimb(f.mission().aircraft, std::nan(""), 4000.0); });
  }

  void plan_breaksExactlyItsRule() {
    QFETCH(QString, rule);
    QFETCH(Change, change);
    Fixture fixture;
    change(fixture);
    test::verifyBreaksExactly(fixture, rule);
    if (QTest::currentTestFailed()) {
      return;
    }
    fixture.mission().aircraft.climbRate.reset();
    QVERIFY2(test::checkedPlan(fixture).isSafe(), test::textsOfFindings(test::checkedPlan(fixture)));
  }

  void plan_isCertified_data() {
    QTest::addColumn<Change>("change");
    QTest::newRow("as the rate of climb leaves at the upper end") << Change([](Fixture& f) {
      setClimb(f.mission().aircraft, 3.4, 1000.0);
      f.raise(5, 9.7);
    });
    QTest::newRow("out of a spiral") << Change([](Fixture& f) {
      setClimb(f.mission().aircraft, 3.4, 1000.0);
      descendAt(f, 200.0, 2, 5);
    });
    QTest::newRow("climb in standard air") << Change([](Fixture& f) {
      setClimb(f.mission().aircraft, 3.4, 1500.0);
      f.mission().atmosphere = air::Atmosphere{};
      f.raise(5, 9.9);
      f.refit();
    });
  }

  void plan_isCertified() {
    QFETCH(Change, change);
    Fixture fixture;
    change(fixture);
    const safety::SafetyReport report = test::checkedPlan(fixture);
    QVERIFY2(report.isSafe(), test::textsOfFindings(report));
    const std::string said = "Under power it climbs nowhere steeper than an aircraft can whose rate of climb falls from 3.4 m/s at sea level";
    QVERIFY2(report.certificate->statement.find(said) != std::string::npos, report.certificate->statement.c_str());
  }
};

QTEST_APPLESS_MAIN(TestClimbLeft)
#include "tst_climb_left.moc"
