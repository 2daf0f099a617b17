// Dubins paths in wind against two judges that share no code with them: the equations of motion over ground, stepped by RK4,
// and a scan of flight times with the Dubins words of calm air to where the air brings the goal.
#include "core/flight/curve_sampling.h"
#include "tests/core/flight/wind_cases.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

using namespace vp;
using namespace vp::flight;

namespace {

QByteArray faultOf(const WindPath& path, const geo::Pose& goal) {
  const geo::Pose end = integrate(path);
  const double place = std::hypot(end.x - goal.x, end.y - goal.y);
  const double heading = std::abs(std::remainder(end.heading - goal.heading, 2.0 * kPi));
  const geo::Pose closed = endOf(toCurve(path), path.airspeed);
  const double closedPlace = std::hypot(closed.x - goal.x, closed.y - goal.y);
  bool isInRange = path.lengths[0] >= 0.0 && path.lengths[1] >= 0.0 && path.lengths[2] >= 0.0;
  const auto turns = turnsOf(path.word);
  for (std::size_t part = 0; part < 3; ++part) {
    isInRange = isInRange && (turns[part] == Turn::Straight || path.lengths[part] <= (2.0 * kPi + 1e-9) * path.radius);
  }
  if (place < 1e-6 && heading < 1e-9 && closedPlace < 1e-6 && isInRange) {
    return {};
  }
  return QStringLiteral("word %1: %2 m, %3 rad, closed form %4 m, parts %5 %6 %7")
      .arg(int(path.word))
      .arg(place)
      .arg(heading)
      .arg(closedPlace)
      .arg(path.lengths[0])
      .arg(path.lengths[1])
      .arg(path.lengths[2])
      .toUtf8();
}

/// Length of a word of three circles in calm air whose middle turn is at most half a circle: dubinsWord gives the other one.
std::optional<double> shortMiddle(const geo::Pose& from, const geo::Pose& to, double radius, Word word) {
  const double side = word == Word::LRL ? 1.0 : -1.0;
  const double x = to.x - from.x - side * radius * (std::sin(to.heading) - std::sin(from.heading));
  const double y = to.y - from.y + side * radius * (std::cos(to.heading) - std::cos(from.heading));
  const double apart = std::hypot(x, y);
  if (apart > 4.0 * radius) {
    return std::nullopt;
  }
  const double middle = 2.0 * std::asin(apart / (4.0 * radius));
  const double direction = std::atan2(y, x);
  const double first = wrapTwoPi(side * (direction - from.heading) + 0.5 * middle);
  const double last = wrapTwoPi(side * (to.heading - direction) + 0.5 * middle);
  return radius * (first + middle + last);
}

/// Lengths at which a way of this length to where the air then has the goal has it: found by steps, where the way changes steadily.
std::vector<double> scan(const Case& c, Word word, bool isShort, double step, double longest) {
  std::vector<double> found;
  std::optional<double> before;
  for (double length = 0.0; length < longest; length += step) {
    const double seconds = length / kAirspeed;
    const geo::Pose goal{c.to.x - c.wind.east * seconds, c.to.y - c.wind.north * seconds, c.to.heading};
    std::optional<double> excess;
    if (isShort) {
      excess = shortMiddle(c.from, goal, kRadius, word);
    } else if (const auto path = dubinsWord(c.from, goal, kRadius, word)) {
      excess = path->length();
    }
    if (excess) {
      *excess -= length;
      if (before && (*before > 0.0) != (*excess > 0.0) && std::abs(*before - *excess) < kRadius) {
        found.push_back(length);  // within the last step
      }
    }
    before = excess;
  }
  return found;
}

}  // namespace

class TestWindDubins : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { qInfo("seed %u", kSeed); }

  void words_underIntegration_endAtGoal_data() {
    QTest::addColumn<double>("reach");
    QTest::addColumn<int>("cases");
    QTest::newRow("one radius") << kRadius << 30000;
    QTest::newRow("five radii") << 5.0 * kRadius << 40000;
    QTest::newRow("fifty radii") << 50.0 * kRadius << 30000;
  }

  void words_underIntegration_endAtGoal() {
    QFETCH(double, reach);
    QFETCH(int, cases);
    RandomCases random(reach, 0.9);
    std::array<int, 6> found{};
    for (int i = 0; i < cases; ++i) {
      const Case c = random();
      for (const Word word : kWords) {
        for (const WindPath& path : windWord(c.from, c.to, kRadius, kAirspeed, c.wind, word)) {
          const QByteArray fault = faultOf(path, c.to);
          QVERIFY2(fault.isEmpty(), QByteArray::number(i) + ": " + fault);
          QCOMPARE(path.word, word);
          ++found[static_cast<std::size_t>(word)];
        }
      }
    }
    for (const Word word : kWords) {
      const bool isFar = reach > 10.0 * kRadius && (word == Word::RLR || word == Word::LRL);
      QVERIFY(found[static_cast<std::size_t>(word)] > (isFar ? cases / 50 : cases / 2));
    }
  }

  void words_underDegeneratePoses_endAtGoal_data() {
    QTest::addColumn<double>("ahead");
    QTest::addColumn<double>("left");
    QTest::addColumn<double>("turn");
    QTest::newRow("same pose") << 0.0 << 0.0 << 0.0;
    QTest::newRow("opposite headings") << 0.0 << 0.0 << kPi;
    QTest::newRow("straight ahead") << 1000.0 << 0.0 << 0.0;
    QTest::newRow("behind") << -1000.0 << 0.0 << 0.0;
    QTest::newRow("back") << 1000.0 << 0.0 << -kPi;
    QTest::newRow("half a circle") << 0.0 << 2.0 * kRadius << kPi;
    QTest::newRow("circles that touch") << 0.0 << -4.0 * kRadius << 0.0;
    QTest::newRow("four radii apart") << 4.0 * kRadius << 0.0 << 0.0;
    QTest::newRow("wound up") << 300.0 << 200.0 << 4.0 * kPi + 1.0;
    QTest::newRow("a little behind") << -1e-7 << 0.0 << 0.0;
    QTest::newRow("a little to the right") << 500.0 << 0.0 << -1e-8;
  }

  void words_underDegeneratePoses_endAtGoal() {
    QFETCH(double, ahead);
    QFETCH(double, left);
    QFETCH(double, turn);
    for (int heading = 0; heading < 8; ++heading) {
      const double h = heading * kPi / 4.0;
      const geo::Pose from{100.0, -50.0, h};
      const geo::Pose to{100.0 + ahead * std::cos(h) - left * std::sin(h), -50.0 + ahead * std::sin(h) + left * std::cos(h), h + turn};
      for (const double share : {0.0, 1e-15, 1e-9, 0.1, 0.5, 0.9, 0.999}) {
        for (int towards = 0; towards < 8; ++towards) {
          const double w = towards * kPi / 4.0;
          const air::Wind wind{share * kAirspeed * std::cos(w), share * kAirspeed * std::sin(w)};
          for (const Word word : kWords) {
            for (const WindPath& path : windWord(from, to, kRadius, kAirspeed, wind, word)) {
              const QByteArray fault = faultOf(path, to);
              QVERIFY2(fault.isEmpty(), QStringLiteral("heading %1, wind %2 towards %3: ").arg(h).arg(share).arg(w).toUtf8() + fault);
            }
          }
          const Result<WindPath> quickest = shortestTime(from, to, kRadius, kAirspeed, wind);
          QVERIFY(quickest);
          QVERIFY(quickest->length() >= std::hypot(ahead, left) / (1.0 + share) - 1e-6);
          QVERIFY(leastLoss(from, to, kRadius, kAirspeed, wind, kLoss));
        }
      }
    }
  }

  void words_underScanOfTimes_missNone() {
    RandomCases random(6.0 * kRadius, 0.8);
    const double step = 0.02 * kRadius;
    int crossings = 0;
    for (int i = 0; i < 300; ++i) {
      const Case c = random();
      const Result<WindPath> quickest = shortestTime(c.from, c.to, kRadius, kAirspeed, c.wind);
      QVERIFY(quickest);
      for (const Word word : kWords) {
        const WindPaths paths = windWord(c.from, c.to, kRadius, kAirspeed, c.wind, word);
        for (const bool isShort : {false, true}) {
          if (isShort && word != Word::RLR && word != Word::LRL) {
            continue;
          }
          for (const double length : scan(c, word, isShort, step, 60.0 * kRadius)) {
            ++crossings;
            const bool isKnown = std::any_of(paths.begin(), paths.end(), [&](const WindPath& path) {
              return path.length() <= length + 1e-6 && path.length() >= length - step - 1e-6;
            });
            QVERIFY2(isKnown, qPrintable(QString("case %1 word %2 near %3 m").arg(i).arg(int(word)).arg(length)));
            QVERIFY(quickest->length() <= length + 1e-6);
          }
        }
      }
    }
    QVERIFY2(crossings > 1500, qPrintable(QString::number(crossings)));
  }

  void words_underCalm_areDubins() {
    std::mt19937_64 engine(kSeed);
    std::uniform_real_distribution<double> place(-4.0, 4.0);
    for (int i = 0; i < 20000; ++i) {
      const geo::Pose a{place(engine), place(engine), place(engine)};
      const geo::Pose b{place(engine), place(engine), place(engine)};
      for (const Word word : kWords) {
        const auto known = dubinsWord(a, b, 1.0, word);
        const WindPaths paths = windWord(a, b, 1.0, kAirspeed, {}, word);
        QCOMPARE(!paths.empty(), known.has_value());
        QVERIFY(!known || std::any_of(paths.begin(), paths.end(), [&](const WindPath& path) {
          return std::abs(path.lengths[0] - known->lengths[0]) < 1e-7 && std::abs(path.length() - known->length()) < 1e-9;
        }));
      }
      const Result<WindPath> quickest = shortestTime(a, b, 1.0, kAirspeed, {});
      const Result<WindPath> least = leastLoss(a, b, 1.0, kAirspeed, {}, kLoss);
      QVERIFY(quickest && least);
      QVERIFY(std::abs(quickest->length() - shortestDubins(a, b, 1.0).length()) < 1e-9);
      QVERIFY(std::abs(lossOf(*least, kLoss) - lossOf(leastLossDubins(a, b, 1.0, kLoss), kLoss)) < 1e-9);
    }
  }

  void knownPaths_underWind_haveTheirTimes() {
    const Result<WindPath> upwind = shortestTime({0, 0, 0}, {1000, 0, 0}, 100.0, 25.0, {-15.0, 0.0});
    QVERIFY(upwind && std::abs(upwind->duration() - 100.0) < 1e-9);
    const Result<WindPath> downwind = shortestTime({0, 0, 0}, {1000, 0, 0}, 100.0, 25.0, {15.0, 0.0});
    QVERIFY(downwind && std::abs(downwind->duration() - 25.0) < 1e-9);
    // a full circle drifts by the wind times its time
    const double seconds = 2.0 * kPi * 100.0 / 25.0;
    const WindPaths circles = windWord({0, 0, 1}, {3.0 * seconds, 4.0 * seconds, 1}, 100.0, 25.0, {3.0, 4.0}, Word::LSL);
    QVERIFY(std::any_of(circles.begin(), circles.end(), [&](const WindPath& path) {
      return std::abs(path.duration() - seconds) < 1e-9 && path.straight() < 1e-6 && std::abs(path.turned() - path.length()) < 1e-6;
    }));
    // circles that overlap have no inner tangent
    QVERIFY(windWord({0, 0, 0}, {0, 50, 0}, 100.0, 25.0, {}, Word::LSR).empty());
  }

  void curve_underWind_carriesIt() {
    const air::Wind wind{5.0, -8.0};
    const Result<WindPath> path = shortestTime({10, 20, 1}, {900, -300, 4}, 100.0, 25.0, wind);
    QVERIFY(path);
    const Curve curve = toCurve(*path);
    QCOMPARE(curve.wind, wind);
    QVERIFY(std::abs(lengthOf(curve) - path->length()) < 1e-9);
    WindPath begin = *path;  // its first part and half of the second
    begin.lengths = {path->lengths[0], 0.5 * path->lengths[1], 0.0};
    const geo::Pose flown = integrate(begin);
    const geo::Pose along = poseAlong(curve, begin.length(), 25.0);
    QVERIFY(geo::distance(flown.point(), along.point()) < 1e-6);
  }
};

QTEST_APPLESS_MAIN(TestWindDubins)
#include "tst_wind_dubins.moc"
