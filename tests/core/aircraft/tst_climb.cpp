// Rate and slope of climb against the handbook's own figures and against what must hold whatever the aircraft is.
#include "core/aircraft/climb.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <cmath>

using namespace vp;

namespace {

constexpr double kFeetPerMinute = 0.3048 / 60.0;
constexpr double kFoot = 0.3048;

/// 172N handbook, section 1: 770 ft/min at sea level, service ceiling 14,200 ft.
aircraft::AircraftProfile climber() {
  aircraft::AircraftProfile profile = test::paperCessna();
  profile.maxClimb = Angle::degrees(20.0);
  profile.climbRate = Speed::fromSi(770.0 * kFeetPerMinute);
  profile.serviceCeiling = geo::HeightMsl::fromMetres(14200.0 * kFoot);
  return profile;
}

geo::HeightMsl feet(double value) {
  return geo::HeightMsl::fromMetres(value * kFoot);
}

}  // namespace

class TestClimb : public QObject {
  Q_OBJECT

private slots:
  void rate_isTheHandbooksAtBothEnds() {
    QVERIFY(std::abs(aircraft::climbRate(climber(), feet(0.0)) / kFeetPerMinute - 770.0) < 1e-9);
    QVERIFY(std::abs(aircraft::climbRate(climber(), feet(14200.0)) / kFeetPerMinute - 100.0) < 1e-9);
    QVERIFY(aircraft::climbRate(climber(), feet(17000.0)) < 0.0);
  }

  void rate_isNearTheHandbooksTable() {
    // 172N handbook, figure 5-6, 2,300 lb, standard temperature (15 - 2 per 1,000 ft degrees): read between its columns
    for (const auto& [altitude, rate] : {std::pair(2000.0, 680.0), std::pair(6000.0, 487.0), std::pair(10000.0, 300.0)}) {
      QVERIFY(std::abs(aircraft::climbRate(climber(), feet(altitude)) / kFeetPerMinute - rate) < 0.05 * 770.0);
    }
  }

  void slope_fallsWithAltitude() {
    const aircraft::GlideConditions conditions{.air = aircraft::AirRange{{20.0, 1000.0}, feet(0.0), feet(13000.0)}};
    double last = 1.0;
    for (double altitude = 0.0; altitude <= 16000.0; altitude += 250.0) {
      const double slope = aircraft::climbSlope(climber(), conditions, feet(altitude));
      QVERIFY(slope < last);
      last = slope;
    }
    QVERIFY(last < 0.0);
  }

  void slope_isLessOnAHotDay() {
    const aircraft::GlideConditions standard{.air = aircraft::AirRange{{}, feet(0.0), feet(13000.0)}};
    const aircraft::GlideConditions hot{.air = aircraft::AirRange{{25.0, 1013.25}, feet(0.0), feet(13000.0)}};
    QVERIFY(aircraft::climbSlope(climber(), hot, feet(6000.0)) < 0.9 * aircraft::climbSlope(climber(), standard, feet(6000.0)));
  }

  void slope_isTheProfilesLimitWhereThatIsLess() {
    aircraft::AircraftProfile profile = climber();
    profile.maxClimb = Angle::degrees(2.0);
    QCOMPARE(aircraft::climbSlope(profile, {}, feet(3000.0)), tan(profile.maxClimb));
    QCOMPARE(aircraft::climbSlope(test::paperCessna(), {}, feet(30000.0)), tan(test::paperCessna().maxClimb));
  }

  void densityAltitude_ofTheStandardAtmosphereIsTheAltitude() {
    for (double altitude = -400.0; altitude < 15000.0; altitude += 700.0) {
      QVERIFY(std::abs(air::densityAltitude({}, geo::HeightMsl::fromMetres(altitude)).metres() - altitude) < 1e-3);
    }
    // the rule of thumb: 120 ft for each degree, near the ground
    const double hot = air::densityAltitude({10.0, 1013.25}, feet(2000.0)).metres() / kFoot;
    QVERIFY(std::abs(hot - 3200.0) < 100.0);
  }

  void altimeter_showsTooMuchInCold_asTheTableSays() {
    // ICAO Doc 8168 volume I, part III, table III-1-4-1 a: aerodrome at sea level and -20 degrees there: 1,000 m above it: 140 m; at 0 degrees: 60 m
    const air::Atmosphere cold{-35.0, 1013.25};
    const air::Atmosphere cool{-15.0, 1013.25};
    QVERIFY(std::abs(air::altimeterError(cold, geo::HeightMsl::fromMetres(1000.0), geo::HeightMsl()) - 140.0) < 5.0);
    QVERIFY(std::abs(air::altimeterError(cool, geo::HeightMsl::fromMetres(1000.0), geo::HeightMsl()) - 60.0) < 6.0);
    QVERIFY(air::altimeterError({10.0, 1013.25}, geo::HeightMsl::fromMetres(1000.0), geo::HeightMsl()) < 0.0);
  }

  void density_isTheStandardAtmospheres() {
    // ICAO Doc 7488/3, by geopotential altitude; geometric ones, that terrain is given in, are 0.05 % higher at 3 km
    for (const auto& [altitude, density] :
         {std::pair(0.0, 1.2250), std::pair(3000.0, 0.90912), std::pair(6000.0, 0.65970), std::pair(11000.0, 0.36391), std::pair(15000.0, 0.19367)}) {
      QVERIFY(std::abs(air::density({}, geo::HeightMsl::fromMetres(altitude)) / density - 1.0) < 2e-3);
    }
  }
};

QTEST_APPLESS_MAIN(TestClimb)
#include "tst_climb.moc"
