#include "core/tour/gtsp_node_choice.h"

#include "core/tour/gtsp_lanes.h"

#include <algorithm>

namespace vp::tour {

float NodeChooser::choose(std::vector<int>& tour, int from, int count) {
  const int n = static_cast<int>(tour.size());
  const auto at = [&](int position) -> int& { return tour[static_cast<std::size_t>(position >= n ? position - n : position)]; };
  const int before = at(from == 0 ? n - 1 : from - 1);
  int set = graph_.setOf(at(from));
  std::copy_n(graph_.out(before, set), graph_.width(set), &reach_[static_cast<std::size_t>(graph_.first(set))]);
  for (int i = 1; i < count; ++i) {
    const int next = graph_.setOf(at(from + i));
    const int first = graph_.first(set);
    minPlus(&reach_[static_cast<std::size_t>(first)], graph_.out(first, next), graph_.size(set), graph_.width(next),
            &reach_[static_cast<std::size_t>(graph_.first(next))]);
    set = next;
  }
  int behind = at(from + count);
  float total = 0.0F;
  for (int i = count - 1; i >= 0; --i) {
    int& slot = at(from + i);
    set = graph_.setOf(slot);
    const int first = graph_.first(set);
    const LeastSum best = leastSum(&reach_[static_cast<std::size_t>(first)], graph_.in(behind, set), graph_.size(set));
    total = i == count - 1 ? best.value : total;
    slot = first + best.index;
    behind = slot;
  }
  return total;
}

std::vector<int> bestNodesForOrder(const GtspProblem& problem, const std::vector<int>& setOfNode, const std::vector<int>& tour) {
  const std::size_t n = tour.size();
  std::vector<const std::vector<int>*> layers;
  layers.reserve(n);
  for (const int node : tour) {
    layers.push_back(&problem.sets[static_cast<std::size_t>(setOfNode[static_cast<std::size_t>(node)])]);
  }
  // The loop is closed once for every node of its smallest set.
  std::rotate(layers.begin(), std::min_element(layers.begin(), layers.end(), [](const auto* a, const auto* b) { return a->size() < b->size(); }),
              layers.end());
  std::vector<std::vector<double>> reach(n);
  std::vector<std::vector<int>> cameFrom(n);
  std::vector<int> best = tour;
  double bestCost = tourCost(problem, tour);
  for (const int start : *layers[0]) {
    std::vector<int> tails{start};
    std::vector<double> costs{0.0};
    for (std::size_t i = 1; i <= n; ++i) {
      const std::vector<int> heads = i < n ? *layers[i] : std::vector<int>{start};
      std::vector<double>& to = reach[i % n];
      to.assign(heads.size(), kForbidden);
      cameFrom[i % n].assign(heads.size(), 0);
      for (std::size_t h = 0; h < heads.size(); ++h) {
        for (std::size_t t = 0; t < tails.size(); ++t) {
          const double cost = costs[t] + problem.at(tails[t], heads[h]);
          if (cost < to[h]) {
            to[h] = cost;
            cameFrom[i % n][h] = static_cast<int>(t);
          }
        }
      }
      tails = heads;
      costs = to;
    }
    if (n < 2 || costs[0] >= bestCost) {
      continue;
    }
    bestCost = costs[0];
    best.assign(n, start);
    std::size_t choice = static_cast<std::size_t>(cameFrom[0][0]);
    for (std::size_t i = n - 1; i >= 1; --i) {
      best[i] = (*layers[i])[choice];
      choice = static_cast<std::size_t>(cameFrom[i][choice]);
    }
  }
  return tourCost(problem, best) <= tourCost(problem, tour) ? best : tour;
}

}  // namespace vp::tour
