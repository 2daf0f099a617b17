// The solver that keeps its problem: the same answers as a fresh one while costs rise and fall.

#include "core/base/expect.h"
#include "core/tour/gtsp_solver.h"
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
using vp::tour::GtspSolver;
using vp::tour::solveGtsp;

class TestGtspSolver : public QObject {
  Q_OBJECT

private slots:
  void solve_underChangedArcs_agreesWithBruteForce();
  void solve_underChangedArcsOfMiddleProblems_agreesWithFreshSolver();
  void solve_aroundChanges_givesTourAtCostsOfNow();
  void solve_aroundNoChange_givesLastTourAtOnce();
  void solve_aroundForbiddenTour_findsAnother();
  void solve_underMuchDearerArcs_stillAvoidsForbiddenOnes();
  void solve_underSameCalls_givesSameTours();
  void solve_underWrongProblem_givesOutOfRange();
  void set_underWrongArc_throws();
  void solve_underStop_givesCancelledAndKeepsWhatChanged();
};

namespace {

constexpr unsigned kSeed = 20260411;

bool close(double a, double b) {
  return a == b || std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(b));
}

/** Changes some arcs between different sets in the solver and, the same way, in a plain problem. */
void changeArcs(std::mt19937_64& random, GtspSolver& solver, GtspProblem& problem, int count) {
  std::vector<int> setOf(static_cast<std::size_t>(problem.nodes));
  for (std::size_t set = 0; set < problem.sets.size(); ++set) {
    for (const int node : problem.sets[set]) {
      setOf[static_cast<std::size_t>(node)] = static_cast<int>(set);
    }
  }
  for (int k = 0; k < count; ++k) {
    const int from = static_cast<int>(random() % static_cast<unsigned>(problem.nodes));
    const int to = static_cast<int>(random() % static_cast<unsigned>(problem.nodes));
    if (setOf[static_cast<std::size_t>(from)] == setOf[static_cast<std::size_t>(to)]) {
      continue;
    }
    double& cost = problem.cost[static_cast<std::size_t>(from * problem.nodes + to)];
    const double factor = static_cast<double>(random() % 300) / 100.0;
    switch (random() % 4) {
      case 0:
        solver.set(from, to, random() % 8 == 0 ? kForbidden : 3.0 * factor);
        cost = solver.problem().at(from, to);
        break;
      case 1:
        solver.raise(from, to, 0.5 * factor);  // perhaps below what it costs
        cost = std::max(cost, 0.5 * factor);
        break;
      default:
        cost = std::isinf(cost) ? 10.0 * factor : cost * factor;
        solver.set(from, to, cost);
    }
  }
}

}  // namespace

void TestGtspSolver::solve_underChangedArcs_agreesWithBruteForce() {
  qInfo("seed %u", kSeed);
  std::mt19937_64 random(kSeed);
  int missed = 0;
  int solved = 0;
  constexpr int kProblems = 1500;
  constexpr int kSteps = 8;
  for (int i = 0; i < kProblems; ++i) {
    const int sets = 2 + static_cast<int>(random() % 5);
    GtspProblem problem = randomProblem(random, sets, sets > 5 ? 2 : 3, static_cast<Kind>(i % 5));
    GtspSolver solver(problem);
    for (int step = 0; step < kSteps; ++step) {
      GtspOptions options;
      options.seed = random();
      options.exactUpToSets = step % 3 == 0 ? 12 : 0;
      options.effort = 0.1;
      const auto solution = solver.solve(options, Job());
      QCOMPARE(solver.problem().cost, problem.cost);
      const double best = bruteForce(problem);
      QVERIFY2(solution.has_value() == std::isfinite(best) || options.exactUpToSets == 0, qPrintable(QString("case %1").arg(i)));
      ++solved;
      missed += solution ? (close(solution->cost, best) ? 0 : 1) : (std::isfinite(best) ? 1 : 0);
      if (solution) {
        QVERIFY(isTour(problem, solution->tour));
        QVERIFY(close(solution->cost, costOf(problem, solution->tour)));
        QVERIFY(solution->lowerBound <= best * (1.0 + 1e-12));
        QVERIFY(options.exactUpToSets == 0 || close(solution->cost, best));
      }
      changeArcs(random, solver, problem, 1 + i % 12);
    }
  }
  QVERIFY2(missed <= solved / 200, qPrintable(QString("missed %1 optima of %2").arg(missed).arg(solved)));
}

void TestGtspSolver::solve_underChangedArcsOfMiddleProblems_agreesWithFreshSolver() {
  qInfo("seed %u", kSeed);
  std::mt19937_64 random(kSeed);
  int worse = 0;
  for (int i = 0; i < 40; ++i) {
    GtspProblem problem = randomProblem(random, 9, 5, static_cast<Kind>(i % 3));
    GtspSolver solver(problem);
    for (int step = 0; step < 5; ++step) {
      GtspOptions options;
      options.seed = random();
      options.exactUpToSets = 0;
      options.wantBound = false;
      const auto kept = solver.solve(options, Job());
      const auto fresh = solveGtsp(problem, {}, Job());  // exact
      QVERIFY(kept && fresh && fresh->optimal);
      QVERIFY(kept->cost >= fresh->cost * (1.0 - 1e-12));
      worse += close(kept->cost, fresh->cost) ? 0 : 1;
      changeArcs(random, solver, problem, 20);
    }
  }
  QVERIFY2(worse <= 10, qPrintable(QString("worse than exact in %1 of 200").arg(worse)));
}

void TestGtspSolver::solve_aroundChanges_givesTourAtCostsOfNow() {
  qInfo("seed %u", kSeed);
  std::mt19937_64 random(kSeed);
  int optimal = 0;
  int solved = 0;
  for (int i = 0; i < 60; ++i) {
    GtspProblem problem = randomProblem(random, 8, 5, Kind::Metric);
    GtspSolver solver(problem);
    GtspOptions options;
    options.aroundChanges = true;
    options.exactUpToSets = 0;
    std::vector<int> tour;
    for (int round = 0; round < 10; ++round) {
      options.seed = random();
      const double before = tour.empty() ? kForbidden : costOf(problem, tour);
      const auto solution = solver.solve(options, Job());
      QVERIFY(solution.has_value());
      QVERIFY(isTour(problem, solution->tour));
      QVERIFY(close(solution->cost, costOf(problem, solution->tour)));
      QVERIFY(solution->cost <= before * (1.0 + 1e-12));
      const auto exact = solveGtsp(problem, {}, Job());
      QVERIFY(exact && solution->cost >= exact->cost * (1.0 - 1e-12));
      ++solved;
      optimal += close(solution->cost, exact->cost) ? 1 : 0;
      tour = solution->tour;
      for (std::size_t k = random() % 3; k < tour.size(); k += 3) {  // as a lazy round does
        const int from = tour[k];
        const int to = tour[(k + 1) % tour.size()];
        const double cost = problem.at(from, to) * (1.0 + static_cast<double>(random() % 100) / 200.0);
        problem.cost[static_cast<std::size_t>(from * problem.nodes + to)] = cost;
        solver.raise(from, to, cost);
      }
    }
  }
  QVERIFY2(optimal >= 9 * solved / 10, qPrintable(QString("the optimum in %1 of %2 rounds").arg(optimal).arg(solved)));
}

void TestGtspSolver::solve_aroundNoChange_givesLastTourAtOnce() {
  std::mt19937_64 random(kSeed);
  GtspSolver solver(randomProblem(random, 15, 6, Kind::Metric));
  GtspOptions options;
  const auto whole = solver.solve(options, Job());
  options.aroundChanges = true;
  const auto again = solver.solve(options, Job());
  QVERIFY(whole && again);
  QCOMPARE(again->tour, whole->tour);
  QCOMPARE(again->rounds, std::int64_t{0});
  const int from = whole->tour[0];
  const int to = whole->tour[2];  // an arc that the tour does not use
  solver.raise(from, to, 10.0 * solver.problem().at(from, to));
  const auto third = solver.solve(options, Job());
  QVERIFY(third.has_value());
  QCOMPARE(third->tour, whole->tour);
  QCOMPARE(third->rounds, std::int64_t{0});
}

void TestGtspSolver::solve_aroundForbiddenTour_findsAnother() {
  std::mt19937_64 random(kSeed);
  GtspSolver solver(randomProblem(random, 14, 4, Kind::Metric));
  GtspOptions options;
  options.aroundChanges = true;
  for (int round = 0; round < 5; ++round) {
    const auto solution = solver.solve(options, Job());
    QVERIFY(solution.has_value());
    QVERIFY(std::isfinite(costOf(solver.problem(), solution->tour)));
    for (std::size_t k = 0; k < solution->tour.size(); ++k) {
      solver.set(solution->tour[k], solution->tour[(k + 1) % solution->tour.size()], kForbidden);
    }
  }
}

void TestGtspSolver::solve_underMuchDearerArcs_stillAvoidsForbiddenOnes() {
  std::mt19937_64 random(kSeed);
  GtspProblem problem = randomProblem(random, 10, 2, Kind::Whole);
  std::fill(problem.cost.begin(), problem.cost.end(), kForbidden);
  GtspSolver solver(problem);
  GtspOptions options;
  options.exactUpToSets = 0;
  QVERIFY(!solver.solve(options, Job()));
  for (const double cost : {1.0, 1e6, 1e12}) {  // the only loop gets dearer than anything the solver was built for
    for (std::size_t set = 0; set < problem.sets.size(); ++set) {
      solver.set(problem.sets[set].back(), problem.sets[(set + 1) % problem.sets.size()].back(), cost);
    }
    const auto solution = solver.solve(options, Job());
    QVERIFY(solution.has_value());
    QCOMPARE(solution->cost, 10.0 * cost);
  }
}

void TestGtspSolver::solve_underSameCalls_givesSameTours() {
  std::vector<std::vector<int>> tours[2];
  for (auto& run : tours) {
    std::mt19937_64 random(kSeed);
    GtspProblem problem = randomProblem(random, 25, 6, Kind::Metric);
    GtspSolver solver(problem);
    for (int round = 0; round < 12; ++round) {
      GtspOptions options;
      options.seed = 7;
      options.effort = 0.1;
      options.wantBound = false;
      options.aroundChanges = round % 3 != 0;
      const auto solution = solver.solve(options, Job());
      QVERIFY(solution.has_value());
      run.push_back(solution->tour);
      changeArcs(random, solver, problem, 30);
    }
  }
  QCOMPARE(tours[0], tours[1]);
}

void TestGtspSolver::solve_underWrongProblem_givesOutOfRange() {
  GtspSolver solver(GtspProblem{2, {{0}, {0, 1}}, {0.0, 1.0, 1.0, 0.0}});
  const auto result = solver.solve({}, Job());
  QVERIFY(!result);
  QCOMPARE(result.error().code, Errc::OutOfRange);
}

void TestGtspSolver::set_underWrongArc_throws() {
  GtspSolver solver(GtspProblem{3, {{0, 1}, {2}}, std::vector<double>(9, 1.0)});
  QVERIFY_THROWS_EXCEPTION(vp::LogicError, solver.set(0, 1, 1.0));  // inside a set
  QVERIFY_THROWS_EXCEPTION(vp::LogicError, solver.set(0, 3, 1.0));
  QVERIFY_THROWS_EXCEPTION(vp::LogicError, solver.set(0, 2, -1.0));
  QVERIFY_THROWS_EXCEPTION(vp::LogicError, solver.raise(0, 2, std::nan("")));
}

void TestGtspSolver::solve_underStop_givesCancelledAndKeepsWhatChanged() {
  std::mt19937_64 random(kSeed);
  GtspSolver solver(randomProblem(random, 60, 16, Kind::Metric));
  GtspOptions options;
  options.effort = 0.01;
  options.wantBound = false;
  const auto first = solver.solve(options, Job());
  QVERIFY(first.has_value());
  solver.raise(first->tour[0], first->tour[1], 1e7);
  std::stop_source stop;
  {
    std::jthread stopper([&stop] { stop.request_stop(); });
    options.seconds = 1e6;  // would end by the stop alone
    const auto stopped = solver.solve(options, Job(stop.get_token()));
    QVERIFY(!stopped);
    QCOMPARE(stopped.error().code, Errc::Cancelled);
  }
  options.seconds.reset();
  options.aroundChanges = true;
  QVERIFY(!solver.solve(options, Job(stop.get_token())));
  const auto second = solver.solve(options, Job());
  QVERIFY(second.has_value());
  QVERIFY(second->rounds > 0);
  QVERIFY(second->cost < 1e7);
}

QTEST_APPLESS_MAIN(TestGtspSolver)
#include "tst_gtsp_solver.moc"
