// Wind on a runway: the worst of a set against winds of the set one by one, and the sentence for the pilot.
#include "core/aircraft/runway_wind.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace vp;

namespace {

constexpr double kKnot = 1852.0 / 3600.0;

std::vector<air::WindLayer> from(double degrees, double knots, double spread_deg = 0.0, double spreadKnots = 0.0) {
  return {{geo::HeightMsl(), {degrees, spread_deg, (knots - spreadKnots) * kKnot, (knots + spreadKnots) * kKnot}}};
}

aircraft::RunwayWind on(const std::vector<air::WindLayer>& winds, double course) {
  return aircraft::runwayWind(winds, geo::HeightMsl::fromMetres(300.0), Angle::degrees(course));
}

}  // namespace

class TestRunwayWind : public QObject {
  Q_OBJECT

private slots:
  void oneWind_isWhatAPilotExpects() {
    const auto ahead = on(from(270.0, 10.0), 270.0);
    QVERIFY(std::abs(ahead.tailwind + 10.0 * kKnot) < 1e-9 && ahead.crosswind < 1e-9);
    const auto behind = on(from(90.0, 10.0), 270.0);
    QVERIFY(std::abs(behind.tailwind - 10.0 * kKnot) < 1e-9 && behind.crosswind < 1e-9);
    const auto beside = on(from(30.0, 10.0), 60.0);
    QVERIFY(std::abs(beside.tailwind + 10.0 * kKnot * std::cos(Angle::kPi / 6.0)) < 1e-9);
    QVERIFY(std::abs(beside.crosswind - 5.0 * kKnot) < 1e-9);
    QCOMPARE(on({}, 60.0).tailwind, 0.0);
  }

  void aSet_countsWithItsWorst() {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 2000; ++i) {
      const double middle = 360.0 * unit(random);
      const double spread = 90.0 * unit(random);
      const double course = 360.0 * unit(random);
      const aircraft::RunwayWind worst = on(from(middle, 15.0, spread, 5.0), course);
      double tail = -1e9;
      double cross = 0.0;
      for (int k = 0; k <= 400; ++k) {
        for (const double knots : {10.0, 20.0}) {
          const double off = Angle::degrees(middle + spread * (k / 200.0 - 1.0) - course).radians();
          tail = std::max(tail, -knots * kKnot * std::cos(off));
          cross = std::max(cross, std::abs(knots * kKnot * std::sin(off)));
        }
      }
      QVERIFY(std::abs(worst.tailwind - tail) < 1e-3 && worst.tailwind >= tail - 1e-9);
      QVERIFY(std::abs(worst.crosswind - cross) < 1e-3 && worst.crosswind >= cross - 1e-9);
    }
  }

  void layersAroundTheRunway_count() {
    std::vector<air::WindLayer> layers = from(270.0, 5.0);
    layers.push_back({geo::HeightMsl::fromMetres(1000.0), {90.0, 0.0, 8.0, 8.0}});
    layers.push_back({geo::HeightMsl::fromMetres(2000.0), {90.0, 0.0, 30.0, 30.0}});
    QVERIFY(std::abs(on(layers, 270.0).tailwind - 8.0) < 1e-9);  // 300 m lies below the second, far below the third
    const auto high = aircraft::runwayWind(layers, geo::HeightMsl::fromMetres(2500.0), Angle::degrees(270.0));
    QVERIFY(std::abs(high.tailwind - 30.0) < 1e-9);
    const auto low = aircraft::runwayWind(layers, geo::HeightMsl::fromMetres(-10.0), Angle::degrees(270.0));
    QVERIFY(std::abs(low.tailwind + 5.0 * kKnot) < 1e-9);
  }

  void limits_areNamedWithTheirValue() {
    aircraft::AircraftProfile profile = test::paperCessna();
    QVERIFY(aircraft::againstLanding(profile, on(from(90.0, 40.0), 270.0)).empty());  // no limits known
    profile.maxTailwind = Speed::fromSi(10.0 * kKnot);
    profile.maxCrosswind = Speed::fromSi(15.0 * kKnot);
    QVERIFY(aircraft::againstLanding(profile, on(from(90.0, 10.0), 270.0)).empty());
    QCOMPARE(aircraft::againstLanding(profile, on(from(90.0, 11.2), 270.0)), std::string("tailwind of up to 12 kt, the aircraft's limit is 10 kt"));
    QCOMPARE(aircraft::againstLanding(profile, on(from(0.0, 16.0), 270.0)), std::string("crosswind of up to 16 kt, the aircraft's limit is 15 kt"));
  }
};

QTEST_APPLESS_MAIN(TestRunwayWind)
#include "tst_runway_wind.moc"
