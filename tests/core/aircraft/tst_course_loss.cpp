// Loss by course in wind: against the equations of motion, sampled densely over winds and courses, and against calm air.
#include "core/aircraft/course_loss.h"
#include "core/aircraft/glide_model.h"
#include "tests/support/mountain.h"
#include "tests/support/wind_flight.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace vp;

namespace {

constexpr double kPi = Angle::kPi;
using test::kKnot;
using test::polarOf;

double lossOfOne(const aircraft::GlidePolar& polar, double windEast, double windNorth, double course, double radius) {
  return test::lossInWind(polar, {windEast, windNorth}, course, radius);
}

struct Case {
  air::WindSector sector;
  double radius;
};

Case randomCase(std::mt19937_64& random, double airspeed) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Case c;
  c.sector.from_deg = 360.0 * unit(random);
  c.sector.spread_deg = unit(random) < 0.3 ? 0.0 : 60.0 * unit(random);
  c.sector.leastSpeed = 0.45 * airspeed * unit(random);
  c.sector.mostSpeed = unit(random) < 0.3 ? c.sector.leastSpeed : c.sector.leastSpeed + 0.1 * airspeed * unit(random);
  const double fastest = airspeed + c.sector.mostSpeed;
  c.radius = fastest * fastest / (kGravity.si() * std::tan((20.0 + 30.0 * unit(random)) / 180.0 * kPi));
  return c;
}

double within(std::mt19937_64& random, double least, double most) {
  return std::uniform_real_distribution<double>(0.0, 1.0)(random) * (most - least) + least;
}

}  // namespace

class TestCourseLoss : public QObject {
  Q_OBJECT

private slots:
  void noWindOfTheSet_losesMoreThanTheBound() {
    std::mt19937_64 random(1);
    const aircraft::GlidePolar polar = polarOf(test::paperCessna());
    for (int i = 0; i < 300; ++i) {
      const Case c = randomCase(random, polar.airspeed);
      const aircraft::CourseLoss loss(polar, {c.sector}, c.radius);
      for (int k = 0; k < 300; ++k) {
        const double course = within(random, -7.0, 7.0);
        const double towards = c.sector.towards() + within(random, -1.0, 1.0) * c.sector.spread();
        const double speed = within(random, c.sector.leastSpeed, c.sector.mostSpeed);
        const double east = speed * std::cos(towards);
        const double north = speed * std::sin(towards);
        QVERIFY(loss.straightRate(std::cos(course), std::sin(course)) >= lossOfOne(polar, east, north, course, 0.0));
        QVERIFY(loss.mostInTurn(course, 1e-6) >= lossOfOne(polar, east, north, course, c.radius) * (1.0 - 1e-8));
      }
    }
  }

  void windsBetweenTwoLayers_loseNoMoreThanTheBound() {
    std::mt19937_64 random(2);
    const aircraft::GlidePolar polar = polarOf(test::paperCessna());
    for (int i = 0; i < 300; ++i) {
      const Case a = randomCase(random, polar.airspeed);
      const Case b = randomCase(random, polar.airspeed);
      const double radius = std::max(a.radius, b.radius);
      const aircraft::CourseLoss loss(polar, {a.sector, b.sector}, radius);
      for (int k = 0; k < 300; ++k) {
        const double course = within(random, -4.0, 4.0);
        const double part = within(random, 0.0, 1.0);
        double east = 0.0;
        double north = 0.0;
        for (const auto& [sector, weight] : {std::pair(a.sector, part), std::pair(b.sector, 1.0 - part)}) {
          const double towards = sector.towards() + within(random, -1.0, 1.0) * sector.spread();
          const double speed = within(random, sector.leastSpeed, sector.mostSpeed);
          east += weight * speed * std::cos(towards);
          north += weight * speed * std::sin(towards);
        }
        QVERIFY(loss.straightRate(std::cos(course), std::sin(course)) >= lossOfOne(polar, east, north, course, 0.0));
        QVERIFY(loss.mostInTurn(course, 1e-6) >= lossOfOne(polar, east, north, course, radius) * (1.0 - 1e-8));
      }
    }
  }

  void oneWind_isBoundedTightly() {
    std::mt19937_64 random(3);
    const aircraft::GlidePolar polar = polarOf(test::paperCessna());
    for (int i = 0; i < 300; ++i) {
      Case c = randomCase(random, polar.airspeed);
      c.sector.spread_deg = 0.0;
      c.sector.leastSpeed = c.sector.mostSpeed;
      const aircraft::CourseLoss loss(polar, {c.sector}, c.radius);
      const double east = c.sector.mostSpeed * std::cos(c.sector.towards());
      const double north = c.sector.mostSpeed * std::sin(c.sector.towards());
      const double course = within(random, -4.0, 4.0);
      QVERIFY(loss.straightRate(std::cos(course), std::sin(course)) <= lossOfOne(polar, east, north, course, 0.0) * (1.0 + 3e-5));
      const double turned = within(random, -6.0, 6.0);
      constexpr int kParts = 4000;
      double integral = 0.0;
      for (int k = 0; k < kParts; ++k) {
        integral += lossOfOne(polar, east, north, course + turned * (k + 0.5) / kParts, c.radius);
      }
      integral *= c.radius * std::abs(turned) / kParts;
      QVERIFY2(loss.turn(course, turned) >= integral * (1.0 - 1e-9), qPrintable(QString::number(loss.turn(course, turned) / integral - 1.0)));
      QVERIFY2(loss.turn(course, turned) <= integral * 1.003 + 0.01, qPrintable(QString::number(loss.turn(course, turned) / integral - 1.0)));
    }
  }

  void wideSets_areBoundedTightly() {
    const aircraft::GlidePolar polar = polarOf(test::paperCessna());
    for (const air::WindSector& sector : {air::WindSector{250.0, 21.0, 0.0, 13.6}, {30.0, 60.0, 4.0, 12.0}, {0.0, 180.0, 0.0, 8.0}}) {
      const double radius = 390.0;
      const aircraft::CourseLoss loss(polar, {sector}, radius);
      for (double course = -3.0; course < 3.0; course += 0.17) {
        double worst = 0.0;
        for (int i = 0; i <= 100; ++i) {
          for (int k = 0; k <= 40; ++k) {
            const double towards = sector.towards() + (i / 50.0 - 1.0) * sector.spread();
            const double speed = sector.leastSpeed + k / 40.0 * (sector.mostSpeed - sector.leastSpeed);
            worst = std::max(worst, lossOfOne(polar, speed * std::cos(towards), speed * std::sin(towards), course, radius));
          }
        }
        QVERIFY2(loss.mostInTurn(course, 1e-6) <= 1.02 * worst, qPrintable(QString::number(loss.mostInTurn(course, 1e-6) / worst)));
      }
    }
  }

  void aWiderSet_neverLosesLess() {
    std::mt19937_64 random(4);
    const aircraft::GlidePolar polar = polarOf(test::paperCessna());
    for (int i = 0; i < 200; ++i) {
      const Case c = randomCase(random, polar.airspeed);
      air::WindSector wide = c.sector;
      wide.spread_deg = std::min(180.0, wide.spread_deg + within(random, 0.0, 30.0));
      wide.leastSpeed = std::max(0.0, wide.leastSpeed - within(random, 0.0, 3.0));
      wide.mostSpeed += within(random, 0.0, 3.0);
      const aircraft::CourseLoss narrow(polar, {c.sector}, c.radius);
      const aircraft::CourseLoss wider(polar, {wide}, c.radius);
      for (int k = 0; k < 200; ++k) {
        const double course = within(random, -4.0, 4.0);
        const double turned = within(random, -7.0, 7.0);
        QVERIFY(wider.straightRate(std::cos(course), std::sin(course)) >= narrow.straightRate(std::cos(course), std::sin(course)) * (1.0 - 1e-12));
        QVERIFY(wider.turn(course, turned) >= narrow.turn(course, turned) * (1.0 - 1e-9));
      }
    }
  }

  void rotatingMapAndWind_rotatesTheLoss() {
    std::mt19937_64 random(5);
    const aircraft::GlidePolar polar = polarOf(test::paperCessna());
    for (int i = 0; i < 50; ++i) {
      const Case c = randomCase(random, polar.airspeed);
      air::WindSector turnedSector = c.sector;
      turnedSector.from_deg = std::fmod(c.sector.from_deg + 330.0, 360.0);  // 30 degrees to the left
      const aircraft::CourseLoss before(polar, {c.sector}, c.radius);
      const aircraft::CourseLoss after(polar, {turnedSector}, c.radius);
      for (int k = 0; k < 50; ++k) {
        const double course = within(random, -4.0, 4.0);
        const double turned = within(random, -7.0, 7.0);
        QVERIFY(std::abs(before.turn(course, turned) - after.turn(course + kPi / 6.0, turned)) < 1e-6);
        const double rotated = course + kPi / 6.0;
        QVERIFY(std::abs(before.straightRate(std::cos(course), std::sin(course)) - after.straightRate(std::cos(rotated), std::sin(rotated))) < 1e-9);
      }
    }
  }

  void least_isBelowEveryWayBetweenTwoPoints() {
    std::mt19937_64 random(6);
    const aircraft::GlidePolar polar = polarOf(test::paperCessna());
    for (int i = 0; i < 100; ++i) {
      const Case c = randomCase(random, polar.airspeed);
      const aircraft::CourseLoss loss(polar, {c.sector}, c.radius);
      for (int k = 0; k < 100; ++k) {
        const double ax = within(random, -1000.0, 1000.0);
        const double ay = within(random, -1000.0, 1000.0);
        const double bx = within(random, -1000.0, 1000.0);
        const double by = within(random, -1000.0, 1000.0);
        QVERIFY(loss.straight(ax + bx, ay + by) <= (loss.straight(ax, ay) + loss.straight(bx, by)) * (1.0 + 1e-9));
        QVERIFY(loss.leastStraight() * std::hypot(ax, ay) <= loss.straight(ax, ay));
        QVERIFY(loss.mostStraight() * std::hypot(ax, ay) >= loss.straight(ax, ay) * (1.0 - 1e-12));
        const double course = within(random, -4.0, 4.0);
        const double turned = within(random, -6.0, 6.0);
        const double chordEast = c.radius * (std::sin(course + std::abs(turned)) - std::sin(course));
        const double chordNorth = -c.radius * (std::cos(course + std::abs(turned)) - std::cos(course));
        QVERIFY(loss.straight(chordEast, chordNorth) + loss.leastExcess() * c.radius * std::abs(turned) <=
                loss.turn(course, std::abs(turned)) + 1e-9);
        QVERIFY(loss.leastTurn() * c.radius * std::abs(turned) <= loss.turn(course, turned) + 1e-9);
        QVERIFY(loss.mostInTurn(course, turned) * c.radius * std::abs(turned) >= loss.turn(course, turned) - 1e-9);
      }
    }
  }

  void vanishingWind_isCalmAir() {
    const aircraft::AircraftProfile profile = test::paperCessna();
    const aircraft::GlideModel calm(profile);
    const aircraft::GlideModel light(profile, {.winds = {{geo::HeightMsl(), {123.0, 0.0, 0.0, 1e-9}}}});
    const aircraft::GlideModel none(profile, {.winds = {{geo::HeightMsl(), {123.0, 0.0, 0.0, 0.0}}}});
    QVERIFY(none.isCalm() && !light.isCalm());
    QCOMPARE(none.lossOver(300.0, 400.0), calm.straightLoss() * 500.0);
    QVERIFY(std::abs(light.lossOver(300.0, 400.0) - calm.straightLoss() * 500.0) < 2e-3);
    for (std::size_t i = 0; i < calm.glideRadii().size(); ++i) {
      QVERIFY(std::abs(light.glideRadii()[i] - calm.glideRadii()[i]) < 1e-6);
      const double radius = light.glideRadii()[i];
      QVERIFY(std::abs(light.courseLoss(radius)->turn(1.0, -2.0) - 2.0 * radius * calm.lossAt(radius)) < 1e-2);
    }
  }

  void windAgainstTheGlide_costsItsShareOfTheRange() {
    // 15 kt against 65 kt: the range shrinks to 50/65, but for the flight path's own slope
    const aircraft::AircraftProfile profile = test::paperCessna();
    const aircraft::GlideModel calm(profile);
    const aircraft::GlideModel windy(profile, {.winds = {{geo::HeightMsl(), {270.0, 0.0, 15.0 * kKnot, 15.0 * kKnot}}}});
    const double v = profile.bestGlideSpeed.si() * std::cos(std::atan(calm.straightLoss()));
    const double expected = calm.straightLoss() * v / (v - 15.0 * kKnot);
    QVERIFY(std::abs(windy.lossOver(-1.0, 0.0) / expected - 1.0) < 3e-5);
    QVERIFY(windy.lossOver(1.0, 0.0) < calm.straightLoss());
  }

  void windOfTheAirspeed_holdsTheAircraftUp() {
    const aircraft::AircraftProfile profile = test::paperCessna();
    const double v = profile.bestGlideSpeed.si();
    const aircraft::CourseLoss loss(polarOf(profile), {{270.0, 0.0, v, v}}, 500.0);
    QVERIFY(std::isinf(loss.straightRate(-1.0, 0.0)));
    QVERIFY(std::isinf(loss.mostTurn()));
  }
};

QTEST_APPLESS_MAIN(TestCourseLoss)
#include "tst_course_loss.moc"
