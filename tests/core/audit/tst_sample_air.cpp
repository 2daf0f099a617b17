// Winds and masses that samples are flown with.
#include "core/audit/sample_air.h"
#include "tests/support/plan_builder.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace vp;
using namespace vp::audit;

namespace {

constexpr double kPi = 3.14159265358979323846;

mission::Mission windy() {
  mission::Mission mission;
  mission.aircraft = test::cessna();
  mission.aircraft.leastMass_kg = 900.0;
  mission.aircraft.mostMass_kg = 1150.0;
  mission.wind = {{geo::HeightMsl::fromMetres(0.0), {240.0, 20.0, 5.0, 10.0}}, {geo::HeightMsl::fromMetres(2000.0), {350.0, 30.0, 8.0, 8.0}}};
  return mission;
}

/// Degrees that a wind blows from, off the middle of the sector.
double offMiddle(const LevelWind& wind, double from_deg) {
  const double from = 270.0 - std::atan2(wind.north, wind.east) * 180.0 / kPi;
  return std::remainder(from - from_deg, 360.0);
}

}  // namespace

class TestSampleAir : public QObject {
  Q_OBJECT

private slots:
  void draws_stayInTheForecastAndReachItsCorners() {
    const mission::Mission mission = windy();
    int corners = 0;
    int inside = 0;
    int leastMass = 0;
    int mostMass = 0;
    constexpr int kCount = 20000;
    for (std::uint64_t i = 0; i < kCount; ++i) {
      Draws draws(5, i);
      const SampleAir air = drawAir(mission, {0.0, 0.0}, {1000.0, 500.0}, draws);
      QCOMPARE(air.levels.size(), std::size_t{2});
      for (std::size_t k = 0; k < 2; ++k) {
        const air::WindSector& sector = mission.wind[k].wind;
        const double speed = std::hypot(air.levels[k].east, air.levels[k].north);
        QVERIFY(speed >= sector.leastSpeed - 1e-9 && speed <= sector.mostSpeed + 1e-9);
        QVERIFY(std::abs(offMiddle(air.levels[k], sector.from_deg)) <= sector.spread_deg + 1e-9);
      }
      const double speed = std::hypot(air.levels[0].east, air.levels[0].north);
      const bool atEnd = speed > 10.0 - 1e-9 || speed < 5.0 + 1e-9;
      const bool atSide = std::abs(std::abs(offMiddle(air.levels[0], 240.0)) - 20.0) < 1e-9;
      corners += atEnd && atSide ? 1 : 0;
      inside += !atEnd && !atSide ? 1 : 0;
      QVERIFY(air.mass_kg >= 900.0 && air.mass_kg <= 1150.0);
      leastMass += air.mass_kg == 900.0 ? 1 : 0;
      mostMass += air.mass_kg == 1150.0 ? 1 : 0;
    }
    QVERIFY(corners > kCount * 0.25 && inside > kCount * 0.35);
    QVERIFY(leastMass > kCount * 0.2 && mostMass > kCount * 0.2 && leastMass + mostMass < kCount * 0.6);
  }

  /// Three in ten are the worst of the sector for the way to the site: to a site in the west of a west wind, the strongest straight against.
  void adverseWinds_areAgainstTheWay() {
    mission::Mission mission = windy();
    mission.wind = {{geo::HeightMsl::fromMetres(0.0), {260.0, 20.0, 5.0, 10.0}}};
    int against = 0;
    int behind = 0;
    for (std::uint64_t i = 0; i < 5000; ++i) {
      Draws west(7, i);
      const LevelWind wind = drawAir(mission, {0.0, 0.0}, {-1000.0, 0.0}, west).levels[0];
      against += std::abs(wind.north) < 1e-9 && std::abs(wind.east - 10.0) < 1e-9 ? 1 : 0;
      Draws east(7, i);
      const LevelWind other = drawAir(mission, {0.0, 0.0}, {1000.0, 0.0}, east).levels[0];
      behind += std::abs(std::hypot(other.east, other.north) - 5.0) < 1e-9 && std::abs(std::abs(offMiddle(other, 260.0)) - 20.0) < 1e-9 ? 1 : 0;
    }
    QVERIFY2(against > 1300 && against < 1700, qPrintable(QString::number(against)));
    QVERIFY2(behind > 1300, qPrintable(QString::number(behind)));
  }

  void betweenLayers_windIsLinearInHeight() {
    const SampleAir air{{{1000.0, 4.0, 0.0}, {2000.0, 8.0, -6.0}}, 1000.0};
    QVERIFY(std::abs(air.at(1250.0).east - 5.0) < 1e-12 && std::abs(air.at(1250.0).north + 1.5) < 1e-12);
    QCOMPARE(air.at(0.0).east, 4.0);
    QCOMPARE(air.at(9000.0).north, -6.0);
    QCOMPARE(SampleAir{}.at(500.0).east, 0.0);
  }

  /// ICAO Doc 7488/3, table I: densities of the standard atmosphere.
  void standardAtmosphere_hasItsDensities() {
    const air::Atmosphere standard;
    QVERIFY(std::abs(airDensity(standard, 0.0) - 1.2250) < 1e-4);
    QVERIFY(std::abs(airDensity(standard, 3000.0) - 0.90912) < 1e-4);  // geopotential height
    QVERIFY(std::abs(airDensity(standard, 11000.0) - 0.36391) < 1e-4);
    QVERIFY(std::abs(airDensity(standard, 15000.0) - 0.19367) < 1e-4);
    QVERIFY(std::abs(airDensity({15.0, 1013.25}, 0.0) - 1.2250 * 288.15 / 303.15) < 1e-4);
    QVERIFY(std::abs(airDensity({0.0, 1000.0}, 0.0) - 1.2250 * 1000.0 / 1013.25) < 1e-4);
    mission::Mission mission;
    mission.aircraft = test::cessna();
    QCOMPARE(AirTable(mission).speedFactor(3000.0), 1.0);
    mission.atmosphere = standard;
    QVERIFY(std::abs(AirTable(mission).speedFactor(3005.0) - std::sqrt(1.225 / airDensity(standard, 3005.0))) < 1e-6);
  }

  void draws_dependOnSeedAndNumberAlone() {
    Draws a(1, 17);
    Draws b(1, 17);
    Draws c(2, 17);
    Draws d(1, 18);
    const double first = a.unit();
    QCOMPARE(b.unit(), first);
    QVERIFY(c.unit() != first && d.unit() != first);
    double sum = 0.0;
    for (std::uint64_t i = 0; i < 10000; ++i) {
      sum += Draws(3, i).unit();
    }
    QVERIFY(std::abs(sum / 10000.0 - 0.5) < 0.015);  // five standard deviations
  }
};

QTEST_APPLESS_MAIN(TestSampleAir)
#include "tst_sample_air.moc"
