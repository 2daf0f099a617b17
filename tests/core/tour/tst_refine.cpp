// Refined tours: never dearer than the tour they came from, certified, the same each time, and stopped at once.
#include "core/safety/checker.h"
#include "core/tour/assembly.h"
#include "core/tour/planner.h"
#include "core/tour/refine.h"
#include "tests/support/ring_mission.h"

#include <QTest>

#include <chrono>
#include <cmath>
#include <random>
#include <thread>

using namespace vp;

namespace {

tour::PlanInput randomInput(std::mt19937_64& engine, int targets) {
  std::uniform_real_distribution<double> place(-2000.0, 2000.0);
  tour::PlanInput input = test::mountainInput();
  for (int i = 0; i < targets; ++i) {
    test::addTarget(input, "T" + std::to_string(i + 1), {place(engine), place(engine)});
  }
  return input;
}

std::string faults(const tour::PlanInput& input, const mission::Plan& plan) {
  const safety::SafetyReport report = *safety::check({plan, *input.terrain, {std::string(64, '0')}}, Job{});
  std::string text = report.isSafe() ? "" : "not safe: ";
  for (const safety::Finding& finding : report.findings) {
    text += !report.isSafe() ? finding.rule + ": " + finding.text + "; " : "";
  }
  return text;
}

}  // namespace

class TestRefine : public QObject {
  Q_OBJECT

private slots:
  void randomMissions_refined_areSafeAndNoDearer() {
    constexpr unsigned seed = 11;
    qInfo("seed %u", seed);
    std::mt19937_64 engine(seed);
    int cheaper = 0;
    for (int i = 0; i < 24; ++i) {
      tour::PlanInput input = randomInput(engine, 1 + i % 8);
      input.mission.planner.lowTargets = i % 3 == 2 ? mission::LowTargets::Descend : mission::LowTargets::PassAbove;
      input.mission.planner.refine = mission::Refine::None;
      const Result<mission::Plan> sampled = tour::planTour(input, Job{});
      input.mission.planner.refine = mission::Refine::Full;
      const Result<mission::Plan> refined = tour::planTour(input, Job{});
      QCOMPARE(refined.has_value(), sampled.has_value());
      if (!refined) {
        continue;
      }
      const mission::PlanMetrics& m = refined->metrics;
      QVERIFY2(faults(input, *refined).empty(), faults(input, *refined).c_str());
      QVERIFY(m.cost <= sampled->metrics.cost * (1.0 + 1e-9));
      QVERIFY(m.movesAccepted <= m.movesTried && m.movesTried > 0);
      // what the refinement thinks that the loop costs is what the assembled loop costs
      QVERIFY2(std::abs(m.sampledCost - sampled->metrics.cost) < 1e-6 * m.sampledCost,
               qPrintable(QString("mission %1: %2, assembled %3").arg(i).arg(m.sampledCost, 0, 'f', 6).arg(sampled->metrics.cost, 0, 'f', 6)));
      QVERIFY(sampled->metrics.sampledCost == 0.0 && sampled->metrics.movesTried == 0);
      cheaper += m.cost < 0.999 * m.sampledCost ? 1 : 0;
    }
    qInfo("%d of 24 became cheaper by more than a thousandth", cheaper);
    QVERIFY(cheaper >= 8);
  }

  void loopCost_underRandomLegs_isTheAssembledProfile() {
    constexpr unsigned seed = 12;
    qInfo("seed %u", seed);
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> height(0.0, 500.0);
    std::uniform_real_distribution<double> step(5.0, 100.0);
    const tour::PitchLimits limits{0.5, 0.3};
    for (int round = 0; round < 500; ++round) {
      const std::size_t count = 1 + engine() % 5;
      std::vector<tour::LegShape> shapes;
      std::vector<std::vector<double>> distances;
      std::vector<std::vector<double>> floors;
      for (std::size_t leg = 0; leg < count; ++leg) {
        std::vector<double> distance{0.0};
        std::vector<double> floor{height(engine)};
        for (std::size_t j = 1 + engine() % 12; j-- > 0;) {
          distance.push_back(distance.back() + step(engine));
          floor.push_back(height(engine));
        }
        shapes.push_back(tour::shapeOf(distance, floor, limits));
        distances.push_back(distance);
        floors.push_back(floor);
      }
      std::vector<const tour::LegShape*> legs;
      std::vector<double> steps;
      std::vector<double> altitude;
      for (std::size_t leg = 0; leg < count; ++leg) {
        legs.push_back(&shapes[leg]);
        const double before = floors[(leg + count - 1) % count].back();
        altitude.push_back(std::max(floors[leg].front(), before));
        for (std::size_t j = 1; j < distances[leg].size(); ++j) {
          steps.push_back(distances[leg][j] - distances[leg][j - 1]);
          if (j + 1 < distances[leg].size()) {
            altitude.push_back(floors[leg][j]);
          }
        }
      }
      tour::raiseForPitchAround(steps, altitude, limits);
      double expected = 0.0;
      std::vector<std::size_t> scratch;
      std::size_t at = 0;
      for (std::size_t leg = 0; leg < count; ++leg) {
        std::vector<double> profile;
        for (std::size_t j = 0; j < distances[leg].size(); ++j) {
          profile.push_back(altitude[(at + j) % altitude.size()]);
        }
        expected += 2.0 * profile.front();
        at += distances[leg].size() - 1;
        tour::concaveMajorant(distances[leg], profile, scratch);
        expected += tour::lengthInSpace(distances[leg], profile);
      }
      tour::LoopCost cost(limits, 2.0, 1e9);
      const std::vector<tour::LoopVisit> visits(count);
      QVERIFY2(std::abs(cost(legs, visits) - expected) < 1e-6 * expected, qPrintable(QString("round %1").arg(round)));
    }
  }

  void sameInput_refinedTwice_givesTheSamePlan() {
    std::mt19937_64 engine(13);
    const tour::PlanInput input = randomInput(engine, 6);
    const mission::Plan one = *tour::planTour(input, Job{});
    const mission::Plan two = *tour::planTour(input, Job{});
    QVERIFY(one.tour == two.tour);
    QVERIFY(one.metrics == two.metrics);
  }

  void cancel_underRefinement_returnsWithin100ms() {
    std::mt19937_64 engine(14);
    const tour::PlanInput input = randomInput(engine, 8);
    using Clock = std::chrono::steady_clock;
    std::stop_source stop;
    Clock::time_point requested;
    std::jthread killer;
    const Job job(stop.get_token(), [&](double, std::string_view text) {
      if (!killer.joinable() && text.starts_with("refined")) {
        killer = std::jthread([&] {
          requested = Clock::now();
          stop.request_stop();
        });
      }
    });
    const Result<mission::Plan> plan = tour::planTour(input, job);
    const auto returned = Clock::now();
    QVERIFY(killer.joinable());
    killer.join();
    QVERIFY(!plan && plan.error().code == Errc::Cancelled);
    qInfo("returned %.1f ms after the request", std::chrono::duration<double, std::milli>(returned - requested).count());
  }
};

QTEST_APPLESS_MAIN(TestRefine)
#include "tst_refine.moc"
