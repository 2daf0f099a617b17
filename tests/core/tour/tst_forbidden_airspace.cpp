// The planner keeps the tour out of airspaces that the mission forbids: every plan that comes out is accepted by the checker.
#include "core/safety/airspace_crossing.h"
#include "core/safety/checker.h"
#include "core/tour/forbidden_airspace.h"
#include "core/tour/planner.h"
#include "core/tour/replan.h"
#include "tests/support/ring_mission.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace vp;
using Kind = mission::AirspaceLimit::Kind;

namespace {

constexpr std::uint64_t kSeed = 20261124;

std::uint64_t seed() {
  const QByteArray given = qgetenv("VOLPLANE_TEST_SEED");
  return given.isEmpty() ? kSeed : given.toULongLong();
}

tour::PlanInput ringInput(int targets) {
  tour::PlanInput input = test::mountainInput();
  for (int i = 0; i < targets; ++i) {
    const double angle = 2.0 * Angle::kPi * i / targets;
    const double radius = i % 2 == 0 ? 1900.0 : 1100.0;
    test::addTarget(input, "T" + std::to_string(i + 1), {radius * std::cos(angle), radius * std::sin(angle)});
  }
  return input;
}

mission::Airspace prism(const tour::PlanInput& input, const std::vector<geo::Point>& corners, mission::AirspaceLimit floor,
                        mission::AirspaceLimit ceiling) {
  mission::Airspace airspace{"ZONE", "R", floor, ceiling, {}};
  for (const geo::Point& corner : corners) {
    airspace.outline.push_back(input.frame.toLatLon(corner));
  }
  return airspace;
}

std::vector<geo::Point> box(double minX, double minY, double maxX, double maxY) {
  return {{minX, minY}, {maxX, minY}, {maxX, maxY}, {minX, maxY}};
}

void forbid(tour::PlanInput& input, std::vector<mission::Airspace> airspaces) {
  input.airspaces = std::move(airspaces);
  input.mission.airspace = {{"air.txt"}, {}, mission::AirspaceUse::Forbid};
}

/// What the checker says against a plan, airspaces included; empty if nothing.
std::string objections(const tour::PlanInput& input, const mission::Plan& plan) {
  const Result<safety::SafetyReport> report = safety::check({plan, *input.terrain, {std::string(64, '0')}}, Job{});
  if (!report) {
    return report.error().message();
  }
  std::string all;
  for (const safety::Finding& finding : report->findings) {
    if (finding.severity == safety::Severity::Violated || finding.severity == safety::Severity::Unknown) {
      all += finding.rule + ": " + finding.text + "\n";
    }
  }
  return all;
}

/// How high the tour is at its lowest and highest above a point's surroundings; nothing if it does not come there.
struct Pass {
  double low = 1e9;
  double high = -1e9;
};
Pass passOver(const mission::Plan& plan, double minX, double minY, double maxX, double maxY) {
  Pass pass;
  for (const mission::DecisionPoint& point : plan.tour) {
    if (point.pose.x > minX && point.pose.x < maxX && point.pose.y > minY && point.pose.y < maxY) {
      pass.low = std::min(pass.low, point.altitude);
      pass.high = std::max(pass.high, point.altitude);
    }
  }
  return pass;
}

/// A random convex or star-shaped outline, 3 to 12 corners.
std::vector<geo::Point> randomOutline(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const geo::Point centre{4000.0 * unit(random) - 2000.0, 4000.0 * unit(random) - 2000.0};
  const int corners = 3 + static_cast<int>(random() % 10);
  const double size = 150.0 + 900.0 * unit(random);
  std::vector<geo::Point> outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * Angle::kPi * (i + 0.8 * unit(random)) / corners;
    const double radius = size * (0.4 + 0.6 * unit(random));
    outline.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return outline;
}

mission::AirspaceLimit randomFloor(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  switch (random() % 4) {
    case 0:
      return {Kind::Surface, 0.0};
    case 1:
      return {Kind::AboveGround, 600.0 * unit(random)};
    case 2:
      return {Kind::FlightLevel, 1500.0 * unit(random)};
    default:
      return {Kind::Msl, 1500.0 * unit(random)};
  }
}

mission::AirspaceLimit randomCeiling(std::mt19937_64& random, const mission::AirspaceLimit& floor) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  switch (random() % 4) {
    case 0:
      return {Kind::Unlimited, 0.0};
    case 1:
      return {Kind::AboveGround, 200.0 + 900.0 * unit(random)};
    default:
      return {Kind::Msl, floor.metres + 100.0 + 900.0 * unit(random)};
  }
}

}  // namespace

class TestForbiddenAirspace : public QObject {
  Q_OBJECT

private slots:
  void gates_ofRandomPieces_coverAllThatTheCheckerFinds() {
    qInfo("seed %llu", static_cast<unsigned long long>(seed()));
    std::mt19937_64 random(seed());
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const tour::PlanInput input = test::mountainInput();
    const terrain::TerrainPyramid terrain(input.terrain);
    int entered = 0;
    int gated = 0;
    for (int round = 0; round < 20000; ++round) {
      std::vector<geo::Point> corners = randomOutline(random);
      if (round % 2 == 0) {
        std::shuffle(corners.begin(), corners.end(), random);  // sides that cross: even-odd
      }
      const mission::Airspace airspace = prism(input, corners, {Kind::Surface, 0.0}, {Kind::Unlimited, 0.0});
      const tour::ForbiddenAirspace forbidden({airspace}, {{}, {}, mission::AirspaceUse::Forbid}, input.frame);
      std::vector<geo::Point> outline;
      for (const geo::LatLon& corner : airspace.outline) {
        outline.push_back(input.frame.toPoint(corner));
      }
      const geo::Pose start{outline[0].x + 400.0 * unit(random), outline[0].y + 400.0 * unit(random), 4.0 * unit(random)};
      flight::Piece piece{static_cast<flight::Turn>(static_cast<int>(random() % 3) - 1), 0.0, 1.0 + 400.0 * std::abs(unit(random))};
      piece.radius = piece.turn != flight::Turn::Straight ? 50.0 + 600.0 * std::abs(unit(random)) : 0.0;
      std::vector<tour::HeightGate> gates;
      forbidden.addGates(terrain, start, piece, 0.0, gates);
      const bool isEntered = !safety::Outline(outline).stretchesInside(start, piece).empty();
      QVERIFY2(!isEntered || !gates.empty(), qPrintable(QString("round %1").arg(round)));
      entered += isEntered ? 1 : 0;
      gated += gates.empty() ? 0 : 1;
    }
    qInfo("%d entered, %d with a gate", entered, gated);
    QVERIFY(entered > 1000);
    QVERIFY(gated < entered * 1.2);  // the margin is small beside the airspaces
  }

  void plans_underRandomPrisms_areAcceptedByTheChecker_data() {
    QTest::addColumn<int>("refine");
    QTest::addColumn<int>("lowTargets");
    QTest::addColumn<int>("rounds");
    QTest::newRow("refined") << static_cast<int>(mission::Refine::Full) << static_cast<int>(mission::LowTargets::PassAbove) << 40;
    QTest::newRow("sampled") << static_cast<int>(mission::Refine::None) << static_cast<int>(mission::LowTargets::PassAbove) << 60;
    QTest::newRow("with spirals") << static_cast<int>(mission::Refine::Full) << static_cast<int>(mission::LowTargets::Descend) << 40;
  }
  void plans_underRandomPrisms_areAcceptedByTheChecker() {
    QFETCH(int, refine);
    QFETCH(int, lowTargets);
    QFETCH(int, rounds);
    qInfo("seed %llu", static_cast<unsigned long long>(seed()));
    std::mt19937_64 random(seed());
    tour::Planner planner;
    tour::PlanInput input = ringInput(6);
    input.mission.planner.refine = static_cast<mission::Refine>(refine);
    input.mission.planner.lowTargets = static_cast<mission::LowTargets>(lowTargets);
    const Result<mission::Plan> free = planner.plan(input, Job{});
    QVERIFY(free.has_value());
    input.mission.ceiling = geo::HeightMsl::fromMetres(2000.0);
    int planned = 0;
    int changed = 0;
    for (int round = 0; round < rounds; ++round) {
      std::vector<mission::Airspace> airspaces;
      for (int i = 1 + static_cast<int>(random() % 5); i > 0; --i) {
        const mission::AirspaceLimit floor = randomFloor(random);
        airspaces.push_back(prism(input, randomOutline(random), floor, randomCeiling(random, floor)));
      }
      forbid(input, airspaces);
      const Result<mission::Plan> plan = planner.plan(input, Job{});
      if (!plan) {
        QVERIFY2(plan.error().code == Errc::NoSolution, plan.error().message().c_str());
        QVERIFY2(plan.error().what.find("ZONE") != std::string::npos || plan.error().what.find("airspace") != std::string::npos,
                 plan.error().what.c_str());
        continue;
      }
      ++planned;
      changed += plan->tour != free->tour ? 1 : 0;
      const std::string against = objections(input, *plan);
      QVERIFY2(against.empty(), qPrintable(QString("round %1: %2").arg(round).arg(QString::fromStdString(against))));
      QVERIFY(plan->metrics.cost >= plan->metrics.lowerBound * (1.0 - 1e-9) || refine == static_cast<int>(mission::Refine::Full));
      QVERIFY(plan->metrics.cost >= plan->metrics.freeLowerBound * (1.0 - 1e-9));
    }
    qInfo("%d of %d planned, %d otherwise than without airspace", planned, rounds, changed);
    QVERIFY(planned > rounds / 2 && changed > rounds / 4);
  }

  void costs_ofBaseAndLazy_agreeUnderRandomPrisms() {
    qInfo("seed %llu", static_cast<unsigned long long>(seed()));
    std::mt19937_64 random(seed());
    tour::Planner planner;
    tour::PlanInput input = ringInput(5);
    input.mission.planner.refine = mission::Refine::None;
    input.mission.ceiling = geo::HeightMsl::fromMetres(2200.0);
    int compared = 0;
    for (int round = 0; round < 15; ++round) {
      const mission::AirspaceLimit floor = randomFloor(random);
      forbid(input, {prism(input, randomOutline(random), floor, randomCeiling(random, floor))});
      input.mission.planner.method = mission::Method::Base;
      const Result<mission::Plan> base = planner.plan(input, Job{});
      input.mission.planner.method = mission::Method::Lazy;
      const Result<mission::Plan> lazy = planner.plan(input, Job{});
      QCOMPARE(base.has_value(), lazy.has_value());
      if (base) {
        ++compared;
        QVERIFY2(std::abs(lazy->metrics.cost / base->metrics.cost - 1.0) <= 1e-6,
                 qPrintable(QString("round %1: BASE %2, LAZY %3").arg(round).arg(base->metrics.cost).arg(lazy->metrics.cost)));
        QVERIFY(std::abs(lazy->metrics.lowerBound - base->metrics.lowerBound) <= 1e-6 * base->metrics.cost);
      }
    }
    QVERIFY(compared >= 8);
  }

  void wall_betweenTargets_isFlownAround() {
    tour::PlanInput input = test::mountainInput();
    test::addTarget(input, "west", {-1800.0, 500.0});
    test::addTarget(input, "east", {-600.0, 1900.0});
    test::addTarget(input, "south", {-1900.0, -1200.0});
    const Result<mission::Plan> free = tour::planTour(input, Job{});
    QVERIFY(free.has_value());
    forbid(input, {prism(input, box(-1700.0, -500.0, -1500.0, 1500.0), {Kind::Surface, 0.0}, {Kind::Unlimited, 0.0})});
    const Result<mission::Plan> plan = tour::planTour(input, Job{});
    QVERIFY2(plan.has_value(), plan ? "" : plan.error().what.c_str());
    QCOMPARE(objections(input, *plan), std::string());
    QVERIFY(plan->metrics.cost > free->metrics.cost);
    QVERIFY(passOver(*plan, -1700.0, -500.0, -1500.0, 1500.0).high < -1e8);
  }

  void lowZone_onTheWay_isFlownOver() {
    tour::PlanInput input = ringInput(4);
    const Result<mission::Plan> free = tour::planTour(input, Job{});
    QVERIFY(free.has_value());
    // the whole mountain up to 1900 m: around it is longer than over it for a tour with a target on top
    test::addTarget(input, "top", {300.0, -200.0});
    forbid(input, {prism(input, box(-200.0, -700.0, 800.0, 300.0), {Kind::Surface, 0.0}, {Kind::Msl, 1900.0})});
    const Result<mission::Plan> plan = tour::planTour(input, Job{});
    QVERIFY2(plan.has_value(), plan ? "" : plan.error().what.c_str());
    QCOMPARE(objections(input, *plan), std::string());
    QVERIFY(passOver(*plan, -200.0, -700.0, 800.0, 300.0).low >= 1900.0 - 1e-3);
  }

  void highZone_overTheTour_changesNothing() {
    tour::PlanInput input = ringInput(5);
    const Result<mission::Plan> free = tour::planTour(input, Job{});
    forbid(input, {prism(input, box(-2400.0, -2400.0, 2400.0, 2400.0), {Kind::Msl, 2500.0}, {Kind::Unlimited, 0.0})});
    const Result<mission::Plan> plan = tour::planTour(input, Job{});
    QVERIFY(free && plan);
    QCOMPARE(objections(input, *plan), std::string());
    QVERIFY(plan->tour == free->tour);
  }

  void airspacesThatAreNotForbidden_changeNothing() {
    tour::PlanInput input = ringInput(5);
    const Result<mission::Plan> free = tour::planTour(input, Job{});
    forbid(input, {prism(input, box(-2400.0, -2400.0, 2400.0, 2400.0), {Kind::Surface, 0.0}, {Kind::Unlimited, 0.0})});
    for (const mission::AirspaceUse use : {mission::AirspaceUse::Warn, mission::AirspaceUse::Show, mission::AirspaceUse::Hide}) {
      input.mission.airspace.otherwise = use;
      const Result<mission::Plan> plan = tour::planTour(input, Job{});
      QVERIFY(free && plan);
      QVERIFY(plan->tour == free->tour && plan->metrics == free->metrics);
    }
  }

  void targetInside_isNamedWithTheAirspace() {
    tour::PlanInput input = ringInput(5);
    const geo::Point at = input.targets[2].point;
    forbid(input, {prism(input, box(at.x - 200.0, at.y - 200.0, at.x + 200.0, at.y + 200.0), {Kind::Surface, 0.0}, {Kind::Unlimited, 0.0})});
    tour::PlanFailure failure;
    const Result<mission::Plan> plan = tour::planTour(input, Job{}, nullptr, {}, &failure);
    QVERIFY(!plan && plan.error().code == Errc::NoSolution);
    QVERIFY2(plan.error().what.find("target T3 lies inside ZONE (class R, the surface to unlimited)") == 0, plan.error().what.c_str());
    QVERIFY(plan.error().what.find("Mission > Airspace") != std::string::npos);
    QCOMPARE(failure.target, 2);
  }

  void targetsApartByAWall_areSaidToBe() {
    tour::PlanInput input = ringInput(5);
    forbid(input, {prism(input, box(-100.0, -2600.0, 100.0, 2600.0), {Kind::Surface, 0.0}, {Kind::Unlimited, 0.0})});
    const Result<mission::Plan> plan = tour::planTour(input, Job{});
    QVERIFY(!plan && plan.error().code == Errc::NoSolution);
    QVERIFY2(plan.error().what.find("ZONE") != std::string::npos, plan.error().what.c_str());
  }

  void planning_stopped_returnsCancelled() {
    tour::PlanInput input = ringInput(6);
    forbid(input, {prism(input, box(-800.0, 200.0, 900.0, 1600.0), {Kind::Surface, 0.0}, {Kind::Msl, 1800.0})});
    std::stop_source stop;
    const Job job(stop.get_token(), [&](double fraction, std::string_view) {
      if (fraction > 0.5) {
        stop.request_stop();
      }
    });
    const Result<mission::Plan> plan = tour::planTour(input, job);
    QVERIFY(!plan && plan.error().code == Errc::Cancelled);
  }
};

QTEST_APPLESS_MAIN(TestForbiddenAirspace)
#include "tst_forbidden_airspace.moc"
