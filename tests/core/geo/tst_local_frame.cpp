#include "core/geo/local_frame.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace vp;
using namespace vp::geo;
using namespace vp::literals;

namespace {

/// Origins all over the world: both hemispheres, the date line, close to a pole, the equator.
const LatLon kOrigins[] = {{47.0, 11.0}, {-35.3, 149.2}, {61.2, -149.9}, {0.0, 0.0}, {-16.9, 179.99}, {84.0, -40.0}};

double degreesBetween(double a_rad, double b_rad) {
  return std::abs(Angle::radians(wrapPi(a_rad - b_rad)).degrees());
}

double headingFromTo(Point a, Point b) {
  return std::atan2(b.y - a.y, b.x - a.x);
}

}  // namespace

class TestLocalFrame : public QObject {
  Q_OBJECT

private:
  std::mt19937 generator_;
  double random(double from, double to) { return std::uniform_real_distribution<double>(from, to)(generator_); }

private slots:
  void init() {
    constexpr unsigned kSeed = 4711;
    qInfo("seed %u", kSeed);
    generator_.seed(kSeed);
  }

  void origin_isZero() {
    for (const LatLon& origin : kOrigins) {
      const Point p = LocalFrame(origin).toPoint(origin);
      QVERIFY(std::hypot(p.x, p.y) < 1e-9);
    }
  }

  void oneMetreNorthAndEast_isOneMetreOnItsAxis() {
    for (const LatLon& origin : kOrigins) {
      const LocalFrame frame(origin);
      const Point north = frame.toPoint(geodesicDestination(origin, 0.0_deg, 1.0_m));
      const Point east = frame.toPoint(geodesicDestination(origin, 90.0_deg, 1.0_m));
      QVERIFY(std::abs(north.x) < 1e-6 && std::abs(north.y - 1.0) < 1e-6);
      QVERIFY(std::abs(east.x - 1.0) < 1e-6 && std::abs(east.y) < 1e-6);
    }
  }

  void roundTrip_ofRandomPoints_isWithinAMicrometre() {
    for (int k = 0; k < 10'000; ++k) {
      const LocalFrame frame({random(-85.0, 85.0), random(-180.0, 180.0)});
      const Point p{random(-300e3, 300e3), random(-300e3, 300e3)};
      const Point back = frame.toPoint(frame.toLatLon(p));
      QVERIFY2(distance(p, back) < 1e-6, qPrintable(QStringLiteral("%1 m at (%2, %3)").arg(distance(p, back)).arg(p.x).arg(p.y)));
    }
  }

  void distanceAndCourseFromTheOrigin_areThoseOfTheGeodesic() {
    for (int k = 0; k < 10'000; ++k) {
      const LatLon origin{random(-80.0, 80.0), random(-180.0, 180.0)};
      const LocalFrame frame(origin);
      const Point p{random(-200e3, 200e3), random(-200e3, 200e3)};
      const LatLon place = frame.toLatLon(p);
      QVERIFY(std::abs(geodesicDistance(origin, place).si() - std::hypot(p.x, p.y)) < 1e-6);
      QVERIFY(degreesBetween(geodesicCourse(origin, place).radians(), Angle::kPi / 2.0 - headingFromTo({}, p)) < 1e-6);
    }
  }

  void scaleAcross_isAsDocumented() {
    const LocalFrame frame({47.0, 11.0});
    const Point a{200e3, -500.0};
    const Point b{200e3, 500.0};
    const double tooLong = distance(a, b) - geodesicDistance(frame.toLatLon(a), frame.toLatLon(b)).si();
    QVERIFY2(tooLong > 0.15 && tooLong < 0.18, qPrintable(QString::number(tooLong)));  // r^2 / (6 R^2) = 0.16 m per km at 200 km
  }

  void courseAndHeading_roundTrip() {
    for (int k = 0; k < 10'000; ++k) {
      const LocalFrame frame({random(-80.0, 80.0), random(-180.0, 180.0)});
      const Point p{random(-200e3, 200e3), random(-200e3, 200e3)};
      const Angle course = Angle::degrees(random(0.0, 360.0));
      const double heading = frame.headingOf(course, frame.toLatLon(p));
      QVERIFY(heading >= 0.0 && heading < 2.0 * Angle::kPi);
      const Angle back = frame.trueCourseOf(heading, p);
      QVERIFY(back.degrees() >= 0.0 && back.degrees() < 360.0 + 1e-9);
      QVERIFY(degreesBetween(back.radians(), course.radians()) < 1e-7);
    }
  }

  void cardinalCourses_atTheOrigin_areMathematicalHeadings_data() {
    QTest::addColumn<double>("course");
    QTest::addColumn<double>("heading");
    QTest::newRow("north") << 0.0 << 90.0;
    QTest::newRow("east") << 90.0 << 0.0;
    QTest::newRow("south") << 180.0 << 270.0;
    QTest::newRow("west") << 270.0 << 180.0;
    QTest::newRow("north-west") << 315.0 << 135.0;
  }
  void cardinalCourses_atTheOrigin_areMathematicalHeadings() {
    QFETCH(double, course);
    QFETCH(double, heading);
    for (const LatLon& origin : kOrigins) {
      const LocalFrame frame(origin);
      QVERIFY(degreesBetween(frame.headingOf(Angle::degrees(course), origin), Angle::degrees(heading).radians()) < 1e-9);
    }
  }

  void headingOfACourse_farFromTheOrigin_isThatOfAGeodesicStep() {
    double worst = 0.0;
    for (int k = 0; k < 10'000; ++k) {
      const LocalFrame frame({random(-75.0, 75.0), random(-180.0, 180.0)});
      const double direction = random(0.0, 2.0 * Angle::kPi);
      const Point p{100e3 * std::cos(direction), 100e3 * std::sin(direction)};
      const LatLon place = frame.toLatLon(p);
      const Angle course = Angle::degrees(random(0.0, 360.0));
      const Point ahead = frame.toPoint(geodesicDestination(place, course, 10.0_m));
      worst = std::max(worst, degreesBetween(headingFromTo(p, ahead), frame.headingOf(course, place)));
    }
    QVERIFY2(worst < 0.02, qPrintable(QStringLiteral("%1 degrees").arg(worst)));
    QVERIFY2(worst > 0.0, "the two ways of computing are independent, so they differ in the last bits");
  }

  void convergence_eastOfTheOrigin_hasTheRightSign() {
    // 100 km east of a northern origin the meridian leans to the left of the frame's north: true north is a heading above 90 degrees.
    const LocalFrame frame({47.0, 11.0});
    const Point p{100e3, 0.0};
    const double north = Angle::radians(frame.headingOf(0.0_deg, frame.toLatLon(p))).degrees();
    QVERIFY2(north > 90.5 && north < 91.5, qPrintable(QString::number(north)));
  }

  void projString_namesTheOrigin() {
    QCOMPARE(LocalFrame({46.5, -27.25}).projString(), std::string("+proj=aeqd +lat_0=46.5 +lon_0=-27.25 +datum=WGS84 +units=m +no_defs"));
  }
};

QTEST_APPLESS_MAIN(TestLocalFrame)
#include "tst_local_frame.moc"
