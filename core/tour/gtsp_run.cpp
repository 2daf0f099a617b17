#include "core/tour/gtsp_run.h"

#include "core/base/expect.h"
#include "core/tour/gtsp_bound.h"
#include "core/tour/gtsp_check.h"
#include "core/tour/gtsp_exact.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace vp::tour {

namespace {

using Clock = std::chrono::steady_clock;

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

}  // namespace

GtspRun::GtspRun(const GtspProblem& problem, TourSearch* search, const GtspOptions& options, const Job& job)
    : problem_(problem), search_(search), options_(options), job_(job) {
  if (options.seconds) {
    const double reserve = std::min(0.02 * *options.seconds, kReserveSeconds);
    deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*options.seconds - reserve));
  }
}

Result<GtspSolution> GtspRun::whole(const std::vector<int>& warmTour) {
  const auto sets = static_cast<int>(problem_.sets.size());
  if (sets == 1) {
    return GtspSolution{{problem_.sets[0][0]}, 0.0, 0.0, true, 0};
  }
  if (!warmTour.empty()) {
    consider(warmTour);
  }
  if (search_ != nullptr) {
    search_->begin(options_.seed, options_.effort);
    if (!warmTour.empty()) {
      search_->startFrom(warmTour);
    }
  }
  const bool exact = sets <= kFewSets || (sets <= options_.exactUpToSets && fitsExactSearch(problem_));
  const Result<void> done = exact ? runExact() : runSearch(!warmTour.empty());
  if (!done) {
    return forward(done);
  }
  return finish();
}

Result<GtspSolution> GtspRun::around(const std::vector<int>& warmTour, const std::vector<int>& sets) {
  VP_EXPECT(search_ != nullptr);
  consider(warmTour);
  if (!sets.empty()) {
    search_->begin(options_.seed, options_.effort);
    search_->startFrom(warmTour);
    if (!search_->searchAround(sets, deadline_, job_)) {
      return cancelled();
    }
    consider(search_->best());
    best_.rounds = search_->rounds();
  }
  return std::isinf(best_.cost) ? whole(warmTour) : finish();
}

void GtspRun::consider(const std::vector<int>& tour) {
  std::vector<int> rotated = fromSetZero(problem_, tour);
  const double cost = tourCost(problem_, rotated);  // of the rotated tour: sums in another order differ
  if (cost < best_.cost) {
    best_.tour = std::move(rotated);
    best_.cost = cost;
  }
}

Result<void> GtspRun::runExact() {
  if (search_ != nullptr) {  // a good tour first: it lets the exact search drop most of its states
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

Result<void> GtspRun::runSearch(bool warm) {
  VP_EXPECT(search_ != nullptr);
  const int patience = warm ? kWarmPatience : kColdPatience;
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

Result<void> GtspRun::computeBound() {
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

bool GtspRun::isLate() const {
  return deadline_ && Clock::now() >= *deadline_;
}

bool GtspRun::proved() const {
  return reaches(best_.lowerBound, best_.cost);
}

Result<GtspSolution> GtspRun::finish() {
  if (std::isinf(best_.cost)) {
    return fail(Errc::NoSolution, std::isinf(best_.lowerBound)
                                      ? "no closed tour visits every set, because too many connections are forbidden; allow more of them"
                                      : "no tour found that avoids forbidden connections; allow more of them or search longer");
  }
  best_.lowerBound = std::min(best_.lowerBound, best_.cost);
  best_.optimal = proved();
  return best_;
}

}  // namespace vp::tour
