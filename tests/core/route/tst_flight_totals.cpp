// Length, time and fuel of a flight against closed forms: a racetrack of known size in calm air, wind and at height.
#include "core/aircraft/energy.h"
#include "core/mission/glide_conditions.h"
#include "core/route/flight_totals.h"
#include "tests/support/plan_builder.h"

#include <QTest>

#include <cmath>

using namespace vp;

namespace {

constexpr double kStraights = 2.0 * 2000.0;
constexpr double kTurns = 2.0 * Angle::kPi * 300.0;

mission::Plan racetrack() {
  return test::PlanBuilder(600.0).plan();
}

mission::Plan withPower(mission::Plan plan, aircraft::PowerSetting::Unit unit) {
  plan.mission.aircraft.powerSettings = {{"65 %", Speed::fromSi(50.0), 30.0, unit}};
  plan.mission.powerSetting = "65 %";
  return plan;
}

bool isNear(double a, double b, double relative = 1e-6) {
  return std::abs(a - b) <= relative * std::abs(b);
}

}  // namespace

class TestFlightTotals : public QObject {
  Q_OBJECT

private slots:
  void calm_isLengthByAirspeed() {
    const mission::Plan plan = racetrack();
    const route::FlightTotals totals = route::tourTotals(plan);
    QVERIFY(isNear(totals.length, kStraights + kTurns, 1e-9));
    QVERIFY(isNear(totals.seconds, totals.length / plan.mission.aircraft.bestGlideSpeed.si()));
    QCOMPARE(totals.climbed, 0.0);
    QVERIFY(!totals.energy);
    QCOMPARE(route::flightTotals(plan).seconds, totals.seconds);
  }

  void powerSetting_givesSpeedAndFuel() {
    const mission::Plan plan = withPower(racetrack(), aircraft::PowerSetting::Unit::Litres);
    const route::FlightTotals totals = route::tourTotals(plan);
    QVERIFY(isNear(totals.seconds, totals.length / 50.0));
    QVERIFY(totals.energy && isNear(*totals.energy, 30.0 * totals.seconds / 3600.0));
  }

  void windAlongTheStraights_costsMoreThanItGives() {
    mission::Plan plan = withPower(racetrack(), aircraft::PowerSetting::Unit::Litres);
    const double still = route::tourTotals(plan).seconds;
    constexpr double kWind = 10.0;
    plan.mission.wind = {{geo::HeightMsl::fromMetres(0.0), {270.0, 0.0, kWind, kWind}}};
    const double straights = 2000.0 / (50.0 + kWind) + 2000.0 / (50.0 - kWind);
    const double windy = route::tourTotals(plan).seconds;
    QVERIFY(windy > still);
    // the two half circles together are flown through all courses once: the mean of 1 / ground speed, summed here finely
    double mean = 0.0;
    constexpr int kParts = 100000;
    for (int i = 0; i < kParts; ++i) {
      const double course = 2.0 * Angle::kPi * (i + 0.5) / kParts;
      const double along = kWind * std::cos(course);
      const double across = kWind * std::sin(course);
      mean += 1.0 / (std::sqrt(50.0 * 50.0 - across * across) + along) / kParts;
    }
    QVERIFY(isNear(windy, straights + kTurns * mean, 1e-5));
  }

  void heightInAnAtmosphere_isFlownFaster() {
    mission::Plan plan = racetrack();
    plan.mission.aircraft.ceiling = geo::HeightMsl::fromMetres(4000.0);
    const double low = route::tourTotals(plan).seconds;
    plan.mission.atmosphere = air::Atmosphere();
    const double ratio = std::sqrt(plan.mission.aircraft.airDensity_kgm3 / air::density({}, geo::HeightMsl::fromMetres(600.0)));
    QVERIFY(isNear(low / route::tourTotals(plan).seconds, ratio));
  }

  void climbs_costWhatTheyLift() {
    mission::Plan plan = withPower(racetrack(), aircraft::PowerSetting::Unit::Litres);
    plan.tour[3].altitude += 100.0;
    plan.tour[4].altitude += 100.0;
    const route::FlightTotals totals = route::tourTotals(plan);
    QVERIFY(isNear(totals.climbed, 100.0, 1e-12));
    const double level = 30.0 * totals.seconds / 3600.0;
    const double perMetre = plan.mission.aircraft.mass_kg * kGravity.si() / (0.25 * 43.5e6 * 0.72);
    QVERIFY(isNear(*totals.energy - level, 100.0 * perMetre));
  }

  void climbOfTheHandbook_isNotCheaperThanSaid() {
    // 172N handbook, section 5: 1.3 gal from sea level to 4,000 ft at 2,300 lb, at a power that takes some 8.5 gal/h for the 6 minutes
    // of it. What lifting alone takes must be less than all of it, and not a small part of it.
    const aircraft::PowerSetting climb{"climb", Speed::fromSi(37.0), 0.0, aircraft::PowerSetting::Unit::Litres};
    const double lifting = aircraft::energyUsed(climb, 1043.0, 0.0, 4000.0 * 0.3048);
    const double handbook = 1.3 * 3.785;
    QVERIFY(lifting > 0.2 * handbook && lifting < handbook);
  }

  void battery_isCountedInWattHours() {
    const aircraft::PowerSetting cruise{"cruise", Speed::fromSi(20.0), 200.0, aircraft::PowerSetting::Unit::WattHours};
    QVERIFY(isNear(aircraft::energyUsed(cruise, 13.5, 1800.0, 0.0), 100.0));
    QVERIFY(isNear(aircraft::energyUsed(cruise, 13.5, 0.0, 100.0), 13.5 * kGravity.si() * 100.0 / (0.6 * 3600.0)));
    QCOMPARE(QString::fromLatin1(aircraft::unitText(cruise.unit)), QStringLiteral("Wh"));
  }
};

QTEST_APPLESS_MAIN(TestFlightTotals)
#include "tst_flight_totals.moc"
