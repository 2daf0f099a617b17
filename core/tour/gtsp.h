#pragma once

#include "core/base/job.h"
#include "core/base/result.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace vp::tour {

/// Cost of an arc that must not be used.
inline constexpr double kForbidden = std::numeric_limits<double>::infinity();

/** A generalized asymmetric travelling salesman problem: visit exactly one node of every set, closed tour, least cost.
 *  cost is row-major nodes x nodes; arcs inside a set are never used; kForbidden marks arcs that do not exist. */
struct GtspProblem {
  int nodes = 0;
  std::vector<std::vector<int>> sets;  ///< disjoint, together all nodes
  std::vector<double> cost;            ///< nodes * nodes
  [[nodiscard]] double at(int from, int to) const {
    return cost[static_cast<std::size_t>(from) * static_cast<std::size_t>(nodes) + static_cast<std::size_t>(to)];
  }
};

struct GtspOptions {
  std::uint64_t seed = 1;
  std::optional<double> seconds;              ///< stop after this (gives up reproducibility); default: by rounds without gain
  std::optional<std::vector<int>> warmStart;  ///< nodes in tour order, one per set
  int exactUpToSets = 12;                     ///< dynamic programming proves optimality up to here
  double effort = 1.0;                        ///< scales the rounds of the default stopping rule
  bool wantBound = true;                      ///< compute a lower bound
  bool aroundChanges = false;                 ///< a short search around what changed; see gtsp_solver.h, for solveGtsp without meaning
};

struct GtspSolution {
  std::vector<int> tour;  ///< one node per set in visiting order, rotated so that set 0 comes first
  double cost = kForbidden;
  double lowerBound = 0.0;  ///< no tour costs less
  bool optimal = false;     ///< proved: lowerBound == cost up to rounding
  std::int64_t rounds = 0;
};

/** Solves the problem: exact dynamic programming over sets for small instances, else adaptive large-neighbourhood
 *  search with optimal node choice per set order. Deterministic for a seed when `seconds` is absent.
 *  @errors NoSolution if no closed tour avoids forbidden arcs (as far as known); Cancelled */
Result<GtspSolution> solveGtsp(const GtspProblem& problem, const GtspOptions& options, const Job& job);

/** The same by an external LKH program on the Noon-Bean transformation, as in the source papers.
 *  @errors Unsupported if `program` cannot be run */
Result<GtspSolution> solveGtspWithLkh(const GtspProblem& problem, const GtspOptions& options, const std::string& program, const Job& job);

}  // namespace vp::tour
