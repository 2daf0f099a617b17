// Plans under random combinations of what a mission may ask for (reaction, approach, hold, air, masses, drag, propeller, power setting, wind):
// flown by the equations of motion on days of the mission, and judged by the checker.
#include "core/landing/approach.h"
#include "core/safety/checker.h"
#include "tests/support/drawn_mission.h"
#include "tests/support/plan_flights.h"

#include <QTest>

#include <set>

using namespace vp;
using mission::ApproachKind;

namespace {

constexpr int kMissions = 12;

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
    QTest::addColumn<bool>("hasLayers");
    for (int i = 0; i < kMissions; ++i) {
      QTest::addRow("mission %d", i) << i << false;
      QTest::addRow("mission %d in layers", i) << i << true;
    }
  }
  void randomSettings_planned_holdOnEveryDay() {
    QFETCH(int, number);
    QFETCH(bool, hasLayers);
    tour::PlanInput input = test::drawnInput(number);
    if (hasLayers) {
      test::drawLayers(number, input.mission);
    }
    qInfo("%s", qPrintable(test::describe(input.mission)));
    const Result<mission::Plan> plan = tour::planTour(input, Job{});
    QVERIFY2(plan.has_value(), plan ? "" : plan.error().what.c_str());
    test::Flights flights(*plan, *input.terrain);
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
    if (test::isKnownToTheChecker(input.mission)) {
      const safety::SafetyReport report = *safety::check({*plan, *input.terrain, {std::string(64, '0')}}, Job{});
      QVERIFY2(report.isSafe(), qPrintable(refusals(report)));
    }
  }

  /// All bounds of costs, over altitudes that reaction and approach have raised.
  void bounds_underRandomSettings_stayBelowTheCost() {
    for (int number = 0; number < 6; ++number) {
      tour::PlanInput input = test::drawnInput(number);
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
    tour::PlanInput input = test::drawnInput(1);
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
    tour::PlanInput input = test::drawnInput(0);
    input.mission.aircraft.leastMass_kg = 500.0;
    input.mission.wind = {{geo::HeightMsl(), {0.0, 0.0, 0.0, 25.0}}};
    const Result<mission::Plan> plan = tour::planTour(input, Job{});
    QVERIFY(!plan && plan.error().code == Errc::OutOfRange);
    QVERIFY(plan.error().what.find("lightest aircraft") != std::string::npos);
  }
};

QTEST_APPLESS_MAIN(TestConditions)
#include "tst_conditions.moc"
