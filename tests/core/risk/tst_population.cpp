// People under a leg: known answers, random polygons against plain sampling, and what is refused.
#include "core/flight/curve_sampling.h"
#include "core/risk/descent_risk.h"
#include "core/risk/people_under.h"
#include "core/risk/population.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace vp;
using flight::Piece;
using flight::Turn;

namespace {

constexpr double kPi = Angle::kPi;
const geo::LocalFrame kFrame({40.0, -73.0});
using Ring = std::vector<geo::Point>;

std::vector<geo::LatLon> onEarth(const Ring& ring) {
  std::vector<geo::LatLon> places;
  for (const geo::Point& point : ring) {
    places.push_back(kFrame.toLatLon(point));
  }
  return places;
}

/// An area of so many people per m^2.
mission::PopulationArea areaOf(const Ring& outline, double density, const std::vector<Ring>& holes = {}) {
  mission::PopulationArea area;
  area.name = "feature 7 (Farmingdale)";
  area.source = "people.geojson";
  area.perSquareKm = density * 1e6;
  area.parts.push_back({onEarth(outline), {}});
  for (const Ring& hole : holes) {
    area.parts.back().holes.push_back(onEarth(hole));
  }
  return area;
}

Ring square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

risk::Population populationOf(const std::vector<mission::PopulationArea>& areas) {
  Result<risk::Population> population = risk::Population::from(areas, kFrame);
  return std::move(population.value());
}

Piece straight(double length) {
  return {Turn::Straight, 0.0, length};
}

bool isNear(double value, double expected, double within) {
  if (std::abs(value - expected) <= within) {
    return true;
  }
  qWarning("%.9g instead of %.9g", value, expected);
  return false;
}

/// Density along a leg by plain sampling.
double sampled(const risk::Population& population, const geo::Pose& from, const Piece& piece, int steps) {
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    sum += population.densityAt(flight::poseAfter(from, piece, piece.length * (i + 0.5) / steps).point());
  }
  return sum * piece.length / steps;
}

class Random {
public:
  double between(double a, double b) { return a + (b - a) * static_cast<double>(engine_() >> 11) * 0x1.0p-53; }

private:
  std::mt19937_64 engine_{20250913};
};

/// A star of many corners around a place: never crosses itself.
Ring star(Random& random, geo::Point centre, double least, double most, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * kPi * i / corners;
    const double reach = random.between(least, most);
    ring.push_back({centre.x + reach * std::cos(angle), centre.y + reach * std::sin(angle)});
  }
  return ring;
}

}  // namespace

class TestPopulation : public QObject {
  Q_OBJECT

private slots:
  void square_crossed_gives_densityTimesWidth() {
    const risk::Population one = populationOf({areaOf(square(0, 0, 1000), 0.004)});
    QVERIFY(isNear(one.integralAlong({-500, 500, 0}, straight(3000)), 4.0, 1e-8));
    QVERIFY(isNear(one.integralAlong({-500, 500, 0}, straight(1000)), 2.0, 1e-8));                             // ends inside
    QVERIFY(isNear(one.integralAlong({200, 500, 0}, straight(100)), 0.4, 1e-8));                               // never leaves
    QVERIFY(isNear(one.integralAlong({-500, -1, 0}, straight(3000)), 0.0, 1e-12));                             // passes by
    QVERIFY(isNear(one.integralAlong({0, 0, kPi / 4}, straight(2000)), 0.004 * 1000 * std::sqrt(2.0), 1e-7));  // from corner to corner
    QVERIFY(isNear(one.densityAt({500, 500}), 0.004, 1e-12));
  }

  void arc_throughDisc_isClosedForm() {
    // places of a circle of radius R at the distance r from one of its points lie 2 asin(r / 2R) from it
    constexpr double kRadius = 800.0;
    constexpr double kDisc = 500.0;
    Ring disc;
    constexpr int kCorners = 20000;
    for (int i = 0; i < kCorners; ++i) {
      disc.push_back({kDisc * std::cos(2 * kPi * i / kCorners), kDisc * std::sin(2 * kPi * i / kCorners)});
    }
    const risk::Population one = populationOf({areaOf(disc, 1.0)});
    const double expected = 2.0 * kRadius * 2.0 * std::asin(kDisc / (2.0 * kRadius));
    for (const Turn turn : {Turn::Left, Turn::Right}) {
      const double sign = turn == Turn::Left ? 1.0 : -1.0;
      const Piece circle{turn, kRadius, 2.0 * kPi * kRadius};
      // begins opposite the disc's middle, and passes it after half a circle
      const geo::Pose start{0.0, sign * 2.0 * kRadius, kPi};
      QVERIFY(isNear(one.integralAlong(start, circle), expected, 1e-3));
      QVERIFY(isNear(one.integralAlong(start, {turn, kRadius, 6.0 * kPi * kRadius}), 3.0 * expected, 3e-3));  // three circles
      QVERIFY(isNear(one.integralAlong(start, {turn, kRadius, kPi * kRadius}), 0.5 * expected, 1e-3));
    }
  }

  void border_belongsHalfToEachSide() {
    const risk::Population two = populationOf({areaOf(square(0, 0, 1000), 2.0), areaOf(square(1000, 0, 1000), 4.0)});
    QVERIFY(isNear(two.integralAlong({1000, -500, kPi / 2}, straight(2000)), 3000.0, 1e-3));   // between: the mean
    QVERIFY(isNear(two.integralAlong({1000, 1500, -kPi / 2}, straight(2000)), 3000.0, 1e-3));  // and the other way
    QVERIFY(isNear(two.integralAlong({0, -500, kPi / 2}, straight(2000)), 1000.0, 1e-3));      // the outer border: half
    QVERIFY(isNear(two.integralAlong({-500, 500, 0}, straight(3000)), 6000.0, 1e-6));          // across: no gap, no overlap
    QVERIFY(isNear(two.integralAlong({-1000, -1000, -kPi / 4}, straight(3000)), 0.0, 1e-9));
    QVERIFY(isNear(two.integralAlong({-1000, 1000, -kPi / 4}, straight(2000 * std::sqrt(2.0))), 0.0, 1e-3));  // touches a corner
  }

  void hole_isNotCounted() {
    const risk::Population one = populationOf({areaOf(square(0, 0, 1000), 1.0, {square(250, 250, 500)})});
    QVERIFY(isNear(one.integralAlong({-500, 500, 0}, straight(2000)), 500.0, 1e-6));
    QVERIFY(isNear(one.integralAlong({-500, 100, 0}, straight(2000)), 1000.0, 1e-6));
    QCOMPARE(one.densityAt({500, 500}), 0.0);
  }

  void overlaps_addUp() {
    const risk::Population two = populationOf({areaOf(square(0, 0, 1000), 1.0), areaOf(square(500, 0, 1000), 2.0)});
    QVERIFY(isNear(two.integralAlong({-500, 500, 0}, straight(3000)), 1000.0 + 2000.0, 1e-6));
    QVERIFY(isNear(two.densityAt({750, 500}), 3.0, 1e-12));
  }

  void people_areSpreadOverAllParts() {
    mission::PopulationArea area = areaOf(square(0, 0, 1000), 0.0, {square(250, 250, 500)});
    area.parts.push_back({onEarth(square(5000, 0, 500)), {}});
    area.perSquareKm.reset();
    area.people = 5000.0;  // over 0.75 and 0.25 km^2
    const risk::Population population = populationOf({area});
    QVERIFY(isNear(population.densityAt({5100, 100}), 0.005, 1e-9));
    QVERIFY(isNear(population.densityAt({100, 100}), 0.005, 1e-9));
    QVERIFY(isNear(population.greatestDensity(), 0.005, 1e-9));
  }

  void random_legs_agreeWithSampling() {
    Random random;
    std::vector<mission::PopulationArea> areas;
    for (int i = 0; i < 12; ++i) {
      const geo::Point centre{random.between(-4000, 4000), random.between(-4000, 4000)};
      areas.push_back(areaOf(star(random, centre, 600, 1800, 9 + 7 * i), random.between(0.1, 3.0), {star(random, centre, 100, 500, 8)}));
    }
    const risk::Population population = populationOf(areas);
    constexpr int kSteps = 2000;
    for (int i = 0; i < 10000; ++i) {
      const geo::Pose from{random.between(-5000, 5000), random.between(-5000, 5000), random.between(-4, 4)};
      const int kind = i % 3 - 1;
      const double radius = kind == 0 ? 0.0 : random.between(50, 2000);
      const Piece piece{static_cast<Turn>(kind), radius, random.between(10, 4000)};
      const double exact = population.integralAlong(from, piece);
      // a sample is wrong by a step at most at each of some dozen borders; the densest place has no more than the sum of all
      const int steps = i % 100 == 0 ? 20 * kSteps : kSteps / 10;
      const double expected = sampled(population, from, piece, steps);
      QVERIFY2(std::abs(exact - expected) <= 40.0 * piece.length / steps * population.greatestDensity(), qPrintable(QString::number(i)));
      // and parts add up to the whole, at any place where it is cut
      const double cut = piece.length * random.between(0.1, 0.9);
      const double first = population.integralAlong(from, {piece.turn, piece.radius, cut});
      const double second = population.integralAlong(flight::poseAfter(from, piece, cut), {piece.turn, piece.radius, piece.length - cut});
      QVERIFY2(std::abs(first + second - exact) <= 1e-5, qPrintable(QString::number(i)));
    }
  }

  void legs_nearCorners_missNothing() {
    // aimed at corners and along sides of a grid of squares, where every place is a border of something: density is 1 everywhere inside
    std::vector<mission::PopulationArea> areas;
    for (int i = 0; i < 5; ++i) {
      for (int j = 0; j < 5; ++j) {
        areas.push_back(areaOf(square(1000.0 * i, 1000.0 * j, 1000.0), 1.0));
      }
    }
    const risk::Population grid = populationOf(areas);
    Random random;
    for (int i = 0; i < 10000; ++i) {
      const geo::Point from{1000.0 * (1 + i % 4), 1000.0 * (1 + (i / 4) % 4)};
      const geo::Point to{1000.0 * (1 + (i / 16) % 4), 1000.0 * (1 + (i / 64) % 4)};
      const double length = geo::distance(from, to);
      const double heading = std::atan2(to.y - from.y, to.x - from.x) + (i % 2 == 0 ? 0.0 : random.between(-1e-12, 1e-12));
      QVERIFY2(std::abs(grid.integralAlong({from.x, from.y, heading}, straight(length)) - length) < 0.05, qPrintable(QString::number(i)));
    }
  }

  void outliers_becomeThirdQuartile() {
    // densities 1 to 9 and 100: quartiles at 3.25 and 7.75 of ten values, fence 14.5
    std::vector<mission::PopulationArea> areas;
    for (int i = 0; i < 10; ++i) {
      areas.push_back(areaOf(square(2000.0 * i, 0, 1000), i == 9 ? 100.0 : i + 1.0));
    }
    const Result<risk::Population> lowered = risk::Population::from(areas, kFrame, risk::Outliers::ThirdQuartile);
    QVERIFY(isNear(lowered->densityAt({18500, 500}), 7.75, 1e-9));
    QVERIFY(isNear(lowered->densityAt({16500, 500}), 9.0, 1e-9));
    QVERIFY(isNear(lowered->greatestDensity(), 9.0, 1e-9));
    QVERIFY(isNear(populationOf(areas).greatestDensity(), 100.0, 1e-9));
  }

  void badAreas_areRefused_data() {
    QTest::addColumn<int>("number");
    QTest::addColumn<QString>("words");
    QTest::newRow("bow tie") << 0 << "sides of the polygon cross each other at";
    QTest::newRow("hole across the outline") << 1 << "sides of the polygon cross each other at";
    QTest::newRow("hole outside") << 2 << "a hole lies outside its polygon at";
    QTest::newRow("negative") << 3 << "is -12, which cannot be";
    QTest::newRow("no number") << 4 << "is nan, which cannot be";
    QTest::newRow("two corners") << 5 << "fewer than three different corners";
    QTest::newRow("no ground") << 6 << "covers no ground";
  }

  void badAreas_areRefused() {
    QFETCH(int, number);
    QFETCH(QString, words);
    mission::PopulationArea area = areaOf(square(0, 0, 1000), 1.0);
    switch (number) {
      case 0:
        area = areaOf({{0, 0}, {1000, 1000}, {1000, 0}, {0, 1000}}, 1.0);
        break;
      case 1:
        area = areaOf(square(0, 0, 1000), 1.0, {square(800, 300, 500)});
        break;
      case 2:
        area = areaOf(square(0, 0, 1000), 1.0, {square(2000, 2000, 500)});
        break;
      case 3:
        area.perSquareKm = -12.0;
        break;
      case 4:
        area.perSquareKm.reset();
        area.people = std::nan("");
        break;
      case 5:
        area = areaOf({{0, 0}, {1000, 0}, {0, 0}}, 1.0);
        break;
      default:
        area.parts.clear();
    }
    const Result<risk::Population> population = risk::Population::from({area}, kFrame);
    QVERIFY(!population);
    const QString message = QString::fromStdString(population.error().message());
    QVERIFY2(message.startsWith("people.geojson: feature 7 (Farmingdale): ") && message.contains(words), qPrintable(message));
    QVERIFY2(message.contains("correct") || message.contains("draw") || message.contains("make"), qPrintable(message));  // the remedy
  }

  void ringsThatTouchThemselves_areNotRefused() {
    // two squares that meet in one corner, drawn as one ring: touches, crosses nothing
    const risk::Population one =
        populationOf({areaOf({{0, 0}, {500, 0}, {500, 500}, {1000, 500}, {1000, 1000}, {500, 1000}, {500, 500}, {0, 500}}, 1.0)});
    QVERIFY(isNear(one.integralAlong({-100, 250, 0}, straight(2000)), 500.0, 1e-6));
    QVERIFY(isNear(one.integralAlong({-100, 750, 0}, straight(2000)), 500.0, 1e-6));
  }

  void peopleUnder_weighsByAltitude() {
    const auto population = std::make_shared<const risk::Population>(populationOf({areaOf(square(0, -5000, 10000), 0.001)}));
    const risk::PeopleUnder people(population, 40.0, 1500.0);
    constexpr double kPerMetre = 0.001 * risk::PeopleUnder::kGroundAtRisk / 40.0;
    const geo::Pose from{1000, 0, 0};
    QVERIFY(isNear(people.of(from, straight(4000), 750.0, 750.0), 0.5 * 4000 * kPerMetre, 1e-6));
    QVERIFY(isNear(people.of(from, straight(4000), 1500.0, 0.0), 0.5 * 4000 * kPerMetre, 1e-6));
    QVERIFY(isNear(people.of(from, straight(4000), 3000.0, 0.0), 0.5 * 2000 * kPerMetre, 1e-6));  // its second half alone
    QVERIFY(isNear(people.of(from, straight(4000), 0.0, 3000.0), 0.5 * 2000 * kPerMetre, 1e-6));
    QCOMPARE(people.of(from, straight(4000), 1600.0, 1500.0), 0.0);
    QCOMPARE(people.of({-9000, 0, 0}, straight(4000), 100.0, 100.0), 0.0);
    const double first = people.of(from, straight(1234), 1700.0, 1300.0);
    const double second = people.of({2234, 0, 0}, straight(2000), 1300.0, 1300.0 - 400.0 / 1234.0 * 2000.0);
    QVERIFY(isNear(people.of(from, straight(3234), 1700.0, 1300.0 - 400.0 / 1234.0 * 2000.0), first + second, 1e-9));
  }

  void descentRisk_hasItsKnownValue() {
    // density the same everywhere: the integral of x (1 - x)^2 over its greatest value, 1/12 : 4/27, for any heights
    const auto even = std::make_shared<const risk::Population>(populationOf({areaOf(square(-30000, -30000, 60000), 0.002)}));
    for (const risk::DescentWindow& window :
         {risk::DescentWindow{1200.0, 150.0, 20.0, 0.077, 40.0}, risk::DescentWindow{900.0, 300.0, 300.0, 0.1, 25.0}}) {
      const risk::DescentRisk risk(even, window);
      const geo::Pose from{-5000.0, 100.0, 0.3};
      QVERIFY(isNear(risk.of(from, straight(risk.length()), window.top, window.goal), 9.0 / 16.0, 1e-9));
      // what lies above the window and below the goal adds nothing, and legs add up
      const double before = 2000.0;
      const double after = 1000.0;
      const Piece longer = straight(risk.length() + before + after);
      QVERIFY(isNear(risk.of(from, longer, window.top + before * window.slope, window.goal - after * window.slope), 9.0 / 16.0, 1e-9));
      const double middle = 0.5 * (window.top + window.goal);
      const Piece half{Turn::Left, 900.0, 0.5 * risk.length()};
      const double both = risk.of(from, half, window.top, middle) + risk.of(flight::endOf(from, half), half, middle, window.goal);
      QVERIFY(isNear(both, 9.0 / 16.0, 1e-9));
      QCOMPARE(risk.of(from, straight(500.0), window.top + 100.0, window.top), 0.0);
    }
    // half as dense under all of the way as at the densest place
    const auto uneven = std::make_shared<const risk::Population>(
        populationOf({areaOf(square(-30000, -30000, 60000), 0.001), areaOf(square(40000, 40000, 1000), 0.002)}));
    const risk::DescentRisk risk(uneven, {1200.0, 150.0, 20.0, 0.077, 40.0});
    QVERIFY(isNear(risk.of({0, 0, 0}, straight(risk.length()), 1200.0, 150.0), 0.5 * 9.0 / 16.0, 1e-9));
  }
};

QTEST_APPLESS_MAIN(TestPopulation)
#include "tst_population.moc"
