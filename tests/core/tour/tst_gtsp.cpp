#include "core/tour/gtsp.h"
#include "tests/core/tour/gtsp_cases.h"

#include <QTest>

#include <cmath>
#include <stop_token>
#include <thread>

using namespace gtsp_cases;
using vp::Errc;
using vp::Job;
using vp::tour::GtspOptions;
using vp::tour::GtspSolution;
using vp::tour::solveGtsp;

class TestGtsp : public QObject {
  Q_OBJECT

private slots:
  void solve_underNoSets_givesOutOfRange();
  void solve_underWrongInput_givesOutOfRange();
  void solve_underOneSet_givesItsFirstNodeForNothing();
  void solve_underTwoAndThreeSets_givesOptimum();
  void solve_underSetsOfOneNode_givesOptimum();
  void solve_underSameSeed_givesSameTour();
  void solve_underRotation_startsInSetZero();
  void solve_underWarmStart_isNeverWorse();
  void solve_underUnreachableSet_givesNoSolution();
  void solve_underOneOpenLoop_findsIt();
  void solve_underHugePlaceholderCosts_avoidsThem();
  void solve_underStoppedJob_givesCancelled();
  void solve_underStopInSearch_givesCancelled();
  void solve_underTimeLimit_givesTour();
};

namespace {

GtspProblem problemOf(int sets, int nodes, Kind kind, unsigned seed) {
  std::mt19937_64 random(seed);
  return randomProblem(random, sets, nodes, kind);
}

GtspSolution solved(const GtspProblem& problem, const GtspOptions& options = {}) {
  const auto result = solveGtsp(problem, options, Job());
  return result ? *result : GtspSolution{};
}

}  // namespace

void TestGtsp::solve_underNoSets_givesOutOfRange() {
  const auto result = solveGtsp({}, {}, Job());
  QVERIFY(!result);
  QCOMPARE(result.error().code, Errc::OutOfRange);
}

void TestGtsp::solve_underWrongInput_givesOutOfRange() {
  const GtspProblem good = problemOf(5, 3, Kind::Whole, 1);
  std::vector<GtspProblem> bad(5, good);
  bad[0].sets[1].clear();
  bad[1].sets[1][0] = bad[1].sets[0][0];
  bad[2].cost.pop_back();
  bad[3].cost[1] = -1.0;
  bad[4].cost[1] = std::nan("");
  for (const GtspProblem& problem : bad) {
    const auto result = solveGtsp(problem, {}, Job());
    QVERIFY(!result);
    QCOMPARE(result.error().code, Errc::OutOfRange);
  }
  GtspOptions options;
  options.warmStart = std::vector<int>{good.sets[0][0], good.sets[0][0], 1, 2, 3};
  QVERIFY(!solveGtsp(good, options, Job()));
  options.warmStart = std::vector<int>{good.sets[0][0]};
  QVERIFY(!solveGtsp(good, options, Job()));
}

void TestGtsp::solve_underOneSet_givesItsFirstNodeForNothing() {
  const GtspProblem problem{2, {{1, 0}}, {5.0, 5.0, 5.0, 5.0}};
  const GtspSolution solution = solved(problem);
  QCOMPARE(solution.tour, std::vector<int>{1});
  QCOMPARE(solution.cost, 0.0);
  QVERIFY(solution.optimal);
}

void TestGtsp::solve_underTwoAndThreeSets_givesOptimum() {
  for (const int sets : {2, 3}) {
    for (unsigned seed = 0; seed < 200; ++seed) {
      const GtspProblem problem = problemOf(sets, 4, Kind::Real, seed);
      GtspOptions options;
      options.exactUpToSets = 0;
      const GtspSolution solution = solved(problem, options);
      QVERIFY(isTour(problem, solution.tour));
      QVERIFY(std::abs(solution.cost - bruteForce(problem)) < 1e-9);
    }
  }
}

void TestGtsp::solve_underSetsOfOneNode_givesOptimum() {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const GtspProblem problem = problemOf(7, 1, Kind::Whole, seed);
    GtspOptions options;
    options.exactUpToSets = seed % 2 == 0 ? 12 : 0;
    QCOMPARE(solved(problem, options).cost, bruteForce(problem));
  }
}

void TestGtsp::solve_underSameSeed_givesSameTour() {
  const GtspProblem problem = problemOf(25, 6, Kind::Real, 4);
  GtspOptions options;
  options.seed = 77;
  const GtspSolution first = solved(problem, options);
  const GtspSolution second = solved(problem, options);
  QVERIFY(isTour(problem, first.tour));
  QCOMPARE(first.tour, second.tour);
  QCOMPARE(first.cost, second.cost);
  QCOMPARE(first.lowerBound, second.lowerBound);
  QCOMPARE(first.rounds, second.rounds);
}

void TestGtsp::solve_underRotation_startsInSetZero() {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const GtspProblem problem = problemOf(6 + static_cast<int>(seed), 4, Kind::Metric, seed);
    const GtspSolution solution = solved(problem);
    QVERIFY(isTour(problem, solution.tour));
    QVERIFY(std::abs(costOf(problem, solution.tour) - solution.cost) <= 1e-9 * solution.cost);
  }
}

void TestGtsp::solve_underWarmStart_isNeverWorse() {
  std::mt19937_64 random(9);
  for (int i = 0; i < 200; ++i) {
    const GtspProblem problem = randomProblem(random, 4 + i % 12, 5, i % 2 == 0 ? Kind::Whole : Kind::Real);
    GtspOptions options;
    options.effort = 1e-3;
    options.exactUpToSets = 0;
    options.wantBound = false;
    const GtspSolution cold = solved(problem, options);
    options.warmStart = cold.tour;
    std::rotate(options.warmStart->begin(), options.warmStart->begin() + i % std::ssize(cold.tour), options.warmStart->end());
    options.seed = 5;
    const GtspSolution warm = solved(problem, options);
    QVERIFY(isTour(problem, warm.tour));
    QVERIFY(warm.cost <= cold.cost);
  }
}

void TestGtsp::solve_underUnreachableSet_givesNoSolution() {
  for (const int sets : {2, 3, 8, 15}) {
    GtspProblem problem = problemOf(sets, 3, Kind::Whole, 3);
    for (const int node : problem.sets.back()) {
      for (int tail = 0; tail < problem.nodes; ++tail) {
        problem.cost[static_cast<std::size_t>(tail * problem.nodes + node)] = kForbidden;
      }
    }
    const auto result = solveGtsp(problem, {}, Job());
    QVERIFY(!result);
    QCOMPARE(result.error().code, Errc::NoSolution);
  }
}

void TestGtsp::solve_underOneOpenLoop_findsIt() {
  // Everything is forbidden but one loop, so the search must climb out of forbidden tours.
  for (const int sets : {9, 14, 20}) {
    GtspProblem problem = problemOf(sets, 3, Kind::Whole, 12);
    std::fill(problem.cost.begin(), problem.cost.end(), kForbidden);
    for (std::size_t set = 0; set < problem.sets.size(); ++set) {
      const int tail = problem.sets[set].back();
      const int head = problem.sets[(set + 1) % problem.sets.size()].back();
      problem.cost[static_cast<std::size_t>(tail * problem.nodes + head)] = 1.0;
    }
    const GtspSolution solution = solved(problem);
    QCOMPARE(solution.cost, static_cast<double>(sets));
    QVERIFY(solution.optimal);
  }
}

void TestGtsp::solve_underHugePlaceholderCosts_avoidsThem() {
  GtspProblem problem = problemOf(11, 4, Kind::Whole, 8);
  const GtspSolution plain = solved(problem);
  QVERIFY(plain.optimal);
  for (double& cost : problem.cost) {
    cost = cost > 800.0 ? 1e12 : cost;
  }
  GtspOptions options;
  options.exactUpToSets = 0;
  options.effort = 10.0;
  QCOMPARE(solved(problem, options).cost, plain.cost);
}

void TestGtsp::solve_underStoppedJob_givesCancelled() {
  std::stop_source stop;
  stop.request_stop();
  const auto result = solveGtsp(problemOf(30, 5, Kind::Whole, 2), {}, Job(stop.get_token()));
  QVERIFY(!result);
  QCOMPARE(result.error().code, Errc::Cancelled);
}

void TestGtsp::solve_underStopInSearch_givesCancelled() {
  for (const int sets : {12, 60}) {
    std::stop_source stop;
    std::jthread stopper([&stop] { stop.request_stop(); });
    GtspOptions options;
    options.effort = 1e6;
    options.seconds = sets == 60 ? std::optional<double>(1e6) : std::nullopt;
    const auto result = solveGtsp(problemOf(sets, 16, Kind::Whole, 2), options, Job(stop.get_token()));
    if (sets == 60) {
      QVERIFY(!result);
    }
    QVERIFY(result || result.error().code == Errc::Cancelled);
  }
}

void TestGtsp::solve_underTimeLimit_givesTour() {
  const GtspProblem problem = problemOf(40, 5, Kind::Metric, 2);
  GtspOptions options;
  for (const double seconds : {0.0, 0.05}) {
    options.seconds = seconds;
    const GtspSolution solution = solved(problem, options);
    QVERIFY(isTour(problem, solution.tour));
    QVERIFY(solution.lowerBound <= solution.cost);
  }
}

QTEST_APPLESS_MAIN(TestGtsp)
#include "tst_gtsp.moc"
