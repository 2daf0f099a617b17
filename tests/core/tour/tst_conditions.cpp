// Plans under random combinations of what a mission may ask for (reaction, approach, hold, air, masses, drag, propeller, power setting, wind):
// flown by the equations of motion on days of the mission, and judged by the checker.
#include "core/landing/approach.h"
#include "core/safety/checker.h"
#include "tests/support/condition_flight.h"
#include "tests/support/ring_mission.h"

#include <QTest>

#include <cmath>
#include <random>
#include <set>

using namespace vp;
using mission::ApproachKind;

namespace {

/// The checker of this tree takes the whole clearance on every approach and best glide speed on every tour. Set when it knows better.
constexpr bool kCheckerKnowsConditions = false;
constexpr int kMissions = 12;

class Draw {
public:
  explicit Draw(int seed) : engine_(static_cast<std::uint64_t>(seed) * 7919 + 5) {}
  double between(double least, double most) { return least + (most - least) * unit_(engine_); }
  bool oneIn(int n) { return between(0.0, n) < 1.0; }

private:
  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

void drawAircraft(Draw& draw, mission::Mission& mission) {
  aircraft::AircraftProfile& profile = mission.aircraft;
  profile.steepestDescent = Angle::degrees(15.0);
  profile.windmillingDrag = 0.040;
  profile.stoppedDrag = 0.037;
  profile.powerSettings = {{"65 %", Speed::fromSi(42.0), 30.0, aircraft::PowerSetting::Unit::Litres}};
  if (draw.oneIn(2)) {
    profile.leastMass_kg = 850.0;
    profile.mostMass_kg = 1111.0;
  }
  mission.powerSetting = draw.oneIn(2) ? "65 %" : "";
  mission.propeller = static_cast<aircraft::Propeller>(static_cast<int>(draw.between(0.0, 2.999)));
  if (draw.oneIn(2)) {
    mission.atmosphere = air::Atmosphere{draw.between(-15.0, 20.0), draw.between(990.0, 1030.0)};
    mission.ceiling = geo::HeightMsl::fromMetres(3000.0);
  }
  if (draw.oneIn(2)) {
    const double speed = draw.between(0.0, 4.0);
    mission.wind = {{geo::HeightMsl(), {draw.between(0.0, 360.0), draw.between(0.0, 25.0), speed, speed + 2.0}}};
  }
}

void drawSafety(Draw& draw, int number, mission::Mission& mission) {
  mission.safety.arrivalMargin = Length::fromSi(draw.between(0.0, 40.0));
  mission.safety.dragFactor = draw.oneIn(2) ? 1.0 : draw.between(1.0, 1.2);
  mission.safety.reactionTime = Duration::fromSi(draw.oneIn(3) ? 0.0 : draw.between(1.0, 8.0));
  mission.safety.reactionLoss = Length::fromSi(draw.oneIn(3) ? 0.0 : draw.between(0.0, 40.0));
  mission::ApproachSettings& approach = mission.approach;
  approach.kind = static_cast<ApproachKind>(number % 3);
  approach.finalLength = Length::fromSi(draw.between(300.0, 1200.0));
  if (approach.kind == ApproachKind::Straight && draw.oneIn(2)) {
    approach.slope = Angle::degrees(10.5);
  }
  if (draw.oneIn(2)) {
    approach.surfaceSlope = draw.between(0.02, 0.06);
  }
  if (approach.kind == ApproachKind::Overhead && draw.oneIn(2)) {
    approach.keyHeight = Length::fromSi(draw.between(100.0, 350.0));
  }
  approach.hold = draw.oneIn(2);
  mission.planner.roadmap = draw.oneIn(4) ? mission::RoadmapKind::RrtStar : mission::RoadmapKind::Lattice;
}

/// The mountain with room for approaches around it, five targets, and the settings of a number.
tour::PlanInput inputOf(int number) {
  Draw draw(number);
  tour::PlanInput input = test::mountainInput();
  input.terrain = test::makeGrid(8000.0, 20.0, test::mountainHeight);
  for (int i = 0; i < 5; ++i) {
    const double angle = 2.0 * Angle::kPi * i / 5;
    test::addTarget(input, "T" + std::to_string(i + 1), {1500.0 * std::cos(angle), 1500.0 * std::sin(angle)});
  }
  input.mission.planner.step = Length::fromSi(60.0);
  drawAircraft(draw, input.mission);
  drawSafety(draw, number, input.mission);
  if (number % 4 == 1) {
    input.mission.home = mission::HomeBase{"A/09", "B/18"};
  }
  return input;
}

QString describe(const mission::Mission& m) {
  return QString("approach %1, surface %2, hold %3, reaction %4 s and %5 m, drag %6, air %7, wind %8, power '%9'")
      .arg(static_cast<int>(m.approach.kind))
      .arg(m.approach.surfaceSlope.value_or(0.0))
      .arg(m.approach.hold)
      .arg(m.safety.reactionTime.si())
      .arg(m.safety.reactionLoss.si())
      .arg(m.safety.dragFactor)
      .arg(m.atmosphere.has_value())
      .arg(m.wind.size())
      .arg(QString::fromStdString(m.powerSetting));
}

/// The path of decision points from one of them on, a few kilometres at most.
std::vector<flight::Piece> pathFrom(const std::vector<mission::DecisionPoint>& points, std::size_t from, bool isClosed) {
  std::vector<flight::Piece> path;
  for (std::size_t i = 0; i < 40 && (isClosed || from + i < points.size()); ++i) {
    path.push_back(points[(from + i) % points.size()].onward);
  }
  return path;
}

class Flights {
public:
  Flights(const mission::Plan& plan, const terrain::ElevationGrid& terrain)
      : plan_(plan),
        terrain_(terrain),
        conditions_(mission::glideConditionsOf(plan.mission, plan.sites)),
        model_(plan.mission.aircraft, conditions_) {}

  /// The engine stops at random places of a path on random days. @return what went wrong
  QString fly(const std::vector<mission::DecisionPoint>& points, std::size_t first, bool isClosed, int times) {
    const std::size_t last = isClosed ? points.size() - 1 : points.size() - 2;
    for (int i = 0; i < times; ++i) {
      const std::size_t at = first + std::uniform_int_distribution<std::size_t>(0, last - first)(random_);
      const double part = i % 2 == 0 ? 0.0 : std::uniform_real_distribution<double>(0.0, 1.0)(random_);
      const QString wrong = failAt(points, at, part, isClosed);
      if (!wrong.isEmpty()) {
        return QString("point %1 + %2: %3").arg(at).arg(part).arg(wrong);
      }
    }
    return {};
  }

private:
  QString failAt(const std::vector<mission::DecisionPoint>& points, std::size_t at, double part, bool isClosed) {
    const mission::DecisionPoint& from = points[at];
    const std::size_t nextAt = (at + 1) % points.size();
    const mission::DecisionPoint& next = points[nextAt];
    geo::Pose pose = from.pose;
    std::vector<flight::Piece> pieces = from.witness.pieces;
    if (part > 0.0) {
      const test::Outcome there = test::fly(test::polarOf(plan_.mission.aircraft), {}, from.pose, 0.0,
                                            {{from.onward.turn, from.onward.radius, part * from.onward.length}}, terrain_, 0.0, 0.01);
      pose = there.end;
      pieces = {{from.onward.turn, from.onward.radius, (1.0 - part) * from.onward.length}};
      pieces.insert(pieces.end(), next.witness.pieces.begin(), next.witness.pieces.end());
    }
    const mission::Witness& proof = part > 0.0 ? next.witness : from.witness;
    const std::size_t proofAt = part > 0.0 ? nextAt : at;
    if (test::turnsTooEarly(pathFrom(points, proofAt, isClosed), proof.pieces, plan_.mission.safety.reactionTime.si() * model_.mostGroundSpeed())) {
      return "turns too early";
    }
    const double altitude = from.altitude + part * (next.altitude - from.altitude) - plan_.mission.safety.reactionLoss.si();
    const test::Day day = test::dayOf(plan_.mission, random_);
    return judge(test::flyGlide(plan_, conditions_, day, terrain_, pose, altitude, pieces), plan_.sites.at(static_cast<std::size_t>(proof.site)));
  }

  [[nodiscard]] QString judge(const test::ConditionOutcome& outcome, const mission::SiteInFrame& site) const {
    const mission::ApproachSettings& asked = plan_.mission.approach;
    const double elevation = site.site.elevation.metres();
    const double arrival = outcome.endAltitude - elevation - plan_.mission.safety.arrivalMargin.si();
    if (outcome.leastSpare < -1e-3 || arrival < -1e-3) {
      return QString("spare %1, arrival %2").arg(outcome.leastSpare).arg(arrival);
    }
    if (geo::distance(outcome.end.point(), site.pose.point()) > 0.05 || std::abs(wrapPi(outcome.end.heading - site.pose.heading)) > 1e-3) {
      return "ends beside the runway";
    }
    if (asked.kind == ApproachKind::Straight && !outcome.isGateStraight) {
      return "turns on its final";
    }
    if (asked.kind == ApproachKind::Overhead && (geo::distance(outcome.gate.point(), site.pose.point()) > 0.05 ||
                                                 outcome.gateAltitude - elevation < asked.keyHeight.value_or(Length()).si() - 1e-3)) {
      return QString("at high key only %1 m above the runway").arg(outcome.gateAltitude - elevation);
    }
    return {};
  }

  const mission::Plan& plan_;
  const terrain::ElevationGrid& terrain_;
  aircraft::GlideConditions conditions_;
  aircraft::GlideModel model_;
  std::mt19937_64 random_{99};
};

/// "" if the plan's holds are what its mission asks for.
QString faultOfHolds(const mission::Plan& plan, const landing::World& world) {
  std::set<int> used;
  for (const mission::DecisionPoint& point : plan.tour) {
    used.insert(point.witness.site);
  }
  for (const auto* path : {&plan.departure, &plan.arrival}) {
    for (std::size_t i = 0; *path && i < (*path)->points.size(); ++i) {
      used.insert((*path)->points[i].witness.site);
    }
  }
  used.erase(-1);
  std::set<int> held;
  for (const mission::Hold& hold : plan.holds) {
    held.insert(hold.site);
    const landing::Approach approach = *landing::approachTo(world, static_cast<std::size_t>(hold.site));
    const flight::Piece circle{hold.turn, hold.radius, 2.0 * Angle::kPi * hold.radius};
    const test::Outcome around = test::fly({33.4, 0.0, 0.0}, {}, approach.gate, hold.lowest, {circle}, world.terrain.grid(), world.clearance, 1.0);
    if (around.leastSpare < -1e-6 || hold.lowest < approach.altitude) {
      return QString("the hold of site %1 is too low").arg(hold.site);
    }
  }
  const bool isRight = plan.mission.approach.hold ? held == used && plan.holds.size() == held.size() : plan.holds.empty();
  return isRight ? QString() : "holds of other sites than the glides end at";
}

QString refusals(const safety::SafetyReport& report) {
  QString text;
  for (const safety::Finding& finding : report.findings) {
    if (finding.severity == safety::Severity::Violated || finding.severity == safety::Severity::Unknown) {
      text += QString::fromStdString("\n" + finding.rule + ": " + finding.text);
    }
  }
  return text;
}

}  // namespace

class TestConditions : public QObject {
  Q_OBJECT

private slots:
  void randomSettings_planned_holdOnEveryDay_data() {
    QTest::addColumn<int>("number");
    for (int i = 0; i < kMissions; ++i) {
      QTest::addRow("mission %d", i) << i;
    }
  }
  void randomSettings_planned_holdOnEveryDay() {
    QFETCH(int, number);
    const tour::PlanInput input = inputOf(number);
    qInfo("%s", qPrintable(describe(input.mission)));
    const Result<mission::Plan> plan = tour::planTour(input, Job{});
    QVERIFY2(plan.has_value(), plan ? "" : plan.error().what.c_str());
    Flights flights(*plan, *input.terrain);
    const QString wrong = flights.fly(plan->tour, 0, true, 600);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    if (plan->departure) {
      const QString out = flights.fly(plan->departure->points, static_cast<std::size_t>(plan->departure->guaranteed), false, 200);
      QVERIFY2(out.isEmpty(), qPrintable("departure, " + out));
      const QString in = flights.fly(plan->arrival->points, 0, false, 200);
      QVERIFY2(in.isEmpty(), qPrintable("arrival, " + in));
    }
    const QString holds = faultOfHolds(*plan, tour::makeWorld(input));
    QVERIFY2(holds.isEmpty(), qPrintable(holds));
    const bool isTapered = input.mission.approach.surfaceSlope && input.mission.approach.kind != ApproachKind::Threshold;
    if (kCheckerKnowsConditions || (!isTapered && input.mission.powerSetting.empty())) {
      const safety::SafetyReport report = *safety::check({*plan, *input.terrain, {std::string(64, '0')}}, Job{});
      QVERIFY2(report.isSafe(), qPrintable(refusals(report)));
    }
  }

  /// All bounds of costs, over altitudes that reaction and approach have raised.
  void bounds_underRandomSettings_stayBelowTheCost() {
    for (int number = 0; number < 6; ++number) {
      tour::PlanInput input = inputOf(number);
      input.mission.home.reset();
      const Result<mission::Plan> plan = tour::planTour(input, Job{});
      QVERIFY(plan.has_value());
      const mission::PlanMetrics& m = plan->metrics;
      QVERIFY(m.freeLowerBound > 0.0 && m.freeLowerBound <= m.cost * (1.0 + 1e-9));
      const double sampled = m.sampledCost > 0.0 ? m.sampledCost : m.cost;
      QVERIFY2(m.lowerBound <= sampled * (1.0 + 1e-9), qPrintable(QString("%1 above %2").arg(m.lowerBound).arg(sampled)));
    }
  }

  void noSiteThatCanBeHeld_isSaidInOneSentence() {
    tour::PlanInput input = inputOf(1);
    input.mission.approach = {};
    input.mission.approach.kind = ApproachKind::Straight;
    input.mission.approach.slope = Angle::degrees(3.0);
    const Result<mission::Plan> plan = tour::planTour(input, Job{});
    QVERIFY(!plan && plan.error().code == Errc::NoLandingSite);
    const std::string& what = plan.error().what;
    QVERIFY2(what.find("A/09: its approach of 3.0 degrees cannot be held") != std::string::npos && what.find("4 others") != std::string::npos,
             what.c_str());
  }

  void windAsStrongAsTheLightestGlides_isRefused() {
    tour::PlanInput input = inputOf(0);
    input.mission.aircraft.leastMass_kg = 500.0;
    input.mission.wind = {{geo::HeightMsl(), {0.0, 0.0, 0.0, 25.0}}};
    const Result<mission::Plan> plan = tour::planTour(input, Job{});
    QVERIFY(!plan && plan.error().code == Errc::OutOfRange);
    QVERIFY(plan.error().what.find("lightest aircraft") != std::string::npos);
  }
};

QTEST_APPLESS_MAIN(TestConditions)
#include "tst_conditions.moc"
