// Planning again after an edit: as safe as a fresh plan, near its cost, and never over what has become invalid.
#include "core/safety/checker.h"
#include "core/tour/replan.h"
#include "tests/support/ring_mission.h"

#include <QTest>

#include <cmath>
#include <functional>

using namespace vp;

Q_DECLARE_METATYPE(std::function<void(vp::mission::Mission&)>)

namespace {

tour::PlanInput ringInput(int targets) {
  tour::PlanInput input = test::mountainInput();
  for (int i = 0; i < targets; ++i) {
    const double angle = 2.0 * Angle::kPi * i / targets;
    const double radius = i % 2 == 0 ? 1900.0 : 1100.0;
    test::addTarget(input, "T" + std::to_string(i + 1), {radius * std::cos(angle), radius * std::sin(angle)});
  }
  return input;
}

/// The same mission with one target elsewhere.
tour::PlanInput moved(const tour::PlanInput& input, std::size_t target, geo::Point by) {
  tour::PlanInput result = input;
  result.mission.targets.clear();
  result.targets.clear();
  for (std::size_t t = 0; t < input.targets.size(); ++t) {
    const mission::TargetInFrame& old = input.targets[t];
    if (t == target) {
      test::addTarget(result, old.target.name, {old.point.x + by.x, old.point.y + by.y});
    } else {
      result.mission.targets.push_back(old.target);
      result.targets.push_back(old);
    }
  }
  return result;
}

bool isCertified(const tour::PlanInput& input, const mission::Plan& plan) {
  return safety::check({plan, *input.terrain, {std::string(64, '0')}}, Job{})->isSafe();
}

/// Refined tours of a few targets from different beginnings; local minima apart by more than this would be a defect.
constexpr double kGap = 0.05;

}  // namespace

class TestReplan : public QObject {
  Q_OBJECT

private slots:
  void movedTarget_replanned_isSafeAndNearAFreshPlan() {
    tour::Planner planner;
    tour::PlanInput input = ringInput(8);
    QVERIFY(planner.plan(input, Job{}));
    QVERIFY(!planner.reused().roadmap && !planner.reused().tour);
    for (std::size_t t = 0; t < 4; ++t) {
      input = moved(input, t, {-120.0, 90.0});
      const Result<mission::Plan> plan = planner.plan(input, Job{});
      QVERIFY(plan.has_value());
      QVERIFY(planner.reused().roadmap && planner.reused().tour);
      QVERIFY(isCertified(input, *plan));
      const Result<mission::Plan> fresh = tour::planTour(input, Job{});
      QVERIFY(fresh.has_value());
      QVERIFY2(plan->metrics.cost <= fresh->metrics.cost * (1.0 + kGap),
               qPrintable(QString("replanned %1, fresh %2").arg(plan->metrics.cost).arg(fresh->metrics.cost)));
      QCOMPARE(plan->metrics.lowerBound, 0.0);
      QVERIFY(plan->metrics.safeQueries < fresh->metrics.safeQueries);
    }
  }

  void addedRemovedAndRenamedTargets_replanned_areSafe() {
    tour::Planner planner;
    tour::PlanInput input = ringInput(7);
    QVERIFY(planner.plan(input, Job{}));
    test::addTarget(input, "new", {-300.0, 1500.0});
    Result<mission::Plan> plan = planner.plan(input, Job{});
    QVERIFY(plan && planner.reused().tour && isCertified(input, *plan));
    input.mission.targets.erase(input.mission.targets.begin() + 2);
    input.targets.erase(input.targets.begin() + 2);
    plan = planner.plan(input, Job{});
    QVERIFY(plan && planner.reused().tour && isCertified(input, *plan));
    input.mission.targets[3].name = input.targets[3].target.name = "renamed";
    plan = planner.plan(input, Job{});
    QVERIFY(plan && planner.reused().tour && isCertified(input, *plan));
  }

  void unchangedTargets_plannedAgain_areSearchedAfresh() {
    tour::Planner planner;
    const tour::PlanInput input = ringInput(5);
    QVERIFY(planner.plan(input, Job{}));
    const tour::PlanInput edited = moved(input, 2, {80.0, -60.0});
    const Result<mission::Plan> reused = planner.plan(edited, Job{});
    QVERIFY(reused && planner.reused().tour && reused->metrics.lowerBound == 0.0);
    const Result<mission::Plan> again = planner.plan(edited, Job{});
    QVERIFY(again && planner.reused().roadmap && !planner.reused().tour);
    QVERIFY(again->metrics.lowerBound > 0.0);
    QVERIFY(again->tour == tour::planTour(edited, Job{})->tour);
  }

  void closedRunway_replanned_isNeverUsed() {
    tour::Planner planner;
    tour::PlanInput input = ringInput(6);
    const Result<mission::Plan> before = planner.plan(input, Job{});
    QVERIFY(before.has_value());
    const int used = before->tour.front().witness.site;
    const std::string closed = input.sites[static_cast<std::size_t>(used)].site.id;
    input.sites.erase(input.sites.begin() + used);
    input.mission.sites.erase(input.mission.sites.begin() + used);
    const Result<mission::Plan> after = planner.plan(input, Job{});
    QVERIFY2(after.has_value(), after ? "" : after.error().what.c_str());
    QVERIFY(!planner.reused().roadmap && !planner.reused().tour);
    QVERIFY(isCertified(input, *after));
    for (const mission::DecisionPoint& point : after->tour) {
      QVERIFY(after->sites[static_cast<std::size_t>(point.witness.site)].site.id != closed);
    }
  }

  void changedSettings_replanned_keepOnlyWhatTheyAllow() {
    tour::Planner planner;
    tour::PlanInput input = ringInput(5);
    QVERIFY(planner.plan(input, Job{}));
    input.mission.planner.beta = 3.0;
    QVERIFY(planner.plan(input, Job{}));
    QVERIFY(planner.reused().roadmap && !planner.reused().tour);
    input.mission.safety.clearance = Length::fromSi(120.0);
    const Result<mission::Plan> higher = planner.plan(input, Job{});
    QVERIFY(higher && !planner.reused().roadmap && isCertified(input, *higher));
    input.mission.planner.refine = mission::Refine::None;
    const Result<mission::Plan> sampled = planner.plan(input, Job{});
    QVERIFY(sampled && planner.reused().roadmap && !planner.reused().tour);
    QVERIFY(sampled->tour == tour::planTour(input, Job{})->tour);
  }

  void changedWind_replanned_growsGlidesAnew() {
    tour::Planner planner;
    tour::PlanInput input = ringInput(5);
    QVERIFY(planner.plan(input, Job{}));
    input.mission.wind = {{geo::HeightMsl(), {270.0, 0.0, 3.0, 3.0}}};
    const Result<mission::Plan> windy = planner.plan(input, Job{});
    QVERIFY2(windy, windy ? "" : windy.error().what.c_str());
    QVERIFY(!planner.reused().roadmap && !planner.reused().tour);
    QVERIFY(windy->mission.wind == input.mission.wind);
    QVERIFY(planner.plan(input, Job{}) && planner.reused().roadmap);
    input.mission.wind[0].wind.from_deg = 90.0;
    QVERIFY(planner.plan(input, Job{}) && !planner.reused().roadmap);
  }

  void changedConditions_replanned_growGlidesAnew_data() {
    using Change = std::function<void(mission::Mission&)>;
    QTest::addColumn<Change>("change");
    const auto row = [](const char* name, Change change) { QTest::newRow(name) << std::move(change); };
    row("reaction", [](mission::Mission& m) { m.safety.reactionTime = Duration::fromSi(3.0); });
    row("height lost by reacting", [](mission::Mission& m) { m.safety.reactionLoss = Length::fromSi(15.0); });
    row("drag", [](mission::Mission& m) { m.safety.dragFactor = 1.1; });
    row("approach", [](mission::Mission& m) { m.approach.kind = mission::ApproachKind::Overhead; });
    row("hold", [](mission::Mission& m) { m.approach.hold = true; });
    row("air", [](mission::Mission& m) { m.atmosphere = air::Atmosphere{}; });
    row("mass", [](mission::Mission& m) { m.aircraft.mostMass_kg = 1100.0; });
    row("propeller", [](mission::Mission& m) { m.propeller = aircraft::Propeller::Stopped; });
    row("power", [](mission::Mission& m) { m.powerSetting = "fast"; });
  }
  void changedConditions_replanned_growGlidesAnew() {
    QFETCH(std::function<void(mission::Mission&)>, change);
    tour::Planner planner;
    tour::PlanInput input = ringInput(5);
    input.mission.aircraft.stoppedDrag = 0.036;
    input.mission.aircraft.powerSettings = {{"fast", Speed::fromSi(36.0), 30.0, aircraft::PowerSetting::Unit::Litres}};
    const Result<mission::Plan> before = planner.plan(input, Job{});
    QVERIFY(before && planner.plan(input, Job{}) && planner.reused().roadmap);
    change(input.mission);
    const Result<mission::Plan> after = planner.plan(input, Job{});
    QVERIFY2(after, after ? "" : after.error().what.c_str());
    QVERIFY(!planner.reused().roadmap && !planner.reused().tour);
    QVERIFY(after->tour != before->tour || after->holds != before->holds);
    QVERIFY(after->tour == tour::planTour(input, Job{})->tour);
  }

  void windAsStrongAsTheGlide_isRefusedAtOnce() {
    tour::PlanInput input = ringInput(5);
    const double speed = input.mission.aircraft.bestGlideSpeed.si();
    input.mission.wind = {{geo::HeightMsl(), {270.0, 0.0, 0.0, speed}}};
    const Result<mission::Plan> plan = tour::planTour(input, Job{});
    QVERIFY(!plan && plan.error().code == Errc::OutOfRange);
    QVERIFY2(plan.error().what.find("is not below the gliding speed") != std::string::npos, plan.error().what.c_str());
  }

  void stoppedCall_leavesThePlannerAsItWas() {
    tour::Planner planner;
    tour::PlanInput input = ringInput(5);
    QVERIFY(planner.plan(input, Job{}));
    std::stop_source stop;
    stop.request_stop();
    input = moved(input, 1, {50.0, 50.0});
    const Result<mission::Plan> stopped = planner.plan(input, Job(stop.get_token(), {}));
    QVERIFY(!stopped && stopped.error().code == Errc::Cancelled);
    const Result<mission::Plan> plan = planner.plan(input, Job{});
    QVERIFY(plan && planner.reused().tour && isCertified(input, *plan));
  }
};

QTEST_APPLESS_MAIN(TestReplan)
#include "tst_replan.moc"
