#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/tour/gtsp.h"
#include "core/tour/gtsp_search.h"

#include <optional>
#include <vector>

namespace vp::tour {

/** One solution of a valid problem by what suits it: exact search, or rounds of the heuristic search and a bound. */
class GtspRun {
public:
  /** @param search  shows the problem's costs; may be null for up to three sets */
  GtspRun(const GtspProblem& problem, TourSearch* search, const GtspOptions& options, const Job& job);

  /** Starts from a tour of nodes; without one when it is empty. */
  Result<GtspSolution> whole(const std::vector<int>& warmTour);

  /** A short search from a tour with moves that begin at `sets`; the whole search if that finds no tour. */
  Result<GtspSolution> around(const std::vector<int>& warmTour, const std::vector<int>& sets);

private:
  void consider(const std::vector<int>& tour);
  Result<void> runExact();
  Result<void> runSearch(bool warm);
  Result<void> computeBound();
  Result<GtspSolution> finish();
  [[nodiscard]] bool isLate() const;
  [[nodiscard]] bool proved() const;

  const GtspProblem& problem_;
  TourSearch* search_;
  const GtspOptions& options_;
  const Job& job_;
  Deadline deadline_;
  GtspSolution best_;
};

/** Sets up to which exact search is the only way: too few for the moves of TourSearch. */
inline constexpr int kFewSets = 3;

}  // namespace vp::tour
