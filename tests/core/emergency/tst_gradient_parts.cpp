// The parts of the gradient-guided search of [3]: closed set, cost terms, slopes, Dubins ways, holding areas; against closed forms and brute force.
#include "core/emergency/dubins_ways.h"
#include "core/emergency/gradient_cost.h"
#include "core/emergency/holding_areas.h"
#include "core/emergency/prism_set.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/dubins.h"
#include "core/risk/joined_areas.h"
#include "tests/support/landing_cases.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace vp;
using namespace vp::emergency;

namespace {

constexpr double kPi = Angle::kPi;

class Random {
public:
  double between(double a, double b) { return a + (b - a) * static_cast<double>(engine_() >> 11) * 0x1.0p-53; }
  geo::Pose pose(double reach) { return {between(-reach, reach), between(-reach, reach), between(-kPi, kPi)}; }

private:
  std::mt19937_64 engine_{642};
};

/// The paper's Cessna of [1] with a steepest descent.
mission::Mission missionWith(double steepest_deg, const std::vector<air::WindLayer>& wind = {}) {
  mission::Mission mission = test::landingMission();
  mission.aircraft.steepestDescent = Angle::degrees(steepest_deg);
  mission.wind = wind;
  return mission;
}

LandingRequest flatRequest(const mission::Mission& mission) {
  return test::landingRequest(mission, {test::placedSite("ZZZZ/09", {0.0, 0.0, 0.0}, 0.0)}, test::flatGrid(), {0.0, 0.0, 0.0}, 1000.0);
}

bool isNear(double value, double expected, double within) {
  if (std::abs(value - expected) <= within) {
    return true;
  }
  qWarning("%.9g instead of %.9g", value, expected);
  return false;
}

std::vector<geo::Point> rectangle(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

mission::PopulationArea areaOf(const geo::LocalFrame& frame, const std::vector<geo::Point>& ring, double perSquareMetre) {
  mission::PopulationArea area;
  area.name = "feature";
  area.perSquareKm = 1e6 * perSquareMetre;
  area.parts.emplace_back();
  for (const geo::Point& corner : ring) {
    area.parts.back().outline.push_back(frame.toLatLon(corner));
  }
  return area;
}

}  // namespace

class TestGradientParts : public QObject {
  Q_OBJECT

private slots:
  void hexagon_hasItsCorners() {
    const double apothem = std::sqrt(0.75);
    QVERIFY(isInHexagon({0.0, 0.999}, {0.0, 0.0}, 1.0) && !isInHexagon({0.0, 1.001}, {0.0, 0.0}, 1.0));
    QVERIFY(isInHexagon({0.999 * apothem, 0.0}, {0.0, 0.0}, 1.0) && !isInHexagon({1.001 * apothem, 0.0}, {0.0, 0.0}, 1.0));
    QVERIFY(isInHexagon({0.999 * apothem, 0.499}, {0.0, 0.0}, 1.0) && !isInHexagon({0.999 * apothem, 0.502}, {0.0, 0.0}, 1.0));
    Random random;
    int inside = 0;
    constexpr int kCount = 100000;
    for (int i = 0; i < kCount; ++i) {
      inside += isInHexagon({random.between(-1.0, 1.0) + 5.0, random.between(-1.0, 1.0) - 3.0}, {5.0, -3.0}, 1.0) ? 1 : 0;
    }
    QVERIFY(isNear(4.0 * inside / kCount, 1.5 * std::sqrt(3.0), 0.02));  // its area
  }

  void prisms_holdPlaceAltitudeAndCourse() {
    PrismSet set(400.0, Angle::degrees(5.0).radians(), 300.0);
    QVERIFY(set.add({0.0, 0.0, 1.0}, 1000.0, 200.0, 1.0));
    QVERIFY(!set.add({50.0, 50.0, 1.0}, 1000.0, 200.0, 1.0));
    QVERIFY(!set.add({50.0, 50.0, 1.0 + 2.0 * kPi}, 1100.0, 200.0, 1.0));  // the same course, the same layer
    QVERIFY(set.add({50.0, 50.0, 1.2}, 1000.0, 200.0, 1.0));
    QVERIFY(set.add({50.0, 50.0, 1.0}, 1300.0, 200.0, 1.0));
    QVERIFY(set.add({0.0, 201.0, 1.0}, 1000.0, 200.0, 1.0));
    QVERIFY(!set.add({0.0, 299.0, 1.0}, 1000.0, 10.0, 1.0));  // within the hexagon of the one before, whatever its own
    QCOMPARE(set.size(), std::size_t{4});
    QVERIFY(!set.add({0.0, 0.0, 1.0}, 1000.0, 200.0, 1.1));  // known at less risk
    QVERIFY(set.add({0.0, 0.0, 1.0}, 1000.0, 200.0, 0.9));   // a better way there
    QVERIFY(!set.add({0.0, 0.0, 1.0}, 1000.0, 200.0, 1.0));
  }

  void leastLength_isTheBestOverAllFinalCourses() {
    Random random;
    GradientTask task{{}, 2000.0, {300.0, -200.0, 0.3}, 100.0, 500.0, 0.08};
    const GradientCost cost(task, {});
    int outside = 0;
    int longer = 0;
    for (int i = 0; i < 10000; ++i) {
      const geo::Pose pose = random.pose(4000.0);
      double best = 1e300;
      for (int k = 0; k < 72; ++k) {
        const flight::DubinsPath path = flight::shortestDubins(pose, {task.goal.x, task.goal.y, 2.0 * kPi * k / 72.0}, task.radius);
        best = std::min(best, path.length());
      }
      const double least = cost.leastLength(pose);
      QVERIFY2(least <= best + 1e-6, qPrintable(QString::number(i)));
      const double ahead = (task.goal.x - pose.x) * std::cos(pose.heading) + (task.goal.y - pose.y) * std::sin(pose.heading);
      const double aside = std::abs((task.goal.y - pose.y) * std::cos(pose.heading) - (task.goal.x - pose.x) * std::sin(pose.heading));
      if (std::hypot(ahead, aside - task.radius) > task.radius) {  // else only a bound
        ++outside;
        QVERIFY2(best - least < 5.0, qPrintable(QString::number(best - least)));  // final courses every 5 degrees
      }
      longer += cost.guidingLength(pose) > best + 1.0 ? 1 : 0;
    }
    QVERIFY(outside > 8000);
    QVERIFY(longer > 5000);  // (24) is no lower bound: why it does not prune
    // abeam and far: by R, as the turn comes nearer to the goal by that
    const geo::Pose abeam{task.goal.x, task.goal.y - 20000.0, 0.0};
    QVERIFY(isNear(cost.guidingLength(abeam) - cost.leastLength(abeam), 500.0, 10.0));
  }

  void terms_lieBetweenZeroAndOne() {
    Random random;
    for (int i = 0; i < 10000; ++i) {
      const GradientTask task{random.pose(9000.0),           random.between(300.0, 3000.0), random.pose(1000.0), 100.0,
                              random.between(100.0, 1000.0), random.between(0.03, 0.3)};
      const GradientCost cost(task, {});
      const geo::Pose pose = random.pose(20000.0);
      const double guiding = cost.guidingLength(pose);
      const auto isShare = [](double value) { return value >= 0.0 && value <= 1.0; };
      QVERIFY(isShare(cost.descent(random.between(0.0, 30000.0), guiding)) && isShare(cost.distance(guiding)) && isShare(cost.share(guiding)) &&
              isShare(cost.course(pose.point())));
      double course = 0.0;
      QVERIFY(isShare(cost.guide(pose, random.between(0.0, 30000.0), course)));
      QCOMPARE(course, cost.course(pose.point()));
      if (cost.beyond(pose.point()) <= 0.0) {
        QCOMPARE(course, 0.0);
      }
    }
  }

  void terms_haveTheirKnownValues() {
    // goal at the origin, landing to the east; 1000 m to lose at 0.1: d_opt is 10 km
    const GradientTask task{{-4000.0, 0.0, 0.0}, 1100.0, {0.0, 0.0, 0.0}, 100.0, 500.0, 0.1};
    const GradientCost cost(task, {});
    QCOMPARE(cost.optimalLength(), 10000.0);
    QCOMPARE(cost.guidingLength(task.start), 4000.0);
    QCOMPARE(cost.outerRadius(), 7000.0);      // (35)
    QCOMPARE(cost.descent(0.0, 4000.0), 0.6);  // (27): 6 of 10 km too short
    QCOMPARE(cost.descent(6000.0, 4000.0), 0.0);
    QCOMPARE(cost.distance(4000.0), 0.4);  // (34)
    QCOMPARE(cost.share(8000.0), 0.0);     // (36)
    QCOMPARE(cost.share(926.0), 1.0);
    QVERIFY(isNear(cost.share(0.5 * (7000.0 + 926.0)), 0.5, 1e-12));
    QVERIFY(isNear(cost.course({5000.0, 0.0}), 1.0, 1e-12));  // (39): greatest half-way along the extended runway
    QCOMPARE(cost.course({-5000.0, 0.0}), 0.0);
    QCOMPARE(cost.course({0.0, 3000.0}), 0.0);  // abeam: 90 degrees to turn
    for (const double value : {0.0, 1e-5, 0.3, 0.5, 0.9}) {
      const GradientWeights weights = GradientCost::weights(value);
      QVERIFY(isNear(weights.descent + weights.distance + weights.course + weights.people, 1.0, 1e-12));
    }
    QCOMPARE(GradientCost::weights(0.5).course, 0.2);
    QCOMPARE(GradientCost::weights(0.3).people, 0.4);
    QCOMPARE(GradientCost::weights(0.0).distance, 0.4);
  }

  void slopes_inStillAir_areHalfWay() {
    const LandingRequest request = flatRequest(missionWith(8.0));
    DescentFlight flight(*request.world, *request.mission);
    const DescentRange range = flight.rangeOf(1.0, {flight::Turn::Straight, 0.0, 100.0}, 500.0);
    QVERIFY(isNear(range.least, request.world->glide.straightLoss(), 1e-15));
    QVERIFY(isNear(range.most, std::tan(Angle::degrees(8.0).radians()), 1e-15));
    QVERIFY(isNear(range.at(0.5), 0.5 * (range.least + range.most), 1e-15));  // (5)
    // a turn that loses more than the steepest descent loses what it must
    const DescentRange tight = flight.rangeOf(1.0, {flight::Turn::Left, request.world->glide.minRadius(), 50.0}, 500.0);
    QVERIFY(tight.least > range.most && tight.most == tight.least);
    // without a steepest descent there is no choice
    mission::Mission without = test::landingMission();
    const LandingRequest plain = flatRequest(without);
    DescentFlight only(*plain.world, *plain.mission);
    const DescentRange one = only.rangeOf(1.0, {flight::Turn::Straight, 0.0, 100.0}, 500.0);
    QCOMPARE(one.most, one.least);
  }

  void slopes_inWind_areWhatTheTriangleGives() {
    Random random;
    for (int i = 0; i < 300; ++i) {
      const double from = random.between(0.0, 360.0);
      const double speed = random.between(0.5, 12.0);
      const LandingRequest request = flatRequest(missionWith(9.0, {{geo::HeightMsl(), {from, 0.0, speed, speed}}}));
      DescentFlight flight(*request.world, *request.mission);
      const double course = random.between(-kPi, kPi);
      const DescentRange range = flight.rangeOf(course, {flight::Turn::Straight, 0.0, 100.0}, 500.0);
      const double towards = Angle::degrees(270.0 - from).radians();
      const double along = speed * std::cos(towards - course);
      const double across = speed * std::sin(towards - course);
      const double airspeed = request.mission->aircraft.bestGlideSpeed.si();
      const double gamma = std::atan(aircraft::GlideModel(request.mission->aircraft).straightLoss());
      const double ground = std::sqrt(std::pow(airspeed * std::cos(gamma), 2) - across * across) + along;
      const double least = airspeed * std::sin(gamma) / ground;
      QVERIFY(range.least >= least - 1e-12 && range.least <= 1.0001 * least);  // an upper bound, and a near one
      // no more than the aircraft can with all of the wind that is along its course behind it, and no less than the glide
      const double most = std::tan(Angle::degrees(9.0).radians()) * airspeed / (airspeed + along);
      QVERIFY(isNear(range.most, std::max(range.least, most), 1e-9));
    }
  }

  void descents_endWhereAsked() {
    Random random;
    for (const double wind : {0.0, 6.0}) {
      const std::vector<air::WindLayer> layers =
          wind > 0.0 ? std::vector<air::WindLayer>{{geo::HeightMsl(), {300.0, 10.0, 3.0, wind}}} : std::vector<air::WindLayer>{};
      const LandingRequest request = flatRequest(missionWith(7.0, layers));
      DescentFlight flight(*request.world, *request.mission);
      const double radius = request.world->glide.glideRadii().front();
      int exact = 0;
      for (int i = 0; i < 2000; ++i) {
        const geo::Pose from = random.pose(4000.0);
        const std::vector<flight::Piece> pieces{{flight::Turn::Left, radius, random.between(1.0, 900.0)},
                                                {flight::Turn::Straight, 0.0, random.between(1.0, 5000.0)},
                                                {flight::Turn::Right, radius, random.between(1.0, 900.0)}};
        const double altitude = 2000.0;
        const double end = random.between(1200.0, 2000.0);
        const std::optional<Descent> descent = flight.descendTo(from, altitude, pieces, end);
        geo::Pose pose = from;
        const double highest = flight.fly(pose, altitude, pieces, 0.0, nullptr);
        QCOMPARE(descent.has_value(), highest >= end);
        if (!descent) {
          continue;
        }
        const double reached = descent->legs.back().endAltitude;
        QVERIFY(reached >= end && isNear(reached, end + descent->surplus, 1e-9));
        QVERIFY(descent->share >= 0.0 && descent->share <= 1.0);
        QVERIFY(descent->share == 1.0 || descent->surplus < 1e-3);
        exact += descent->surplus < 1e-3 ? 1 : 0;
        // the legs are the pieces
        double length = 0.0;
        for (const mission::LandingLeg& leg : descent->legs) {
          length += leg.piece.length;
        }
        QVERIFY(isNear(length, pieces[0].length + pieces[1].length + pieces[2].length, 1e-3));
      }
      QVERIFY(exact > 200);
    }
  }

  void ways_endAtTheGoalAtItsHeight() {
    Random random;
    const LandingRequest request = flatRequest(missionWith(6.0));
    DescentFlight flight(*request.world, *request.mission);
    const geo::Pose goal{500.0, -300.0, 2.0};
    DubinsWays ways(flight, goal, 200.0, 300.0);
    int found = 0;
    for (int i = 0; i < 3000; ++i) {
      const geo::Pose from = random.pose(3000.0);
      const double altitude = random.between(250.0, 1500.0);
      std::vector<Pieces> all;
      for (std::size_t type = 0; type < kDubinsTypes; ++type) {
        if (std::optional<Pieces> way = ways.fitted(from, altitude, type)) {
          all.push_back(*way);
        }
      }
      if (i % 10 == 0) {
        ways.sTurns(from, altitude, all);
      }
      for (const Pieces& way : all) {
        ++found;
        geo::Pose end = from;
        for (const flight::Piece& piece : way) {
          end = flight::endOf(end, piece);
        }
        QVERIFY(geo::distance(end.point(), goal.point()) < 1e-3 && std::abs(wrapPi(end.heading - goal.heading)) < 1e-6);
        const std::optional<Descent> descent = flight.descendTo(from, altitude, way, 200.0);
        QVERIFY(descent && descent->surplus < 1e-3);
      }
    }
    QVERIFY(found > 2000);
  }

  void roomiestPlaces_areKnown() {
    const HoldingArea square = roomiestPlace({rectangle(1000.0, -500.0, 2000.0, 2000.0)});
    QVERIFY(isNear(square.centre.x, 2000.0, 5.0) && isNear(square.centre.y, 500.0, 5.0) && isNear(square.room, 1000.0, 5.0));
    // an L with arms 1000 m wide: the circle that touches both outer walls and the inner corner, r = sqrt(2) (1000 - r)
    const double inCorner = 1000.0 * std::sqrt(2.0) / (1.0 + std::sqrt(2.0));
    const HoldingArea bent = roomiestPlace({{{0, 0}, {3000, 0}, {3000, 1000}, {1000, 1000}, {1000, 3000}, {0, 3000}}});
    QVERIFY(isNear(bent.room, inCorner, 6.0));
    // a hole in the middle leaves the corners
    const HoldingArea holed = roomiestPlace({rectangle(0.0, 0.0, 4000.0, 4000.0), rectangle(1500.0, 1500.0, 1000.0, 1000.0)});
    QVERIFY(isNear(holed.room, 1500.0 * std::sqrt(2.0) / (1.0 + std::sqrt(2.0)), 8.0));
    // an equilateral triangle: a third of its height
    const HoldingArea triangle = roomiestPlace({{{0, 0}, {1000, 0}, {500, 1000 * std::sqrt(0.75)}}});
    QVERIFY(isNear(triangle.room, 1000.0 * std::sqrt(0.75) / 3.0, 2.0));
  }

  void smallAreas_areJoined() {
    const geo::LocalFrame frame(test::kLandingOrigin);
    std::vector<mission::PopulationArea> areas;
    for (int i = 0; i < 10; ++i) {
      areas.push_back(areaOf(frame, rectangle(1000.0 * i, 0.0, 1000.0, 1000.0), i < 5 ? 1.0 : 3.0));
    }
    areas.push_back(areaOf(frame, rectangle(0.0, 9000.0, 500.0, 500.0), 7.0));  // alone and too small
    const Result<risk::Population> population = risk::Population::from(areas, frame);
    double people = 0.0;
    double ground = 0.0;
    const std::vector<risk::Population::Polygon> joined = risk::joinedAreas(*population, 1.9e6, HoldingAreas::kEverywhere);
    for (const risk::Population::Polygon& polygon : joined) {
      QVERIFY(polygon.area >= 1.9e6);
      people += polygon.area * polygon.density;
      ground += polygon.area;
    }
    QVERIFY(joined.size() >= 3 && joined.size() <= 5);
    QVERIFY(isNear(ground, 10e6, 10.0) && isNear(people, 20e6, 20.0));
    // like goes to like: most of them are of one density still
    QVERIFY(std::count_if(joined.begin(), joined.end(), [](const auto& one) { return std::abs(one.density - 1.0) < 1e-6; }) >= 1);
    QVERIFY(std::count_if(joined.begin(), joined.end(), [](const auto& one) { return std::abs(one.density - 3.0) < 1e-6; }) >= 1);
    const HoldingAreas holds(*population, 450.0);
    QCOMPARE(holds.all().size(), std::size_t{10});  // each square has room for 500 m
    QCOMPARE(HoldingAreas(*population, 450.0, geo::Box{-500.0, -500.0, 1500.0, 1500.0}).all().size(), std::size_t{2});
    QVERIFY(HoldingAreas(*population, 600.0, HoldingAreas::kEverywhere, [] { return true; }).all().empty());
    QVERIFY(HoldingAreas(*population, 600.0).all().empty());  // two squares side by side have no more
  }

  void holds_areRankedByUtility() {
    // (61): density, distance, room and risk each against the greatest
    const std::vector<HoldingArea> areas{{{1000.0, 0.0}, 2000.0, 4.0}, {{4000.0, 0.0}, 1000.0, 1.0}, {{2000.0, 0.0}, 1000.0, 2.0}};
    const std::vector<RankedHold> ranked = rankHolds(areas, {0.0, 0.0}, {0.4, 0.1, 0.1});
    QVERIFY(isNear(ranked[0].utility, 0.5 + 0.5 + 0.5 + 0.75, 1e-12) && ranked[0].area.density == 2.0);
    QVERIFY(isNear(ranked[1].utility, 0.75 + 0.0 + 0.5 + 0.75, 1e-12) && ranked[1].area.density == 1.0);
    QVERIFY(isNear(ranked[2].utility, 0.0 + 0.75 + 1.0 + 0.0, 1e-12) && ranked[2].area.density == 4.0);
    QVERIFY(rankHolds({}, {0.0, 0.0}, {}).empty());
  }
};

QTEST_APPLESS_MAIN(TestGradientParts)
#include "tst_gradient_parts.moc"
