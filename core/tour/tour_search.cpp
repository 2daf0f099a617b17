#include "core/tour/tour_search.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

namespace vp::tour {
namespace {

using Clock = std::chrono::steady_clock;

/** Effort of the tour solver in rounds that are only to say which segments to look at next; the last has the full one.
 *  Falls with the number of targets because the rounds grow in number (0.15 at twenty targets and below). On the mountain
 *  with 100 targets it ends at the same cost as an effort of 0.15 throughout, in a fifth of the time. */
double roundEffort(std::size_t targets) {
  return std::clamp(3.0 / static_cast<double>(targets), 0.02, 0.15);
}

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/** The tour problem while its costs are being found out. */
class Search {
public:
  Search(const landing::World& world, const landing::Roadmap& roadmap, const Detours& detours, const std::vector<VisitPose>& visits,
         const SegmentSettings& settings, const SearchOptions& options, const Job& job)
      : visits_(visits), options_(options), job_(job) {
    const auto count = visits.size();
    problem_.nodes = static_cast<int>(count);
    problem_.cost.assign(count * count, kForbidden);
    isSafe_.assign(count * count, 0);
    for (std::size_t i = 0; i < count; ++i) {
      if (i == 0 || visits[i].target != visits[i - 1].target) {
        problem_.sets.emplace_back();
      }
      problem_.sets.back().push_back(static_cast<int>(i));
    }
    for (int t = 0; t < std::max(1, options.threads); ++t) {
      builders_.emplace_back(world, roadmap, detours, settings, job.stopToken());
    }
  }

  Result<SearchResult> run() {
    Result<SearchResult> found = options_.method == mission::Method::Base ? base() : lazy();
    if (found) {
      for (const SegmentBuilder& builder : builders_) {
        found->safeQueries += builder.queries();
      }
    }
    return found;
  }

private:
  [[nodiscard]] std::size_t index(int from, int to) const { return static_cast<std::size_t>(from) * visits_.size() + static_cast<std::size_t>(to); }

  [[nodiscard]] bool mayConnect(std::size_t from, std::size_t to) const {
    // a single target is visited by a circle from a pose to itself
    return problem_.sets.size() == 1 ? from == to : visits_[from].target != visits_[to].target;
  }

  /// Fills all costs with `segment`, in rows shared among the threads. False when stopped.
  template <typename Segment>
  bool fillAll(const char* what, double from, double to, Segment segment) {
    const Job part = job_.part(from, to);
    std::atomic<std::size_t> next{0};
    const auto work = [&](SegmentBuilder& builder) {
      for (std::size_t row = next++; row < visits_.size(); row = next++) {
        for (std::size_t column = 0; column < visits_.size(); ++column) {
          if (part.stopRequested()) {
            return;
          }
          if (mayConnect(row, column)) {
            problem_.cost[row * visits_.size() + column] = segment(builder, visits_[row], visits_[column]);
          }
        }
        part.progress(static_cast<double>(row + 1) / static_cast<double>(visits_.size()),
                      fmt::format("{}: {} of {} visits", what, row + 1, visits_.size()));
      }
    };
    if (builders_.size() == 1) {
      work(builders_.front());
    } else {
      std::vector<std::jthread> threads;
      for (SegmentBuilder& builder : builders_) {
        threads.emplace_back([&work, &builder] { work(builder); });
      }
    }
    return !part.stopRequested();
  }

  Result<GtspSolution> solve(bool last) {
    const auto start = Clock::now();
    GtspOptions gtsp;
    gtsp.seed = options_.seed + static_cast<std::uint64_t>(result_.tourSolutions);
    gtsp.wantBound = last;
    gtsp.effort = last ? 1.0 : roundEffort(problem_.sets.size());
    if (!tour_.empty()) {
      gtsp.warmStart = tour_;
    }
    Result<GtspSolution> solution = visits_.empty()             ? fail(Errc::NoSolution, "the mission has no targets")
                                    : problem_.sets.size() == 1 ? singleTarget()
                                    : options_.solver == mission::TourSolver::Lkh
                                        ? solveGtspWithLkh(problem_, gtsp, options_.lkhProgram, job_.part(0.5, 0.5))
                                        : solveGtsp(problem_, gtsp, job_.part(0.5, 0.5));
    ++result_.tourSolutions;
    result_.solverSeconds += secondsSince(start);
    return solution;
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
                              [](SegmentBuilder& builder, const VisitPose& a, const VisitPose& b) { return builder.safeSegment(a, b).cost; });
    if (!done) {
      return stopped();
    }
    result_.safeSeconds = secondsSince(start);
    result_.safeSegments = std::count_if(problem_.cost.begin(), problem_.cost.end(), [](double cost) { return std::isfinite(cost); });
    const Result<GtspSolution> solution = solve(true);
    if (!solution) {
      return forward(solution);
    }
    return finish(*solution);
  }

  /// Replaces the terrain segments of the tour by safe ones. @return how many
  int replaceUnsafe() {
    const auto start = Clock::now();
    int replaced = 0;
    for (std::size_t i = 0; i < tour_.size() && !job_.stopRequested(); ++i) {
      const int from = tour_[i];
      const int to = tour_[(i + 1) % tour_.size()];
      const std::size_t at = index(from, to);
      if (isSafe_[at] == 0) {
        const double cost = builders_.front().safeSegment(visits_[static_cast<std::size_t>(from)], visits_[static_cast<std::size_t>(to)]).cost;
        problem_.cost[at] = std::max(problem_.cost[at], cost);  // equal up to rounding where terrain alone decides
        isSafe_[at] = 1;
        ++replaced;
      }
    }
    result_.safeSegments += replaced;
    result_.safeSeconds += secondsSince(start);
    return replaced;
  }

  Result<SearchResult> lazy() {
    const auto start = Clock::now();
    const bool done = fillAll("terrain segments", 0.0, 0.2,
                              [](SegmentBuilder& builder, const VisitPose& a, const VisitPose& b) { return builder.terrainSegment(a, b).cost; });
    if (!done) {
      return stopped();
    }
    result_.terrainSeconds = secondsSince(start);
    bool last = false;
    for (;;) {
      const Result<GtspSolution> solution = solve(last);
      if (!solution) {
        return forward(solution);
      }
      tour_ = solution->tour;
      tellRound(*solution);
      const int replaced = replaceUnsafe();
      if (job_.stopRequested()) {
        return stopped();
      }
      if (replaced == 0 && last) {
        return finish(*solution);
      }
      last = replaced == 0;  // once more with the lower bound, from another seed; it may still find a better tour
      const double spread = static_cast<double>(result_.tourSolutions) / (static_cast<double>(result_.tourSolutions) + 50.0);
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
      const auto from = static_cast<std::size_t>(tour_[i]);
      const auto to = static_cast<std::size_t>(tour_[(i + 1) % tour_.size()]);
      round.isSafe.push_back(isSafe_[from * visits_.size() + to]);
    }
    options_.roundDone(round);
  }

  SearchResult finish(const GtspSolution& solution) {
    result_.tour = solution.tour;
    result_.cost = solution.cost;
    result_.lowerBound = solution.lowerBound;
    result_.optimal = solution.optimal;
    return result_;
  }

  const std::vector<VisitPose>& visits_;
  const SearchOptions& options_;
  const Job& job_;
  GtspProblem problem_;
  std::vector<char> isSafe_;
  std::vector<SegmentBuilder> builders_;
  std::vector<int> tour_;
  SearchResult result_;
};

}  // namespace

Result<SearchResult> searchTour(const landing::World& world, const landing::Roadmap& roadmap, const Detours& detours,
                                const std::vector<VisitPose>& visits, const SegmentSettings& settings, const SearchOptions& options, const Job& job) {
  return Search(world, roadmap, detours, visits, settings, options, job).run();
}

}  // namespace vp::tour
