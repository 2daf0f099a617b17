// Property test: exact search, heuristic search and lower bound against brute force.

#include "core/tour/gtsp.h"
#include "core/tour/gtsp_bound.h"
#include "core/tour/gtsp_exact.h"
#include "core/tour/min_arborescence.h"
#include "tests/core/tour/gtsp_cases.h"

#include <QTest>

#include <cmath>

using namespace gtsp_cases;
using vp::Errc;
using vp::Job;
using vp::tour::GtspOptions;

class TestGtspRandom : public QObject {
  Q_OBJECT

private slots:
  void solve_underSmallProblems_agreesWithBruteForce();
  void bound_underMiddleProblems_staysBelowExact();
  void arborescence_underRandomCosts_isTheCheapest();
};

namespace {

constexpr unsigned kSeed = 20240607;

bool close(double a, double b) {
  return a == b || std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(b));
}

/** Cheapest arborescence by trying all parents. */
double cheapest(const std::vector<double>& cost, int n, int v, std::vector<int>& parent) {
  if (v == n) {
    double sum = 0.0;
    for (int w = 1; w < n; ++w) {
      int steps = 0;
      int up = w;
      for (; up != 0 && steps <= n; ++steps) {
        up = parent[static_cast<std::size_t>(up)];
      }
      if (up != 0) {
        return kForbidden;
      }
      sum += cost[static_cast<std::size_t>(parent[static_cast<std::size_t>(w)] * n + w)];
    }
    return sum;
  }
  double best = kForbidden;
  for (int u = 0; u < n; ++u) {
    if (u != v) {
      parent[static_cast<std::size_t>(v)] = u;
      best = std::min(best, cheapest(cost, n, v + 1, parent));
    }
  }
  return best;
}

}  // namespace

void TestGtspRandom::solve_underSmallProblems_agreesWithBruteForce() {
  qInfo("seed %u", kSeed);
  std::mt19937_64 random(kSeed);
  int missed = 0;
  constexpr int kCases = 12000;
  for (int i = 0; i < kCases; ++i) {
    const auto kind = static_cast<Kind>(i % kKinds);
    const int sets = 2 + static_cast<int>(random() % 5);
    const GtspProblem problem = randomProblem(random, sets, sets > 5 ? 3 : 4, kind);
    const double best = bruteForce(problem);
    for (const int exactUpTo : {12, 0}) {
      GtspOptions options;
      options.exactUpToSets = exactUpTo;
      options.seed = random();
      options.effort = 0.1;
      const auto solution = solveGtsp(problem, options, Job());
      if (!solution) {
        QCOMPARE(solution.error().code, Errc::NoSolution);
        QVERIFY2(std::isinf(best), qPrintable(QString("case %1: a tour of cost %2 exists").arg(i).arg(best)));
        continue;
      }
      QVERIFY(isTour(problem, solution->tour));
      QVERIFY(close(solution->cost, costOf(problem, solution->tour)));
      QVERIFY2(solution->lowerBound <= best * (1.0 + 1e-12),
               qPrintable(QString("case %1: bound %2 above %3").arg(i).arg(solution->lowerBound, 0, 'g', 17).arg(best, 0, 'g', 17)));
      QVERIFY2(exactUpTo == 0 || (close(solution->cost, best) && solution->optimal), qPrintable(QString("case %1").arg(i)));
      QVERIFY(!solution->optimal || close(solution->cost, best));
      missed += close(solution->cost, best) ? 0 : 1;
    }
    const auto bound = vp::tour::lowerBound(problem, best, {}, Job());
    QVERIFY(bound.has_value());
    QVERIFY2(*bound <= best * (1.0 + 1e-12), qPrintable(QString("case %1: bound %2 above %3").arg(i).arg(*bound, 0, 'g', 17).arg(best, 0, 'g', 17)));
  }
  QVERIFY2(missed <= kCases / 200, qPrintable(QString("the search missed %1 optima").arg(missed)));
}

void TestGtspRandom::bound_underMiddleProblems_staysBelowExact() {
  qInfo("seed %u", kSeed);
  std::mt19937_64 random(kSeed);
  int missed = 0;
  for (int i = 0; i < 300; ++i) {
    const GtspProblem problem = randomProblem(random, 7 + i % 4, 5, static_cast<Kind>(i / 4 % kKinds));
    const auto exact = vp::tour::solveExactly(problem, kForbidden, Job());
    QVERIFY(exact.has_value());
    const double best = *exact ? costOf(problem, **exact) : kForbidden;
    const auto bound = vp::tour::lowerBound(problem, best, {}, Job());
    QVERIFY(bound.has_value());
    QVERIFY(*bound <= best * (1.0 + 1e-12));
    GtspOptions options;
    options.exactUpToSets = 0;
    options.wantBound = false;
    const auto found = solveGtsp(problem, options, Job());
    missed += found && close(found->cost, best) ? 0 : *exact ? 1 : 0;
  }
  QVERIFY2(missed <= 15, qPrintable(QString("the search missed %1 optima of 300").arg(missed)));
}

void TestGtspRandom::arborescence_underRandomCosts_isTheCheapest() {
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 3000; ++i) {
    const int n = 2 + i % 4;
    std::vector<double> cost(static_cast<std::size_t>(n * n));
    for (double& c : cost) {
      c = static_cast<double>(random() % 20) - 5.0;
    }
    std::vector<int> scratch(static_cast<std::size_t>(n), -1);
    const double best = cheapest(cost, n, 1, scratch);
    const std::vector<int> parent = vp::tour::minArborescence(cost, n, 0);
    double sum = 0.0;
    for (int v = 1; v < n; ++v) {
      sum += cost[static_cast<std::size_t>(parent[static_cast<std::size_t>(v)] * n + v)];
      int up = v;
      for (int steps = 0; steps < n && up != 0; ++steps) {
        up = parent[static_cast<std::size_t>(up)];
      }
      QCOMPARE(up, 0);
    }
    QCOMPARE(sum, best);
  }
}

QTEST_APPLESS_MAIN(TestGtspRandom)
#include "tst_gtsp_random.moc"
