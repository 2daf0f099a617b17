// The best of all words in wind, what it must not depend on, what is refused, and the wind triangle.
#include "core/base/expect.h"
#include "tests/core/flight/wind_cases.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace vp;
using namespace vp::flight;

class TestWindConnection : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { qInfo("seed %u", kSeed); }

  void best_underAllWords_isLeast_data() {
    QTest::addColumn<double>("reach");
    QTest::newRow("one radius") << kRadius;
    QTest::newRow("five radii") << 5.0 * kRadius;
    QTest::newRow("fifty radii") << 50.0 * kRadius;
  }

  void best_underAllWords_isLeast() {
    QFETCH(double, reach);
    RandomCases random(reach, 0.95);
    for (int i = 0; i < 20000; ++i) {
      const Case c = random();
      double shortest = 1e300;
      double cheapest = 1e300;
      for (const Word word : kWords) {
        for (const WindPath& path : windWord(c.from, c.to, kRadius, kAirspeed, c.wind, word)) {
          shortest = std::min(shortest, path.length());
          cheapest = std::min(cheapest, lossOf(path, kLoss));
        }
      }
      const Result<WindPath> quickest = shortestTime(c.from, c.to, kRadius, kAirspeed, c.wind);
      const Result<WindPath> least = leastLoss(c.from, c.to, kRadius, kAirspeed, c.wind, kLoss);
      QVERIFY(quickest && least);
      QVERIFY(std::abs(quickest->length() - shortest) < 1e-7);
      QVERIFY(std::abs(lossOf(*least, kLoss) - cheapest) < 1e-7);
      QCOMPARE(quickest->duration(), quickest->length() / kAirspeed);
    }
  }

  void shortest_underSymmetries_takesTheSameTime() {
    RandomCases random(10.0 * kRadius, 0.9);
    for (int i = 0; i < 10000; ++i) {
      const Case c = random();
      const auto lengthOf = [](const geo::Pose& from, const geo::Pose& to, air::Wind wind) {
        const Result<WindPath> path = shortestTime(from, to, kRadius, kAirspeed, wind);
        return path ? path->length() : -1.0;
      };
      const double length = lengthOf(c.from, c.to, c.wind);
      const double by = random.angle();
      const double cosine = std::cos(by);
      const double sine = std::sin(by);
      const auto turned = [&](const geo::Pose& p) { return geo::Pose{cosine * p.x - sine * p.y, sine * p.x + cosine * p.y, p.heading + by}; };
      const air::Wind turnedWind{cosine * c.wind.east - sine * c.wind.north, sine * c.wind.east + cosine * c.wind.north};
      QVERIFY(std::abs(lengthOf(turned(c.from), turned(c.to), turnedWind) - length) < 1e-6);
      const auto mirrored = [](const geo::Pose& p) { return geo::Pose{-p.x, p.y, kPi - p.heading}; };
      QVERIFY(std::abs(lengthOf(mirrored(c.from), mirrored(c.to), {-c.wind.east, c.wind.north}) - length) < 1e-6);
      const auto reversed = [](const geo::Pose& p) { return geo::Pose{p.x, p.y, p.heading + kPi}; };
      QVERIFY(std::abs(lengthOf(reversed(c.to), reversed(c.from), {-c.wind.east, -c.wind.north}) - length) < 1e-6);
    }
  }

  void refusals_underWhatCannotBeFlown_sayWhy_data() {
    QTest::addColumn<double>("windEast");
    QTest::addColumn<double>("airspeed");
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("x");
    QTest::addColumn<QString>("says");
    QTest::newRow("wind as fast") << 25.0 << 25.0 << 100.0 << 0.0 << "as strong as the airspeed or stronger";
    QTest::newRow("wind faster") << -30.0 << 25.0 << 100.0 << 0.0 << "as strong as the airspeed or stronger";
    QTest::newRow("wind hardly slower") << 25.0 * (1.0 - 1e-8) << 25.0 << 100.0 << 0.0 << "as strong as the airspeed or stronger";
    QTest::newRow("no airspeed") << 0.0 << 0.0 << 100.0 << 0.0 << "as strong as the airspeed or stronger";
    QTest::newRow("wind not a number") << double(NAN) << 25.0 << 100.0 << 0.0 << "wind or the airspeed is not a number";
    QTest::newRow("airspeed not a number") << 5.0 << double(NAN) << 100.0 << 0.0 << "wind or the airspeed is not a number";
    QTest::newRow("no radius") << 5.0 << 25.0 << 0.0 << 0.0 << "radius is not above zero";
    QTest::newRow("radius not a number") << 5.0 << 25.0 << double(NAN) << 0.0 << "radius is not above zero";
    QTest::newRow("too far") << 5.0 << 25.0 << 100.0 << 1e12 << "too far apart";
    QTest::newRow("endless place") << 5.0 << 25.0 << 100.0 << double(INFINITY) << "place or heading is not a number";
  }

  void refusals_underWhatCannotBeFlown_sayWhy() {
    QFETCH(double, windEast);
    QFETCH(double, airspeed);
    QFETCH(double, radius);
    QFETCH(double, x);
    QFETCH(QString, says);
    const geo::Pose to{x, 500.0, 1.0};
    const air::Wind wind{windEast, 0.0};
    for (const Result<WindPath>& path : {shortestTime({}, to, radius, airspeed, wind), leastLoss({}, to, radius, airspeed, wind, kLoss)}) {
      QVERIFY(!path);
      QCOMPARE(path.error().code, Errc::OutOfRange);
      QVERIFY2(QString::fromStdString(path.error().what).contains(says), path.error().what.c_str());
    }
    QVERIFY_EXCEPTION_THROWN(static_cast<void>(windWord({}, to, radius, airspeed, wind, Word::LSL)), LogicError);
    const bool isWindRefused = says.contains("airspeed");
    QCOMPARE(canConnect(airspeed, wind), !isWindRefused);
  }

  void headings_underWind_makeGoodTheCourse() {
    RandomCases random(1.0, 0.99);
    for (int i = 0; i < 10000; ++i) {
      const Case c = random();
      const double course = random.angle();
      const std::optional<double> heading = airHeadingFor(course, kAirspeed, c.wind);
      QVERIFY(heading && *heading >= 0.0 && *heading < 2.0 * kPi);
      const double east = kAirspeed * std::cos(*heading) + c.wind.east;
      const double north = kAirspeed * std::sin(*heading) + c.wind.north;
      QVERIFY(std::abs(std::remainder(std::atan2(north, east) - course, 2.0 * kPi)) < 1e-9);
      QVERIFY(std::abs(std::remainder(*courseFor(*heading, kAirspeed, c.wind) - course, 2.0 * kPi)) < 1e-9);
    }
    // north with 10 m/s towards the east at 20 m/s: 30 degrees into the wind
    QVERIFY(std::abs(*airHeadingFor(kPi / 2.0, 20.0, {10.0, 0.0}) - kPi * 2.0 / 3.0) < 1e-12);
    QVERIFY(!airHeadingFor(kPi / 2.0, 20.0, {20.5, 0.0}));  // across and too strong
    QVERIFY(!airHeadingFor(kPi, 20.0, {20.0, 0.0}));        // stands still
    QVERIFY(airHeadingFor(0.0, 20.0, {30.0, 5.0}));         // carried along
    QVERIFY(!airHeadingFor(0.0, 20.0, {NAN, 5.0}));
    QVERIFY(!airHeadingFor(NAN, 20.0, {3.0, 5.0}));
    QVERIFY(!airHeadingFor(0.0, 0.0, {3.0, 0.0}));
    QVERIFY(!courseFor(kPi / 2.0, 0.0, {0.0, 0.0}));
    QVERIFY(!courseFor(NAN, 20.0, {0.0, 0.0}));
  }
};

QTEST_APPLESS_MAIN(TestWindConnection)
#include "tst_wind_connection.moc"
