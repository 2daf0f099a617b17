#include "core/tour/gtsp.h"
#include "core/tour/lkh_files.h"
#include "core/tour/noon_bean.h"
#include "tests/core/tour/gtsp_cases.h"

#include <QTest>

#include <cmath>
#include <stop_token>
#include <thread>

using namespace gtsp_cases;
using vp::Errc;
using vp::Job;
using vp::tour::decodeNoonBean;
using vp::tour::GtspOptions;
using vp::tour::NoonBean;
using vp::tour::solveGtspWithLkh;
using vp::tour::transformNoonBean;

class TestLkh : public QObject {
  Q_OBJECT

private slots:
  void transformation_underOptimalAtspTour_decodesToOptimalTour();
  void transformation_underLargeAndSmallCosts_staysInInts();
  void parseTourFile_underBadText_givesBadFile();
  void solve_underFakeProgram_givesTour();
  void solve_underWarmStart_isNeverWorse();
  void solve_underMissingProgram_givesUnsupported();
  void solve_underRubbish_givesBadFile();
  void solve_underStop_killsAndGivesCancelled();
};

namespace {

std::string fakeLkh() {
  return std::string(VOLPLANE_BIN_DIR) + "/fake_lkh";
}

/** The best tour of an ATSP by dynamic programming over subsets, all nodes from 0. */
std::vector<int> bestAtspTour(const NoonBean& atsp) {
  const auto n = static_cast<std::size_t>(atsp.nodes);
  const std::size_t full = std::size_t{1} << n;
  std::vector<long> value(full * n, std::numeric_limits<long>::max() / 4);
  std::vector<std::size_t> from(full * n, 0);
  value[1 * n] = 0;
  for (std::size_t mask = 1; mask < full; mask += 2) {
    for (std::size_t u = 0; u < n; ++u) {
      for (std::size_t v = 1; v < n && (mask >> u & 1U) != 0; ++v) {
        const std::size_t next = mask | std::size_t{1} << v;
        const long sum = value[mask * n + u] + atsp.cost[u * n + v];
        if (next != mask && sum < value[next * n + v]) {
          value[next * n + v] = sum;
          from[next * n + v] = u;
        }
      }
    }
  }
  std::size_t best = 0;
  long least = std::numeric_limits<long>::max();
  for (std::size_t u = n > 1 ? 1 : 0; u < n; ++u) {
    const long sum = value[(full - 1) * n + u] + atsp.cost[u * n];
    if (sum < least) {
      least = sum;
      best = u;
    }
  }
  std::vector<int> tour;
  for (std::size_t mask = full - 1; tour.size() < n;) {
    tour.push_back(static_cast<int>(best));
    const std::size_t before = from[mask * n + best];
    mask &= ~(std::size_t{1} << best);
    best = before;
  }
  std::reverse(tour.begin(), tour.end());
  return tour;
}

}  // namespace

void TestLkh::transformation_underOptimalAtspTour_decodesToOptimalTour() {
  constexpr unsigned kSeed = 41;
  qInfo("seed %u", kSeed);
  std::mt19937_64 random(kSeed);
  int compared = 0;
  for (int i = 0; i < 1500; ++i) {
    const GtspProblem problem = randomProblem(random, 2 + i % 4, 3, static_cast<Kind>(i / 4 % 5));
    if (problem.nodes > 11) {
      continue;
    }
    const double best = bruteForce(problem);
    const auto atsp = transformNoonBean(problem);
    QVERIFY(atsp.has_value());
    const std::vector<int> tour = decodeNoonBean(problem, bestAtspTour(*atsp));
    QCOMPARE(tour.size(), problem.sets.size());
    if (std::isinf(best)) {
      QVERIFY(std::isinf(costOf(problem, tour)));
      continue;
    }
    const double rounding = static_cast<double>(problem.sets.size()) / atsp->scale;
    QVERIFY(costOf(problem, tour) <= best + (atsp->scale == 1.0 && i / 4 % 5 != 1 ? 0.0 : rounding) + 1e-9);
    ++compared;
  }
  QVERIFY(compared > 500);
}

void TestLkh::transformation_underLargeAndSmallCosts_staysInInts() {
  for (const double factor : {1e-9, 1e-3, 1.0, 1e3, 1e9, 1e15}) {
    std::mt19937_64 random(3);
    GtspProblem problem = randomProblem(random, 30, 8, Kind::Forbidden);
    for (double& cost : problem.cost) {
      cost *= factor;
    }
    const auto atsp = transformNoonBean(problem);
    QVERIFY(atsp.has_value());
    QVERIFY(std::all_of(atsp->cost.begin(), atsp->cost.end(), [](int c) { return c >= 0; }));
    QVERIFY(static_cast<double>(atsp->forbiddenCost) * problem.nodes < 2147483647.0);
  }
}

void TestLkh::parseTourFile_underBadText_givesBadFile() {
  for (const char* text : {"", "TOUR_SECTION\n1\n2\n", "TOUR_SECTION\n1\n2\n2\n-1\n", "TOUR_SECTION\n1\n2\n9\n", "TOUR_SECTION 1 x 2"}) {
    const auto tour = vp::tour::parseTourFile(text, 3, "a.tour");
    QVERIFY(!tour);
    QCOMPARE(tour.error().code, Errc::BadFile);
  }
  const auto good = vp::tour::parseTourFile(vp::tour::toTourFile({2, 0, 1}), 3, "a.tour");
  QVERIFY(good.has_value());
  QCOMPARE(*good, (std::vector<int>{2, 0, 1}));
}

void TestLkh::solve_underFakeProgram_givesTour() {
  std::mt19937_64 random(5);
  for (int i = 0; i < 6; ++i) {
    const GtspProblem problem = randomProblem(random, 5 + i, 4, i % 2 == 0 ? Kind::Whole : Kind::Real);
    const auto solution = solveGtspWithLkh(problem, {}, fakeLkh(), Job());
    QVERIFY2(solution.has_value(), solution ? "" : solution.error().message().c_str());
    QVERIFY(isTour(problem, solution->tour));
    QVERIFY(std::abs(costOf(problem, solution->tour) - solution->cost) < 1e-9);
    QVERIFY(solution->lowerBound <= solution->cost);
  }
}

void TestLkh::solve_underWarmStart_isNeverWorse() {
  std::mt19937_64 random(6);
  const GtspProblem problem = randomProblem(random, 8, 4, Kind::Whole);
  GtspOptions options;
  const auto best = vp::tour::solveGtsp(problem, options, Job());
  QVERIFY(best.has_value());
  options.warmStart = best->tour;
  const auto solution = solveGtspWithLkh(problem, options, fakeLkh(), Job());
  QVERIFY(solution.has_value());
  QCOMPARE(solution->cost, best->cost);
}

void TestLkh::solve_underMissingProgram_givesUnsupported() {
  std::mt19937_64 random(6);
  const GtspProblem problem = randomProblem(random, 6, 3, Kind::Whole);
  for (const char* program : {"", "/nowhere/LKH", "no-such-program-as-this"}) {
    const auto solution = solveGtspWithLkh(problem, {}, program, Job());
    QVERIFY(!solution);
    QCOMPARE(solution.error().code, Errc::Unsupported);
  }
}

void TestLkh::solve_underRubbish_givesBadFile() {
  std::mt19937_64 random(6);
  const GtspProblem problem = randomProblem(random, 6, 3, Kind::Whole);
  GtspOptions options;
  options.seed = 13;  // the fake answers nonsense
  const auto nonsense = solveGtspWithLkh(problem, options, fakeLkh(), Job());
  QVERIFY(!nonsense);
  QCOMPARE(nonsense.error().code, Errc::BadFile);
  const auto nothing = solveGtspWithLkh(problem, {}, "/bin/true", Job());
  QVERIFY(!nothing);
  QCOMPARE(nothing.error().code, Errc::BadFile);
}

void TestLkh::solve_underStop_killsAndGivesCancelled() {
  std::mt19937_64 random(6);
  const GtspProblem problem = randomProblem(random, 6, 3, Kind::Whole);
  GtspOptions options;
  options.seed = 66;  // the fake never ends
  std::stop_source stop;
  std::jthread stopper([&stop] { stop.request_stop(); });
  const auto solution = solveGtspWithLkh(problem, options, fakeLkh(), Job(stop.get_token()));
  QVERIFY(!solution);
  QCOMPARE(solution.error().code, Errc::Cancelled);
}

QTEST_APPLESS_MAIN(TestLkh)
#include "tst_lkh.moc"
