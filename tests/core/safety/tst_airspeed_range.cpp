// Airspeeds that range with mass and density, drag and the propeller: bounds against the equations of motion, and plans that break a rule by them.

#include "core/safety/checker.h"
#include "core/safety/glide_rates.h"
#include "core/safety/standard_air.h"
#include "tests/core/safety/motion_flight.h"
#include "tests/core/safety/wind_cases.h"

#include <QTest>

#include <functional>

using namespace vp;

namespace {

constexpr double kReferenceMass = 1111.0;

/// A mission's plan with nothing but what conditions depend on.
mission::Plan planIn(const air::Atmosphere& air, double lowest, double highest) {
  mission::Plan plan;
  plan.mission.aircraft = test::cessna();
  plan.mission.aircraft.leastMass_kg = 850.0;
  plan.mission.aircraft.mostMass_kg = 1157.0;
  plan.mission.atmosphere = air;
  plan.sites.emplace_back().site.elevation = geo::HeightMsl::fromMetres(lowest);
  plan.tour.emplace_back().altitude = highest;
  return plan;
}

/// The same aircraft on a day: its mass, its air, and the airspeed that keeps the angle of attack there.
aircraft::AircraftProfile onTheDay(const mission::Plan& plan, double mass_kg, double altitude) {
  aircraft::AircraftProfile profile = plan.mission.aircraft;
  const double temperature = 288.15 - 0.0065 * altitude;
  const double pressure = 100.0 * plan.mission.atmosphere->qnh_hPa * std::pow(temperature / 288.15, 5.25588);
  const double density = pressure / (287.05287 * (temperature + plan.mission.atmosphere->temperatureOffset_K));
  profile.bestGlideSpeed = profile.bestGlideSpeed * std::sqrt(mass_kg / kReferenceMass * 1.225 / density);
  profile.mass_kg = mass_kg;
  profile.airDensity_kgm3 = density;
  profile.zeroLiftDrag *= plan.mission.safety.dragFactor;
  profile.inducedDrag *= plan.mission.safety.dragFactor;
  return profile;
}

/// Often at an end.
double between(test::WindCases& cases, double low, double high) {
  const int kind = cases.below(4);
  return kind == 0 ? low : kind == 1 ? high : low + (high - low) * cases.unit();
}

}  // namespace

class TestAirspeedRange : public QObject {
  Q_OBJECT

private slots:
  /// Doc 7488/3, tables by geopotential altitude: pressure and temperature give the density.
  void density_isTheStandardAtmospheres_data() {
    QTest::addColumn<double>("altitude");
    QTest::addColumn<double>("density");
    QTest::newRow("sea level") << 0.0 << 1.2250;
    QTest::newRow("1000 m") << 1000.0 << 1.11164;
    QTest::newRow("3000 m") << 3000.0 << 0.909122;
    QTest::newRow("5000 m") << 5000.0 << 0.736116;
    QTest::newRow("11000 m") << 11000.0 << 0.363918;
    QTest::newRow("20000 m") << 20000.0 << 0.0880349;
  }

  void density_isTheStandardAtmospheres() {
    QFETCH(double, altitude);
    QFETCH(double, density);
    QVERIFY(std::abs(safety::densityAt({}, altitude) / density - 1.0) < 2e-5);
    const double warm = safety::densityAt({20.0, 1013.25}, altitude);
    const double temperature = std::max(216.65, 288.15 - 0.0065 * altitude);
    QVERIFY(std::abs(warm * (temperature + 20.0) / temperature / density - 1.0) < 2e-5);
    QVERIFY(std::abs(safety::densityAt({0.0, 980.0}, altitude) / 980.0 * 1013.25 / density - 1.0) < 2e-5);
  }

  void density_fallsWithAltitude_onEveryDay() {
    for (const double off : {-60.0, 0.0, 50.0}) {
      for (double altitude = -1000.0; altitude < 20000.0; altitude += 50.0) {
        QVERIFY(safety::densityAt({off, 1000.0}, altitude + 50.0) < safety::densityAt({off, 1000.0}, altitude));
      }
    }
  }

  /// Doc 8168 volume I, table III-1-4-1 b: aerodrome at -20 C and sea level, 300 m above it 40 m, 1500 m above it 210 m (rounded up).
  void coldAir_makesTheAltimeterShowTooMuch() {
    QVERIFY(std::abs(safety::altimeterShowsTooMuch({-35.0, 1013.25}, 300.0, 0.0) - 42.0) < 2.0);
    QVERIFY(std::abs(safety::altimeterShowsTooMuch({-35.0, 1013.25}, 1500.0, 0.0) - 211.0) < 5.0);
    QVERIFY(safety::altimeterShowsTooMuch({0.0, 990.0}, 3000.0, 200.0) == 0.0);
    QVERIFY(safety::altimeterShowsTooMuch({15.0, 1013.25}, 3000.0, 0.0) < 0.0);
  }

  void range_goesFromTheLightestAtTheLowestSite_toTheHeaviestAtTheHighestPoint() {
    mission::Plan plan = planIn({}, 1000.0, 3000.0);
    plan.sites.emplace_back().site.elevation = geo::HeightMsl::fromMetres(1500.0);
    plan.spirals.push_back({0, 3000.0, 500.0, flight::Turn::Left, 300.0, 2, 2});
    const safety::PlanConditions conditions = safety::conditionsOf(plan);
    QVERIFY(std::abs(conditions.glide.least - 33.4 * std::sqrt(850.0 / 1111.0 * 1.225 / 1.11164)) < 1e-3);
    QVERIFY(std::abs(conditions.glide.most - 33.4 * std::sqrt(1157.0 / 1111.0 * 1.225 / 0.909122)) < 1e-3);
    QVERIFY(conditions.tour.least < conditions.glide.least && conditions.tour.most == conditions.glide.most);
    plan.mission.aircraft.powerSettings = {{"65 %", Speed::fromSi(55.0), 30.0, aircraft::PowerSetting::Unit::Litres}};
    plan.mission.powerSetting = "65 %";
    QVERIFY(safety::conditionsOf(plan).tour.least == 55.0 && safety::conditionsOf(plan).tour.most == 55.0);
    plan.mission.atmosphere.reset();
    QVERIFY(safety::conditionsOf(plan).glide.most == 33.4 * std::sqrt(1157.0 / 1111.0));
  }

  void oneAirspeed_isTheProfileToTheLastBit() {
    mission::Plan plan = planIn({}, 0.0, 3000.0);
    plan.mission.atmosphere.reset();
    plan.mission.aircraft = test::cessna();
    plan.mission.wind = {test::layerOf(0.0, 250.0, 20.0, 3.0, 9.0)};
    safety::GlideRates ranging(safety::conditionsOf(plan), plan.mission.aircraft);
    safety::GlideRates one(plan.mission.aircraft, plan.mission.wind);
    const double radius = one.leastGlideRadius();
    QVERIFY(ranging.leastGlideRadius() == radius && ranging.leastTourRadius() == one.leastTourRadius());
    for (const flight::Piece& piece : {flight::Piece{flight::Turn::Left, radius, 500.0}, flight::Piece{flight::Turn::Straight, 0.0, 500.0}}) {
      QVERIFY(ranging.along(1.0, piece).upTo(500.0) == one.along(1.0, piece).upTo(500.0));
      QVERIFY(ranging.slopeShare(1.0, piece) == one.slopeShare(1.0, piece) && ranging.leastAlong(1.0, piece) == one.leastAlong(1.0, piece));
    }
  }

  void equationsOfMotion_atRandomMassesAndAltitudes_loseNoMoreThanTheBound() {
    constexpr std::uint64_t kSeed = 20261130;
    constexpr int kSets = 50;
    constexpr int kFlights = 200;
    qInfo("seed %llu, %d flights", static_cast<unsigned long long>(kSeed), kSets * kFlights);
    test::WindCases cases(kSeed);
    double tightest = 1.0;
    double off = 0.0;
    for (int number = 0; number < kSets; ++number) {
      const double lowest = 1500.0 * cases.unit();
      const double highest = lowest + 3500.0 * cases.unit();
      mission::Plan plan = planIn({-30.0 + 50.0 * cases.unit(), 980.0 + 60.0 * cases.unit()}, lowest, highest);
      plan.mission.wind = cases.layers(number % 4);
      plan.mission.safety.dragFactor = 1.0 + 0.5 * cases.unit() * cases.below(2);
      safety::GlideRates rates(safety::conditionsOf(plan), plan.mission.aircraft);
      const std::array<double, 2> radii{rates.leastGlideRadius(), rates.leastGlideRadius() * (1.0 + 3.0 * cases.unit())};
      for (int i = 0; i < kFlights; ++i) {
        const double side = cases.below(3) - 1.0;
        const double radius = side == 0.0 ? 0.0 : radii[static_cast<std::size_t>(cases.below(2))];
        const double course = 6.0 * cases.unit() - 3.0;
        const double length = 50.0 + 900.0 * cases.unit();
        const aircraft::AircraftProfile flown = onTheDay(plan, between(cases, 850.0, 1157.0), between(cases, lowest, highest));
        const double bound = rates.along(course, {static_cast<flight::Turn>(side), radius, length}).upTo(length);
        const air::Wind wind = plan.mission.wind.empty() ? air::Wind() : cases.wind(plan.mission.wind);
        test::MotionFlight flight(flown, wind, course, side, radius);
        const double lost = flight.fly(length);
        off = std::max(off, flight.furthestOff());
        tightest = std::min(tightest, 1.0 - lost / bound);
        QVERIFY2(lost <= bound * (1.0 + 1e-6), QString("set %1, flight %2: lost %3, bound %4, side %5, radius %6")
                                                   .arg(number)
                                                   .arg(i)
                                                   .arg(lost)
                                                   .arg(bound)
                                                   .arg(side)
                                                   .arg(radius)
                                                   .toUtf8());
      }
    }
    qInfo("at most %.3f m off the track, losses up to %.2g below the bound", off, tightest);
    QVERIFY(off < 2.0 && tightest < 0.01);
  }

  /// The bound is the worst of the range, not more: of all airspeeds between the ends none loses more on a circle in a wind, one of the ends as much.
  void mostLoss_overTheRange_isAtAnEndOfIt() {
    constexpr std::uint64_t kSeed = 20261131;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::WindCases cases(kSeed);
    int inner = 0;
    for (int number = 0; number < 10000; ++number) {
      mission::Plan plan = planIn({}, 1000.0 * cases.unit(), 1000.0 + 6000.0 * cases.unit());
      plan.mission.aircraft.zeroLiftDrag *= 0.3 + cases.unit();
      plan.mission.safety.dragFactor = 1.0 + cases.unit();
      const safety::PlanConditions conditions = safety::conditionsOf(plan);
      const double off = 2.0 * Angle::kPi * cases.unit();
      const double speed = 0.98 * conditions.glide.least * cases.unit();
      const double along = speed * std::cos(off);
      const double across = speed * std::sin(off);
      const double fastest = conditions.glide.most + speed;
      const double radius = fastest * fastest / (9.80665 * std::tan(Angle::degrees(1.0 + 44.0 * cases.unit()).radians()));
      const auto lossAt = [&](double airspeed) {
        return safety::WindGlide(plan.mission.aircraft, conditions, airspeed).lossInTurn(along, across, radius);
      };
      const double ends = std::max(lossAt(conditions.glide.least), lossAt(conditions.glide.most));
      for (int i = 1; i < 20; ++i) {
        const double found = lossAt(conditions.glide.least + (conditions.glide.most - conditions.glide.least) * i / 20.0);
        QVERIFY2(found <= ends * (1.0 + 1e-12), QString("case %1: %2 within, %3 at the ends").arg(number).arg(found).arg(ends).toUtf8());
        inner += found > 0.999 * ends ? 1 : 0;
      }
    }
    QVERIFY(inner > 0);
  }

  void radii_areThoseOfTheFastest() {
    mission::Plan plan = planIn({}, 0.0, 3000.0);
    plan.mission.wind = {test::layerOf(0.0, 250.0, 20.0, 3.0, 9.0)};
    plan.mission.aircraft.powerSettings = {{"65 %", Speed::fromSi(55.0), 30.0, aircraft::PowerSetting::Unit::Litres}};
    const safety::PlanConditions conditions = safety::conditionsOf(plan);
    const safety::GlideRates rates(conditions, plan.mission.aircraft);
    const double fastest = conditions.glide.most + 9.0;
    QVERIFY(std::abs(rates.leastGlideRadius() - fastest * fastest / (9.80665 * std::sqrt(3.0))) < 1e-9);
    QVERIFY(std::abs(rates.slopeShare(0.0, {flight::Turn::Left, 300.0, 5000.0}) - conditions.tour.least / (conditions.tour.least + 9.0)) < 1e-9);
    plan.mission.powerSetting = "65 %";
    const safety::GlideRates powered(safety::conditionsOf(plan), plan.mission.aircraft);
    QVERIFY(powered.leastGlideRadius() == rates.leastGlideRadius());
    QVERIFY(std::abs(powered.leastTourRadius() - 64.0 * 64.0 / (9.80665 * std::sqrt(3.0))) < 1e-9);
    QVERIFY(std::abs(powered.slopeShare(0.0, {flight::Turn::Left, 300.0, 5000.0}) - 55.0 / 64.0) < 1e-9);
    QVERIFY(powered.glideSlopeShare(0.0, {flight::Turn::Left, 300.0, 5000.0}) == rates.slopeShare(0.0, {flight::Turn::Left, 300.0, 5000.0}));
  }
};

QTEST_APPLESS_MAIN(TestAirspeedRange)
#include "tst_airspeed_range.moc"
