// One metre of a glide: the numbers of the source papers, and random metres against two other forms of the same laws.
#include "core/audit/glide_motion.h"
#include "core/audit/ground_track.h"
#include "tests/support/plan_builder.h"
#include "tests/support/wind_flight.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace vp;
using namespace vp::audit;

namespace {

constexpr double kPi = 3.14159265358979323846;

mission::Mission calmMission() {
  mission::Mission mission;
  mission.aircraft = test::cessna();
  return mission;
}

/// A metre on a circle (or straight, radius 0) whose middle has this course.
MetreFlown metreOf(const GlideMotion& motion, double course, double side, double radius, double length, double height) {
  const double half = radius > 0.0 ? side * 0.5 * length / radius : 0.0;
  const auto along = [](double angle) { return Along{std::cos(angle), std::sin(angle)}; };
  return motion.fly(along(course - half), along(course), along(course + half), length, height);
}

}  // namespace

class TestGlideMotion : public QObject {
  Q_OBJECT

private slots:
  /// [1] Table 1 and section 8: 4.90 degrees straight on; at 60 degrees of bank a radius of 65.7 m and 13.1 degrees.
  void stillAir_glidesAsInThePaper() {
    mission::Mission mission = calmMission();
    mission.aircraft.mass_kg = 1000.0;
    mission.aircraft.inducedDrag = 0.053;
    const SampleAir air{{}, 1000.0};
    const AirTable table(mission);
    const GlideMotion motion(mission, air, table);
    const MetreFlown straight = metreOf(motion, 1.0, 0.0, 0.0, 1.0, 500.0);
    QVERIFY(straight.isPossible);
    QVERIFY(std::abs(std::atan(straight.lost) * 180.0 / kPi - 4.90) < 0.005);
    const MetreFlown turn = metreOf(motion, 1.0, 1.0, 65.68, 1.0, 500.0);
    QVERIFY(std::abs(std::atan(turn.bankTangent) * 180.0 / kPi - 60.0) < 0.05);
    QVERIFY(std::abs(std::atan(turn.lost) * 180.0 / kPi - 13.1) < 0.1);
    QVERIFY(std::abs(straight.took - 1.0 / (33.4 * std::cos(std::atan(straight.lost)))) < 1e-9);
  }

  void randomMetres_agreeWithTheCrabAngleForm() {
    const unsigned seed = 20261130;
    qInfo("seed %u", seed);
    std::mt19937_64 random(seed);
    const auto between = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    const mission::Mission mission = calmMission();
    const aircraft::GlidePolar polar = test::polarOf(mission.aircraft);
    const AirTable table(mission);
    double worst = 0.0;
    for (int i = 0; i < 10000; ++i) {
      const double speed = between(0.0, 16.0);
      const double blows = between(0.0, 2.0 * kPi);
      const SampleAir air{{{0.0, speed * std::cos(blows), speed * std::sin(blows)}}, mission.aircraft.mass_kg};
      const GlideMotion motion(mission, air, table);
      const double course = between(0.0, 2.0 * kPi);
      const double radius = i % 3 == 0 ? 0.0 : between(250.0, 2000.0);
      const double expected = test::lossInWind(polar, {air.levels[0].east, air.levels[0].north}, course, radius);
      const MetreFlown metre = metreOf(motion, course, i % 2 == 0 ? 1.0 : -1.0, radius, 1.0, 500.0);
      if (radius > 0.0 && i % 2 != 0) {
        // the other form turns left only: mirror the wind about the course
        const double with = speed * std::cos(blows - course);
        const double across = -speed * std::sin(blows - course);
        const test::SteadyWind mirrored{with * std::cos(course) - across * std::sin(course), with * std::sin(course) + across * std::cos(course)};
        worst = std::max(worst, std::abs(metre.lost / test::lossInWind(polar, mirrored, course, radius) - 1.0));
      } else {
        worst = std::max(worst, std::abs(metre.lost / expected - 1.0));
      }
    }
    qInfo("largest relative difference %.2g", worst);
    QVERIFY(worst < 2e-5);
  }

  /// Energy: into a headwind that weakens downwards a glide loses 1 / (1 - v dW/dh / g) times as much as in a steady one.
  void windThatChangesWithHeight_costsItsEnergy() {
    const mission::Mission mission = calmMission();
    const AirTable table(mission);
    const double change = 0.02;  // 1/s
    const SampleAir sheared{{{0.0, 0.0, 0.0}, {1000.0, -1000.0 * change, 0.0}}, mission.aircraft.mass_kg};
    const SampleAir steady{{{0.0, -500.0 * change, 0.0}}, mission.aircraft.mass_kg};
    const GlideMotion motion(mission, sheared, table);
    const GlideMotion same(mission, steady, table);
    const MetreFlown metre = metreOf(motion, 0.0, 0.0, 0.0, 1.0, 500.0);
    const MetreFlown without = metreOf(same, 0.0, 0.0, 0.0, 1.0, 500.0);
    // by the rate of sink: lost / took
    const double expected = 1.0 / (1.0 - 33.4 * change / 9.80665);
    QVERIFY(std::abs((metre.lost / metre.took) / (without.lost / without.took) / expected - 1.0) < 1e-4);
    // tailwind that weakens downwards gives it back
    const SampleAir behind{{{0.0, 0.0, 0.0}, {1000.0, 1000.0 * change, 0.0}}, mission.aircraft.mass_kg};
    const GlideMotion gaining(mission, behind, table);
    const MetreFlown gained = metreOf(gaining, 0.0, 0.0, 0.0, 1.0, 500.0);
    QVERIFY(gained.lost / gained.took < without.lost / without.took * 0.95);
  }

  void windStrongerThanTheAircraft_isNoGlide() {
    const mission::Mission mission = calmMission();
    const AirTable table(mission);
    const SampleAir against{{{0.0, -40.0, 0.0}}, mission.aircraft.mass_kg};
    const SampleAir across{{{0.0, 0.0, 40.0}}, mission.aircraft.mass_kg};
    QVERIFY(!metreOf(GlideMotion(mission, against, table), 0.0, 0.0, 0.0, 1.0, 500.0).isPossible);
    QVERIFY(!metreOf(GlideMotion(mission, across, table), 0.0, 0.0, 0.0, 1.0, 500.0).isPossible);
    QVERIFY(metreOf(GlideMotion(mission, against, table), kPi, 0.0, 0.0, 1.0, 500.0).isPossible);
  }

  void massAndPilot_changeSpeedAndLoss() {
    mission::Mission mission = calmMission();
    const AirTable table(mission);
    const SampleAir light{{}, mission.aircraft.mass_kg * 0.64};
    const SampleAir usual{{}, mission.aircraft.mass_kg};
    QVERIFY(std::abs(GlideMotion(mission, light, table).airspeed(0.0) - 0.8 * 33.4) < 1e-9);
    const double one = metreOf(GlideMotion(mission, usual, table), 0.0, 0.0, 0.0, 1.0, 0.0).lost;
    QVERIFY(std::abs(metreOf(GlideMotion(mission, light, table), 0.0, 0.0, 0.0, 1.0, 0.0).lost - one) < 1e-12);
    mission.safety.dragFactor = 1.2;
    const double sloppy = metreOf(GlideMotion(mission, usual, table), 0.0, 0.0, 0.0, 1.0, 0.0).lost;
    QVERIFY(std::abs(sloppy / std::hypot(1.0, sloppy) - 1.2 * one / std::hypot(1.0, one)) < 1e-12);
    mission.safety.dragFactor = 1.0;
    mission.aircraft.stoppedDrag = mission.aircraft.zeroLiftDrag + 0.01;
    mission.propeller = aircraft::Propeller::Stopped;
    QVERIFY(metreOf(GlideMotion(mission, usual, table), 0.0, 0.0, 0.0, 1.0, 0.0).lost > one * 1.1);
  }

  /// A full circle cut into metres ends where it began, and a turn's bank is the same by both ways that it is found.
  void track_closesAndBanksAgree() {
    const std::optional<GroundTrack> track = cutIntoMetres({100.0, -50.0, 0.3}, {{flight::Turn::Left, 120.0, 240.0 * kPi}});
    QVERIFY(track.has_value());
    QVERIFY(geo::distance(track->end().point(), {100.0, -50.0}) < 1e-6);
    QVERIFY(std::abs(track->end().heading - 0.3 - 2.0 * kPi) < 1e-9);
    QCOMPARE(track->bends.size(), std::size_t{1});
    QVERIFY(std::abs(track->bends[0].turned - 2.0 * kPi) < 1e-12);
    QVERIFY(!cutIntoMetres({}, {{flight::Turn::Left, 0.0, 10.0}}));
    QVERIFY(!cutIntoMetres({}, {{flight::Turn::Straight, 0.0, 2e6}}));
    const mission::Mission mission = calmMission();
    const AirTable table(mission);
    const SampleAir air{{{0.0, 7.0, -4.0}}, mission.aircraft.mass_kg};
    const GlideMotion motion(mission, air, table);
    const MetreFlown metre = metreOf(motion, 0.7, -1.0, 300.0, 1.0, 0.0);
    QVERIFY(std::abs(std::atan(metre.bankTangent) - motion.bankOf({std::cos(0.7), std::sin(0.7)}, -1.0 / 300.0, 33.4, 0.0)) < 1e-4);
  }
};

QTEST_APPLESS_MAIN(TestGlideMotion)
#include "tst_glide_motion.moc"
