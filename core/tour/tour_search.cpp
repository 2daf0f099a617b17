#include "core/tour/tour_search.h"

#include "core/tour/gtsp_bound.h"
#include "core/tour/gtsp_node_choice.h"
#include "core/tour/gtsp_solver.h"
#include "core/tour/segment_bound.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <optional>
#include <thread>
#include <utility>

namespace vp::tour {
namespace {

using Clock = std::chrono::steady_clock;

/** How thoroughly a round looks for a tour: around what changed, then a short search of everything, then the full one. A
 *  stage follows when the tour of the one before is safe; the first follows when a leg was raised. */
enum class Thoroughness { AroundChanges, Short, Full };

/** Effort of the tour solver. The full search of 100 targets would take 2.5 s, three times over; with this it ends at the same
 *  cost on the mountain. */
double effortOf(Thoroughness stage, std::size_t targets) {
  const double share = 1.0 / static_cast<double>(targets);
  return stage == Thoroughness::Full ? std::clamp(30.0 * share, 0.25, 1.0) : std::clamp(5.0 * share, 0.05, 0.15);
}

/// Arcs to that many nearest targets begin with the bound of their leg, the others only where a tour wants them.
constexpr std::size_t kNearTargets = 25;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/** The tour problem while its costs are being found out. */
class Search {
public:
  Search(const landing::World& world, const landing::Roadmap& roadmap, const Detours& detours, const std::vector<VisitPose>& visits,
         const SegmentSettings& settings, const SearchOptions& options, const Job& job)
      : world_(world), roadmap_(roadmap), detours_(detours), visits_(visits), settings_(settings), options_(options), job_(job) {
    const auto count = visits.size();
    problem_.nodes = static_cast<int>(count);
    problem_.cost.assign(count * count, kForbidden);
    level_.assign(count * count, Level::Plain);
    for (std::size_t i = 0; i < count; ++i) {
      if (i == 0 || visits[i].target != visits[i - 1].target) {
        problem_.sets.emplace_back();
      }
      problem_.sets.back().push_back(static_cast<int>(i));
      setOf_.push_back(static_cast<int>(problem_.sets.size()) - 1);
    }
  }

  Result<SearchResult> run() {
    if (visits_.empty()) {
      return fail(Errc::NoSolution, "the mission has no targets");
    }
    if (Result<void> ready = prepare(); !ready) {
      return forward(ready);
    }
    Result<SearchResult> found = options_.method == mission::Method::Base ? base() : lazy();
    if (found) {
      for (const SegmentBuilder& builder : builders_) {
        found->safeQueries += builder.queries();
      }
    }
    return found;
  }

private:
  /// What the cost of an arc is.
  enum class Level : char {
    Plain,  ///< SegmentBound::plain
    Leg,    ///< SegmentBound::leg
    Safe    ///< SegmentBuilder::safeSegment
  };

  [[nodiscard]] std::size_t index(int from, int to) const { return static_cast<std::size_t>(from) * visits_.size() + static_cast<std::size_t>(to); }
  [[nodiscard]] const VisitPose& visit(int node) const { return visits_[static_cast<std::size_t>(node)]; }
  [[nodiscard]] const GtspProblem& problem() const { return solver_ ? solver_->problem() : problem_; }

  [[nodiscard]] bool mayConnect(std::size_t from, std::size_t to) const {
    // a single target is visited by a circle from a pose to itself
    return problem_.sets.size() == 1 ? from == to : visits_[from].target != visits_[to].target;
  }

  /// The altitude floor, and A of all visits.
  Result<void> prepare() {
    const auto start = Clock::now();
    result_.floor = options_.floor;
    if (!result_.floor) {
      auto built = buildFloor(world_, visits_, job_);
      if (!built) {
        return forward(built);
      }
      result_.floor = std::move(*built);
    }
    for (int t = 0; t < std::max(1, options_.threads); ++t) {
      builders_.emplace_back(world_, roadmap_, detours_, settings_, job_.stopToken(), result_.floor.get());
      bounds_.emplace_back(world_, *result_.floor, detours_, settings_);
    }
    for (VisitPose& visit : visits_) {
      if (job_.stopRequested()) {
        return stopped();
      }
      builders_.front().ask(visit);
    }
    result_.terrainSeconds += secondsSince(start);
    return {};
  }

  /// Fills all costs with `cost` of from, to and thread, in rows shared among the threads. False when stopped.
  template <typename Cost>
  bool fillAll(const char* what, double from, double to, Cost cost) {
    const Job part = job_.part(from, to);
    std::atomic<std::size_t> next{0};
    const auto work = [&](std::size_t thread) {
      for (std::size_t row = next++; row < visits_.size(); row = next++) {
        for (std::size_t column = 0; column < visits_.size(); ++column) {
          if (part.stopRequested()) {
            return;
          }
          if (mayConnect(row, column)) {
            problem_.cost[row * visits_.size() + column] = cost(static_cast<int>(row), static_cast<int>(column), thread);
          }
        }
        part.progress(static_cast<double>(row + 1) / static_cast<double>(visits_.size()),
                      fmt::format("{}: {} of {} visits", what, row + 1, visits_.size()));
      }
    };
    if (builders_.size() == 1) {
      work(0);
    } else {
      std::vector<std::jthread> threads;
      for (std::size_t thread = 0; thread < builders_.size(); ++thread) {
        threads.emplace_back([&work, thread] { work(thread); });
      }
    }
    return !part.stopRequested();
  }

  Result<GtspSolution> solve(Thoroughness stage) {
    const auto start = Clock::now();
    GtspOptions gtsp;
    gtsp.seed = options_.seed + static_cast<std::uint64_t>(result_.tourSolutions);
    gtsp.wantBound = false;  // once, by finish()
    gtsp.effort = effortOf(stage, problem_.sets.size());
    gtsp.aroundChanges = stage == Thoroughness::AroundChanges;
    if (!settled_.empty()) {
      gtsp.warmStart = settled_;
    }
    Result<GtspSolution> solution = !solver_ ? singleTarget()
                                    : options_.solver == mission::TourSolver::Lkh
                                        ? solveGtspWithLkh(problem(), gtsp, options_.lkhProgram, job_.part(0.5, 0.5))
                                        : solver_->solve(gtsp, job_.part(0.5, 0.5));
    ++result_.tourSolutions;
    result_.solverSeconds += secondsSince(start);
    return solution;
  }

  void startSolver() {
    if (problem_.sets.size() > 1) {
      solver_.emplace(std::move(problem_));
      problem_.sets = solver_->problem().sets;
    }
  }

  [[nodiscard]] Result<GtspSolution> singleTarget() const {
    GtspSolution best;
    for (int i = 0; i < problem_.nodes; ++i) {
      if (problem_.at(i, i) < best.cost) {
        best = {{i}, problem_.at(i, i), problem_.at(i, i), true, 1};
      }
    }
    if (!std::isfinite(best.cost)) {
      return fail(Errc::NoSolution, "no safe circle over the only target");
    }
    return best;
  }

  static tl::unexpected<Error> stopped() { return fail(Errc::Cancelled, "stopped while planning the tour"); }

  Result<SearchResult> base() {
    const auto start = Clock::now();
    const bool done = fillAll("safe segments", 0.0, 0.9,
                              [this](int from, int to, std::size_t thread) { return builders_[thread].safeSegment(visit(from), visit(to)).cost; });
    if (!done) {
      return stopped();
    }
    result_.safeSeconds = secondsSince(start);
    result_.safeSegments = std::count_if(problem_.cost.begin(), problem_.cost.end(), [](double cost) { return std::isfinite(cost); });
    startSolver();
    const Result<GtspSolution> solution = solve(Thoroughness::Full);
    if (!solution) {
      return forward(solution);
    }
    return finish(*solution);
  }

  void raise(int from, int to, double cost, Level level) {
    level_[index(from, to)] = level;
    if (solver_) {
      solver_->raise(from, to, cost);
    } else {
      double& stored = problem_.cost[index(from, to)];
      stored = std::max(stored, cost);
    }
  }

  /// Works out the legs between all headings of two targets.
  void raiseToLegs(int from, int to) {
    for (const int a : problem_.sets[static_cast<std::size_t>(setOf_[static_cast<std::size_t>(from)])]) {
      for (const int b : problem_.sets[static_cast<std::size_t>(setOf_[static_cast<std::size_t>(to)])]) {
        if (level_[index(a, b)] == Level::Plain) {
          raise(a, b, bounds_.front().leg(visit(a), visit(b)).cost, Level::Leg);
          ++result_.boundSegments;
        }
      }
    }
  }

  /// Raises the arcs of a tour by a level if they are not safe yet. @return how many
  int raiseArcs(const std::vector<int>& tour) {
    int raised = 0;
    for (std::size_t i = 0; i < tour.size() && !job_.stopRequested(); ++i) {
      const int from = tour[i];
      const int to = tour[(i + 1) % tour.size()];
      const Level level = level_[index(from, to)];
      if (level == Level::Safe) {
        continue;
      }
      ++raised;
      if (level == Level::Plain) {
        raiseToLegs(from, to);
      } else {
        raise(from, to, builders_.front().safeSegment(visit(from), visit(to)).cost, Level::Safe);
        ++result_.safeSegments;
      }
    }
    return raised;
  }

  /** Makes the tour's order safe: raises its arcs, chooses the best headings for the order anew, and so on until these hold
   *  only safe arcs. Much cheaper than a solution of the whole problem for each step. @return arcs raised */
  int settle() {
    const auto start = Clock::now();
    settled_ = tour_;
    int total = 0;
    for (;;) {
      const int raised = raiseArcs(settled_);
      total += raised;
      if (raised == 0 || job_.stopRequested() || !solver_) {
        break;
      }
      settled_ = bestNodesForOrder(problem(), setOf_, settled_);
    }
    result_.safeSeconds += secondsSince(start);
    return total;
  }

  /// Pairs of targets that begin with the bounds of their legs: those of which one is among the nearest of the other.
  [[nodiscard]] std::vector<char> nearPairs() const {
    const std::size_t count = problem_.sets.size();
    std::vector<char> isNear(count * count, 0);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t a = 0; a < count; ++a) {
      order.clear();
      for (std::size_t b = 0; b < count; ++b) {
        order.emplace_back(geo::distance(visit(problem_.sets[a].front()).pose.point(), visit(problem_.sets[b].front()).pose.point()), b);
      }
      std::sort(order.begin(), order.end());
      for (std::size_t i = 0; i < std::min(count, kNearTargets + 1); ++i) {
        isNear[a * count + order[i].second] = 1;
        isNear[order[i].second * count + a] = 1;
      }
    }
    return isNear;
  }

  bool fillWithBounds() {
    const auto start = Clock::now();
    const std::vector<char> isNear = nearPairs();
    std::atomic<std::int64_t> legs{0};
    const bool done = fillAll("bounds", 0.0, 0.2, [&](int from, int to, std::size_t thread) {
      const auto a = static_cast<std::size_t>(setOf_[static_cast<std::size_t>(from)]);
      const auto b = static_cast<std::size_t>(setOf_[static_cast<std::size_t>(to)]);
      if (isNear[a * problem_.sets.size() + b] == 0) {
        return bounds_[thread].plain(visit(from), visit(to));
      }
      level_[index(from, to)] = Level::Leg;
      legs.fetch_add(1, std::memory_order_relaxed);
      return bounds_[thread].leg(visit(from), visit(to)).cost;
    });
    result_.boundSegments += legs;
    result_.terrainSeconds += secondsSince(start);
    return done;
  }

  Result<SearchResult> lazy() {
    if (!fillWithBounds()) {
      return stopped();
    }
    startSolver();
    Thoroughness stage = Thoroughness::AroundChanges;
    for (;;) {
      const Result<GtspSolution> solution = solve(stage);
      if (!solution) {
        return forward(solution);
      }
      tour_ = solution->tour;
      tellRound(*solution);
      const int raised = settle();
      if (job_.stopRequested()) {
        return stopped();
      }
      const bool isExact = solution->optimal;  // then another search would find nothing better
      if (raised == 0 && (stage == Thoroughness::Full || isExact)) {
        return finish(*solution);
      }
      stage = raised > 0 ? Thoroughness::AroundChanges : stage == Thoroughness::AroundChanges ? Thoroughness::Short : Thoroughness::Full;
      const double spread = static_cast<double>(result_.tourSolutions) / (static_cast<double>(result_.tourSolutions) + 2.0);  // few rounds
      job_.progress(0.2 + 0.75 * spread,
                    fmt::format("lazy round {}: cost {:.0f} m, {} safe segments", result_.tourSolutions, solution->cost, result_.safeSegments));
    }
  }

  void tellRound(const GtspSolution& solution) const {
    if (!options_.roundDone) {
      return;
    }
    SearchRound round;
    round.round = static_cast<int>(result_.tourSolutions);
    round.cost = solution.cost;
    round.lowerBound = solution.lowerBound;
    round.visits = &visits_;
    round.tour = &tour_;
    for (std::size_t i = 0; i < tour_.size(); ++i) {
      round.isSafe.push_back(level_[index(tour_[i], tour_[(i + 1) % tour_.size()])] == Level::Safe ? 1 : 0);
    }
    options_.roundDone(round);
  }

  Result<SearchResult> finish(const GtspSolution& solution) {
    result_.tour = solution.tour;
    result_.cost = solution.cost;
    result_.lowerBound = solution.lowerBound;
    result_.optimal = solution.optimal;
    if (!solution.optimal && solver_) {
      const auto start = Clock::now();
      const Result<double> bound = lowerBound(problem(), solution.cost, {}, job_);
      if (!bound) {
        return forward(bound);
      }
      result_.lowerBound = std::clamp(*bound, solution.lowerBound, solution.cost);
      result_.optimal = result_.lowerBound >= solution.cost * (1.0 - 1e-9);
      result_.solverSeconds += secondsSince(start);
    }
    return result_;
  }

  const landing::World& world_;
  const landing::Roadmap& roadmap_;
  const Detours& detours_;
  std::vector<VisitPose> visits_;
  const SegmentSettings& settings_;
  const SearchOptions& options_;
  const Job& job_;
  GtspProblem problem_;               ///< until the solver takes it; then its sets alone
  std::optional<GtspSolver> solver_;  ///< none for a single target
  std::vector<int> setOf_;
  std::vector<Level> level_;
  std::vector<SegmentBuilder> builders_;  ///< one per thread
  std::vector<SegmentBound> bounds_;      ///< one per thread
  std::vector<int> tour_;
  std::vector<int> settled_;  ///< the last tour's order with its best headings
  SearchResult result_;
};

}  // namespace

Result<SearchResult> searchTour(const landing::World& world, const landing::Roadmap& roadmap, const Detours& detours,
                                const std::vector<VisitPose>& visits, const SegmentSettings& settings, const SearchOptions& options, const Job& job) {
  return Search(world, roadmap, detours, visits, settings, options, job).run();
}

}  // namespace vp::tour
