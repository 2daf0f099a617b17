// Landing distance of a day: each factor against figures worked out by hand, and its place in a mission.
#include "core/aircraft/landing_distance.h"
#include "core/mission/runway_need.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <cmath>

using namespace vp;

namespace {

constexpr double kKnot = 1852.0 / 3600.0;

aircraft::AircraftProfile skyhawk() {
  aircraft::AircraftProfile profile = test::paperCessna();
  profile.landingDistance = Length::fromSi(381.0);
  profile.stallSpeed = Speed::fromSi(50.0 * kKnot);
  return profile;
}

double needed(const aircraft::LandingConditions& conditions) {
  return aircraft::landingDistance(skyhawk(), conditions)->si();
}

mission::LandingSite end(const char* id, geo::LatLon place, double course, double elevation) {
  mission::LandingSite site;
  site.id = id;
  site.airportIdent = "A";
  site.touchdown = place;
  site.landingCourse = Angle::degrees(course);
  site.elevation = geo::HeightMsl::fromMetres(elevation);
  site.length = Length::fromSi(600.0);
  site.surface = mission::Surface::Hard;
  return site;
}

mission::Mission missionOf(const aircraft::AircraftProfile& profile) {
  mission::Mission mission;
  mission.aircraft = profile;
  return mission;
}

}  // namespace

class TestLandingDistance : public QObject {
  Q_OBJECT

private slots:
  void standardDay_atSeaLevel_isTheProfiles() {
    QVERIFY(std::abs(needed({}) - 381.0) < 0.01);
    QVERIFY(!aircraft::landingDistance(test::paperCessna(), {}));
  }

  void thinAir_takesMore() {
    aircraft::LandingConditions high;
    high.elevation = geo::HeightMsl::fromMetres(2000.0);  // 1.0066 kg/m^3 in the standard atmosphere, ICAO Doc 7488
    QVERIFY(std::abs(needed(high) - 381.0 * 1.225 / 1.0066) < 0.1);
    aircraft::LandingConditions hot;
    hot.air.temperatureOffset_K = 20.0;
    QVERIFY(std::abs(needed(hot) - 381.0 * 308.15 / 288.15) < 0.1);
    aircraft::LandingConditions low;
    low.air.qnh_hPa = 980.0;
    QVERIFY(std::abs(needed(low) - 381.0 * 1013.25 / 980.0) < 0.1);
  }

  void wind_countsOneAndAHalfBehindAndHalfAhead() {
    aircraft::LandingConditions behind;
    behind.wind.tailwind = 10.0 * kKnot;  // of an approach at 65 kt
    QVERIFY(std::abs(needed(behind) - 381.0 * std::pow(80.0 / 65.0, 2)) < 0.01);
    aircraft::LandingConditions ahead;
    ahead.wind.tailwind = -10.0 * kKnot;
    QVERIFY(std::abs(needed(ahead) - 381.0 * std::pow(60.0 / 65.0, 2)) < 0.01);
    aircraft::LandingConditions gale;
    gale.wind.tailwind = -200.0 * kKnot;
    QCOMPARE(needed(gale), 0.0);
    aircraft::AircraftProfile unknownStall = skyhawk();
    unknownStall.stallSpeed.reset();  // best glide 33.4 m/s stands in
    QVERIFY(std::abs(aircraft::landingDistance(unknownStall, behind)->si() - 381.0 * std::pow((33.4 + 15.0 * kKnot) / 33.4, 2)) < 0.01);
    aircraft::LandingConditions thin = behind;  // true airspeed is greater, so the same wind counts less
    thin.elevation = geo::HeightMsl::fromMetres(2000.0);
    const double faster = 65.0 * std::sqrt(1.225 / 1.0066);
    QVERIFY(std::abs(needed(thin) - 381.0 * 1.225 / 1.0066 * std::pow((faster + 15.0) / faster, 2)) < 0.2);
  }

  void slopeAndSurface_multiply() {
    aircraft::LandingConditions conditions;
    conditions.downhillPercent = 2.0;
    QVERIFY(std::abs(needed(conditions) - 381.0 * 1.1) < 0.01);  // the leaflet's own example
    conditions.surfaceFactor = aircraft::kGrassFactor;
    QVERIFY(std::abs(needed(conditions) - 381.0 * 1.1 * 1.35) < 0.01);
    conditions.downhillPercent = -2.0;
    QVERIFY(std::abs(needed(conditions) - 381.0 * 1.35) < 0.01);
  }

  void runwayWithTwoEnds_isShortDownhillOnly() {
    const geo::LatLon south{46.5, 9.9};
    const geo::LatLon north = geo::geodesicDestination(south, Angle::degrees(0.0), Length::fromSi(600.0));
    const mission::LandingSite up = end("A/36", south, 0.0, 0.0);
    const mission::LandingSite down = end("A/18", north, 180.0, 75.0);  // 12.5 %
    const std::vector<mission::SiteInFrame> both{{up, {}}, {down, {}}};
    const mission::Mission mission = missionOf(skyhawk());
    QVERIFY(std::abs(mission::landingNeed(mission, up, both)->si() - 381.0) < 0.1);
    const double thin = 1.225 / air::density({}, down.elevation);
    QVERIFY(std::abs(mission::landingNeed(mission, down, both)->si() - 381.0 * thin * 1.625) < 0.5);
    QVERIFY(mission::tooShort(mission, up, both).empty());
    QCOMPARE(mission::tooShort(mission, down, both), std::string("600 m long, 624 m needed"));
    QVERIFY(mission::tooShort(mission, down, {{down, {}}}).empty());  // without its other end it is level
    mission::LandingSite elsewhere = up;                              // a parallel runway 300 m aside is no other end
    elsewhere.touchdown = geo::geodesicDestination(south, Angle::degrees(90.0), Length::fromSi(300.0));
    QVERIFY(mission::tooShort(mission, down, {{down, {}}, {elsewhere, {}}}).empty());
  }

  void whatIsNotKnown_isNotTooShort() {
    mission::LandingSite site = end("A/36", {46.5, 9.9}, 0.0, 0.0);
    site.length = Length::fromSi(380.0);
    QCOMPARE(mission::tooShort(missionOf(skyhawk()), site, {}), std::string("380 m long, 381 m needed"));
    QVERIFY(mission::tooShort(missionOf(test::paperCessna()), site, {}).empty());
    site.surface = mission::Surface::Water;
    QVERIFY(mission::tooShort(missionOf(skyhawk()), site, {}).empty());
    site.surface = mission::Surface::Unknown;
    QCOMPARE(mission::tooShort(missionOf(skyhawk()), site, {}), std::string("380 m long, 515 m needed"));
    site.length.reset();
    QVERIFY(mission::tooShort(missionOf(skyhawk()), site, {}).empty());
  }

  void theWindAndAirOfTheMission_count() {
    mission::Mission mission = missionOf(skyhawk());
    const mission::LandingSite site = end("A/36", {46.5, 9.9}, 0.0, 0.0);
    mission.wind = {{geo::HeightMsl(), {180.0, 0.0, 10.0 * kKnot, 10.0 * kKnot}}};
    mission.atmosphere = air::Atmosphere{20.0, 1013.25};
    const double thin = 308.15 / 288.15;
    const double approach = 65.0 * std::sqrt(thin);
    QVERIFY(std::abs(mission::landingNeed(mission, site, {})->si() - 381.0 * thin * std::pow((approach + 15.0) / approach, 2)) < 0.1);
  }
};

QTEST_APPLESS_MAIN(TestLandingDistance)
#include "tst_landing_distance.moc"
