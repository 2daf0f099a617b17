#include "core/tour/gtsp_check.h"

#include "core/tour/gtsp_graph.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vp::tour {

namespace {

tl::unexpected<Error> outOfRange(std::string what) {
  return fail(Errc::OutOfRange, std::move(what), "tour problem");
}

Result<void> checkSets(const GtspProblem& problem, std::vector<int>& setOf) {
  for (std::size_t set = 0; set < problem.sets.size(); ++set) {
    if (problem.sets[set].empty()) {
      return outOfRange(fmt::format("set {} has no nodes; give every set at least one", set));
    }
    for (const int node : problem.sets[set]) {
      if (node < 0 || node >= problem.nodes || setOf[static_cast<std::size_t>(node)] >= 0) {
        return outOfRange(fmt::format("node {} of set {} does not exist or is in two sets; name every node once", node, set));
      }
      setOf[static_cast<std::size_t>(node)] = static_cast<int>(set);
    }
  }
  if (const auto lost = std::find(setOf.begin(), setOf.end(), -1); lost != setOf.end()) {
    return outOfRange(fmt::format("node {} is in no set; name every node once", lost - setOf.begin()));
  }
  return {};
}

Result<void> checkWarmStart(const GtspProblem& problem, const std::vector<int>& tour, const std::vector<int>& setOf) {
  std::vector<bool> visited(problem.sets.size(), false);
  for (const int node : tour) {
    if (node < 0 || node >= problem.nodes || visited[static_cast<std::size_t>(setOf[static_cast<std::size_t>(node)])]) {
      return outOfRange(fmt::format("the warm start visits node {}, which does not exist or whose set it visits twice; give one node per set", node));
    }
    visited[static_cast<std::size_t>(setOf[static_cast<std::size_t>(node)])] = true;
  }
  if (tour.size() != problem.sets.size()) {
    return outOfRange(fmt::format("the warm start visits {} of {} sets; give one node per set", tour.size(), problem.sets.size()));
  }
  return {};
}

}  // namespace

Result<void> checkProblem(const GtspProblem& problem) {
  if (problem.nodes < 1 || problem.sets.empty()) {
    return outOfRange("there is nothing to visit; give at least one set with one node");
  }
  const std::size_t entries = static_cast<std::size_t>(problem.nodes) * static_cast<std::size_t>(problem.nodes);
  if (problem.cost.size() != entries) {
    return outOfRange(fmt::format("the cost matrix has {} entries; give {}, one for every pair of nodes", problem.cost.size(), entries));
  }
  std::vector<int> setOf(static_cast<std::size_t>(problem.nodes), -1);
  if (Result<void> sets = checkSets(problem, setOf); !sets) {
    return sets;
  }
  const auto wrong = std::find_if(problem.cost.begin(), problem.cost.end(), [](double c) { return std::isnan(c) || c < 0.0; });
  if (wrong != problem.cost.end()) {
    const std::ptrdiff_t at = wrong - problem.cost.begin();
    return outOfRange(fmt::format("the cost from node {} to node {} is negative or not a number; costs must be zero or more", at / problem.nodes,
                                  at % problem.nodes));
  }
  return {};
}

Result<void> checkOptions(const GtspProblem& problem, const GtspOptions& options) {
  if (options.seconds && !(*options.seconds >= 0.0 && *options.seconds <= 1e7)) {
    return outOfRange("the time limit is negative, too long or not a number; give seconds from 0 to 10 million");
  }
  if (!(options.effort > 0.0 && options.effort <= 1e6)) {
    return outOfRange("the effort is not from 0 to a million; 1 is the usual value");
  }
  return options.warmStart ? checkWarmStart(problem, *options.warmStart, setOfNodes(problem)) : Result<void>{};
}

std::vector<int> fromSetZero(const GtspProblem& problem, std::vector<int> tour) {
  const std::vector<int>& zero = problem.sets[0];
  const auto start = std::find_first_of(tour.begin(), tour.end(), zero.begin(), zero.end());
  std::rotate(tour.begin(), start, tour.end());
  return tour;
}

}  // namespace vp::tour
