#include "core/tour/gtsp.h"

#include "core/tour/gtsp_bound.h"
#include "core/tour/gtsp_check.h"
#include "core/tour/gtsp_exact.h"
#include "core/tour/gtsp_graph.h"
#include "core/tour/gtsp_search.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace vp::tour {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kFewSets = 3;       // too few for the moves of the search; always exact
constexpr int kColdPatience = 4;  // rounds without gain after which the search ends
constexpr int kWarmPatience = 3;
constexpr double kReserveSeconds = 0.01;  // of a given time, for the end of the run
constexpr double kBoundShare = 0.1;       // of the time, where a time is given

tl::unexpected<Error> cancelled() {
  return fail(Errc::Cancelled, "stopped while searching the best tour");
}

bool reaches(double bound, double cost) {
  return bound >= cost - 1e-9 * std::abs(cost);
}

class Solver {
public:
  Solver(const GtspProblem& problem, const GtspOptions& options, const Job& job) : problem_(problem), options_(options), job_(job) {
    if (options.seconds) {
      const double reserve = std::min(0.02 * *options.seconds, kReserveSeconds);
      deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*options.seconds - reserve));
    }
  }

  Result<GtspSolution> run() {
    const auto sets = static_cast<int>(problem_.sets.size());
    if (sets == 1) {
      return single();
    }
    if (options_.warmStart) {
      consider(*options_.warmStart);
    }
    if (sets > kFewSets) {
      search_.emplace(problem_, options_);
      if (options_.warmStart) {
        search_->startFrom(*options_.warmStart);
      }
    }
    const bool exact = sets <= kFewSets || (sets <= options_.exactUpToSets && fitsExactSearch(problem_));
    const Result<void> done = exact ? runExact() : runSearch();
    if (!done) {
      return forward(done);
    }
    return finish();
  }

private:
  [[nodiscard]] GtspSolution single() const { return {{problem_.sets[0][0]}, 0.0, 0.0, true, 0}; }

  void consider(const std::vector<int>& tour) {
    const std::vector<int> rotated = fromSetZero(problem_, tour);
    const double cost = tourCost(problem_, rotated);
    if (cost < best_.cost) {
      best_.tour = rotated;
      best_.cost = cost;
    }
  }

  Result<void> runExact() {
    if (search_) {  // a good tour first: it lets the exact search drop most of its states
      if (!search_->runRound(deadline_, job_)) {
        return cancelled();
      }
      consider(search_->best());
      best_.rounds = search_->rounds();
    }
    const Result<std::optional<std::vector<int>>> tour = solveExactly(problem_, best_.cost, job_);
    if (!tour) {
      return forward(tour);
    }
    if (*tour) {
      consider(**tour);
    }
    best_.lowerBound = best_.cost;
    best_.optimal = true;
    return {};
  }

  Result<void> runSearch() {
    const int patience = options_.warmStart ? kWarmPatience : kColdPatience;
    while (search_->rounds() == 0 || (!isLate() && !proved() && (deadline_ || search_->roundsWithoutGain() < patience))) {
      if (!search_->runRound(deadline_, job_)) {
        return cancelled();
      }
      consider(search_->best());
      best_.rounds = search_->rounds();
      if (options_.wantBound && search_->rounds() == 1) {
        if (Result<void> bounded = computeBound(); !bounded) {
          return bounded;
        }
      }
    }
    return {};
  }

  Result<void> computeBound() {
    BoundEffort effort;
    if (deadline_) {
      const std::chrono::duration<double> share(*options_.seconds * kBoundShare);
      effort.deadline = std::min(*deadline_, Clock::now() + std::chrono::duration_cast<Clock::duration>(share));
    }
    const Result<double> bound = vp::tour::lowerBound(problem_, best_.cost, effort, job_);
    if (!bound) {
      return forward(bound);
    }
    best_.lowerBound = *bound;
    return {};
  }

  [[nodiscard]] bool isLate() const { return deadline_ && Clock::now() >= *deadline_; }
  [[nodiscard]] bool proved() const { return reaches(best_.lowerBound, best_.cost); }

  Result<GtspSolution> finish() {
    if (std::isinf(best_.cost)) {
      return fail(Errc::NoSolution, std::isinf(best_.lowerBound)
                                        ? "no closed tour visits every set, because too many connections are forbidden; allow more of them"
                                        : "no tour found that avoids forbidden connections; allow more of them or search longer");
    }
    best_.lowerBound = std::min(best_.lowerBound, best_.cost);
    best_.optimal = proved();
    return best_;
  }

  const GtspProblem& problem_;
  const GtspOptions& options_;
  const Job& job_;
  std::optional<Clock::time_point> deadline_;
  std::optional<TourSearch> search_;
  GtspSolution best_;
};

}  // namespace

Result<GtspSolution> solveGtsp(const GtspProblem& problem, const GtspOptions& options, const Job& job) {
  if (Result<void> valid = checkGtsp(problem, options); !valid) {
    return forward(valid);
  }
  if (job.stopRequested()) {
    return cancelled();
  }
  return Solver(problem, options, job).run();
}

}  // namespace vp::tour
