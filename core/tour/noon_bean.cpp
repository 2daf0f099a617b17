#include "core/tour/noon_bean.h"

#include "core/tour/gtsp_graph.h"

#include <algorithm>
#include <cmath>

namespace vp::tour {

namespace {
constexpr double kMostInt = 2147483647.0;
constexpr double kLeastPrecision = 1000.0;  // the costliest arc must keep this many steps
}  // namespace

std::optional<NoonBean> transformNoonBean(const GtspProblem& problem) {
  const double sets = static_cast<double>(problem.sets.size());
  const std::vector<int> setOf = setOfNodes(problem);
  const double largest = largestCost(problem, setOf);
  // With arcs up to c a tour costs at most sets * c, so penalty = sets * c + 1. The dearest thing a solver adds up is a
  // tour through forbidden arcs only, nodes * (2 penalty + c) with forbidden = penalty + penalty + c.
  const auto total = [&](double c) { return (problem.nodes + 1.0) * (2.0 * (sets * c + 1.0) + c + 1.0); };
  const bool whole = std::all_of(problem.cost.begin(), problem.cost.end(), [](double c) { return std::isinf(c) || c == std::floor(c); });
  NoonBean result;
  if (!whole || total(largest) >= kMostInt) {
    result.scale = largest > 0.0 ? std::exp2(std::floor(std::log2(kMostInt / ((problem.nodes + 1.0) * (2.0 * sets + 1.0) * largest)))) : 1.0;
    while (total(std::ceil(largest * result.scale)) >= kMostInt) {
      result.scale *= 0.5;
    }
    if (largest * result.scale < kLeastPrecision && largest > 0.0) {
      return std::nullopt;
    }
  }
  const double scaledLargest = std::ceil(largest * result.scale);
  result.nodes = problem.nodes;
  result.sets = problem.sets;
  result.penalty = static_cast<int>(sets * scaledLargest + 1.0);
  result.forbiddenCost = static_cast<int>(2.0 * result.penalty + scaledLargest);
  const auto n = static_cast<std::size_t>(problem.nodes);
  result.cost.assign(n * n, result.forbiddenCost);
  for (const std::vector<int>& members : problem.sets) {
    for (std::size_t i = 0; i < members.size(); ++i) {
      const auto node = static_cast<std::size_t>(members[i]);
      const auto predecessor = static_cast<std::size_t>(members[(i + members.size() - 1) % members.size()]);
      if (members.size() > 1) {
        result.cost[predecessor * n + node] = 0;
      }
      for (std::size_t head = 0; head < n; ++head) {
        const double cost = problem.cost[node * n + head];
        if (setOf[head] != setOf[node] && !std::isinf(cost)) {
          result.cost[predecessor * n + head] = static_cast<int>(std::floor(cost * result.scale + 0.5)) + result.penalty;
        }
      }
    }
  }
  return result;
}

std::vector<int> decodeNoonBean(const GtspProblem& problem, const std::vector<int>& atspTour) {
  const std::vector<int> setOf = setOfNodes(problem);
  std::vector<int> order = atspTour;
  // Begin where a set is entered, not in the middle of one.
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t before = (i + order.size() - 1) % order.size();
    if (setOf[static_cast<std::size_t>(order[i])] != setOf[static_cast<std::size_t>(order[before])]) {
      std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(i), order.end());
      break;
    }
  }
  std::vector<bool> visited(problem.sets.size(), false);
  std::vector<int> tour;
  for (const int node : order) {
    const auto set = static_cast<std::size_t>(setOf[static_cast<std::size_t>(node)]);
    if (!visited[set]) {
      visited[set] = true;
      tour.push_back(node);
    }
  }
  return tour;
}

}  // namespace vp::tour
