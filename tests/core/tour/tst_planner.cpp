// The whole planning core on a small mountain: plans that the independent checker certifies, and clear refusals.
#include "core/safety/checker.h"
#include "core/tour/free_bound.h"
#include "core/tour/planner.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <cmath>

using namespace vp;

namespace {

/// The mountain around 47 N 11 E with targets on a ring of 1.3 km and one near the top.
tour::PlanInput makeInput(int targets, int headings) {
  tour::PlanInput input;
  const landing::World world = test::mountainWorld();
  input.frame = geo::LocalFrame({47.0, 11.0});
  input.terrain = std::make_shared<const terrain::ElevationGrid>(world.terrain.grid());
  input.terrainFiles = {{"mountain.tif", std::string(64, '0')}};
  input.mission.name = "test";
  input.mission.terrain = {"mountain.tif"};
  input.mission.aircraft = test::paperCessna();
  input.mission.planner.headings = headings;
  input.mission.planner.step = Length::fromSi(100.0);
  input.mission.planner.roadmapSamples = 800;
  input.createdBy = "test";
  for (mission::SiteInFrame site : world.sites) {
    site.site.airportIdent = site.site.id.substr(0, 1);
    site.site.touchdown = input.frame.toLatLon(site.pose.point());
    site.site.landingCourse = input.frame.trueCourseOf(site.pose.heading, site.pose.point());
    input.mission.sites.push_back(site.site);
    input.sites.push_back(site);
  }
  for (int i = 0; i < targets; ++i) {
    const double angle = 2.0 * Angle::kPi * i / targets;
    const geo::Point p = i == 0 ? geo::Point{350.0, -150.0} : geo::Point{1300.0 * std::cos(angle), 1300.0 * std::sin(angle)};
    mission::Target target;
    target.name = "T" + std::to_string(i + 1);
    target.position = input.frame.toLatLon(p);
    const geo::Point placed = input.frame.toPoint(target.position);
    input.mission.targets.push_back(target);
    input.targets.push_back({target, placed, input.terrain->upperAt(placed) + 100.0});
  }
  return input;
}

safety::SafetyReport judge(const tour::PlanInput& input, const mission::Plan& plan) {
  return *safety::check({plan, *input.terrain, {std::string(64, '0')}}, Job{});
}

double freeBound(const tour::PlanInput& input) {
  std::vector<tour::VisitPose> visits;
  for (const mission::TargetInFrame& target : input.targets) {
    visits.push_back({static_cast<int>(visits.size()), {target.point.x, target.point.y, 0.0}, target.altitude});
  }
  return *tour::freeLowerBound(*landing::AltitudeFloor::build(tour::makeWorld(input), {}, Job{}), visits, input.mission.planner.beta, Job{});
}

}  // namespace

class TestPlanner : public QObject {
  Q_OBJECT

private slots:
  void plan_underTheChecker_isCertified_data() {
    QTest::addColumn<int>("targets");
    QTest::addColumn<int>("headings");
    QTest::newRow("one target") << 1 << 4;
    QTest::newRow("two targets") << 2 << 4;
    QTest::newRow("five targets") << 5 << 4;
    QTest::newRow("one heading") << 4 << 1;
  }

  void plan_underTheChecker_isCertified() {
    QFETCH(int, targets);
    QFETCH(int, headings);
    for (const auto lowTargets : {mission::LowTargets::PassAbove, mission::LowTargets::Descend}) {
      tour::PlanInput input = makeInput(targets, headings);
      input.mission.planner.lowTargets = lowTargets;
      const Result<mission::Plan> plan = tour::planTour(input, Job{});
      QVERIFY2(plan.has_value(), plan ? "" : plan.error().what.c_str());
      const safety::SafetyReport report = judge(input, *plan);
      for (const safety::Finding& finding : report.findings) {
        if (finding.severity == safety::Severity::Violated || finding.severity == safety::Severity::Unknown) {
          qInfo("%s: %s", finding.rule.c_str(), finding.text.c_str());
        }
      }
      QVERIFY(report.isSafe());
      int visited = 0;
      for (const mission::DecisionPoint& point : plan->tour) {
        visited += point.target >= 0 ? 1 : 0;
      }
      QCOMPARE(visited, targets);
      QVERIFY(plan->metrics.lowerBound <= plan->metrics.sampledCost + 1e-6);  // a refined tour may cost less than the bound
      if (lowTargets == mission::LowTargets::PassAbove) {
        QVERIFY(plan->spirals.empty());
        const double free = freeBound(input);
        QVERIFY2(free <= plan->metrics.lowerBound + 1e-6, qPrintable(QString("%1 above %2").arg(free).arg(plan->metrics.lowerBound)));
        QVERIFY(targets < 4 || free > 0.6 * plan->metrics.cost);
        qInfo("any tour costs at least %.0f m, one over these headings %.0f m, the plan %.0f m", free, plan->metrics.lowerBound, plan->metrics.cost);
      }
    }
  }

  void voidBetweenTargets_isFlownAround() {
    tour::PlanInput input = makeInput(4, 4);
    std::vector<float> values = input.terrain->values();
    for (int j = 0; j < 180; ++j) {
      for (int i = 105; i < 109; ++i) {
        values[static_cast<std::size_t>(j * 250 + i)] = terrain::kUnknownUpper;  // from the south up to 1.1 km north
      }
    }
    input.terrain = std::make_shared<const terrain::ElevationGrid>(-2500.0, -2500.0, 20.0, 250, 250, std::move(values));
    const Result<mission::Plan> plan = tour::planTour(input, Job{});
    QVERIFY2(plan.has_value(), plan ? "" : plan.error().what.c_str());
    QVERIFY(judge(input, *plan).isSafe());
  }

  void baseAndLazy_underAnExactSolver_agree() {
    tour::PlanInput input = makeInput(5, 4);
    input.mission.planner.refine = mission::Refine::None;
    input.mission.planner.method = mission::Method::Lazy;
    const mission::Plan lazy = *tour::planTour(input, Job{});
    input.mission.planner.method = mission::Method::Base;
    const mission::Plan base = *tour::planTour(input, Job{});
    QVERIFY(std::abs(lazy.metrics.cost - base.metrics.cost) < 1e-6 * base.metrics.cost);
    QVERIFY(lazy.metrics.safeSegments < base.metrics.safeSegments / 2);
    QCOMPARE(base.metrics.tourSolutions, std::int64_t(1));
  }

  void threads_doNotChangeThePlan() {
    tour::PlanInput input = makeInput(4, 4);
    const mission::Plan one = *tour::planTour(input, Job{});
    input.threads = 3;
    const mission::Plan three = *tour::planTour(input, Job{});
    QVERIFY(one.tour == three.tour);
    QCOMPARE(one.metrics.safeQueries, three.metrics.safeQueries);
  }

  void lowCeiling_namesTheTargetAndTheMissingHeight() {
    tour::PlanInput input = makeInput(4, 4);
    input.mission.ceiling = geo::HeightMsl::fromMetres(1400.0);
    const Result<mission::Plan> plan = tour::planTour(input, Job{});
    QVERIFY(!plan);
    QVERIFY(plan.error().code == Errc::NoSolution);
    const QString text = QString::fromStdString(plan.error().what);
    QVERIFY2(text.contains("T1") && text.contains("ceiling") && text.contains("1400"), qPrintable(text));
  }

  void noTargets_isRefused() {
    const Result<mission::Plan> plan = tour::planTour(makeInput(0, 4), Job{});
    QVERIFY(!plan && plan.error().code == Errc::OutOfRange);
  }

  void targetOverUnknownGround_isRefused() {
    tour::PlanInput input = makeInput(3, 4);
    input.targets[1].point = {9000.0, 0.0};
    const Result<mission::Plan> plan = tour::planTour(input, Job{});
    QVERIFY(!plan && plan.error().code == Errc::MissingTerrain);
    QVERIFY(QString::fromStdString(plan.error().what).contains("T2"));
  }

  void cancel_atAnyStage_givesNoPlan() {
    for (const double when : {0.0, 0.2, 0.45, 0.6}) {
      std::stop_source stop;
      const Job job(stop.get_token(), [&](double fraction, std::string_view) {
        if (fraction >= when) {
          stop.request_stop();
        }
      });
      const Result<mission::Plan> plan = tour::planTour(makeInput(6, 8), job);
      QVERIFY(!plan && plan.error().code == Errc::Cancelled);
    }
  }
};

QTEST_APPLESS_MAIN(TestPlanner)
#include "tst_planner.moc"
