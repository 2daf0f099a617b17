#include "core/tour/gtsp_graph.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vp::tour {

namespace {
constexpr int kMaxNeighbours = 64;
}

SetGraph::SetGraph(const GtspProblem& problem) {
  first_.push_back(0);
  slotOf_.assign(static_cast<std::size_t>(problem.nodes), -1);
  for (const std::vector<int>& members : problem.sets) {
    const int set = static_cast<int>(size_.size());
    for (const int node : members) {
      slotOf_[static_cast<std::size_t>(node)] = static_cast<int>(nodeOf_.size());
      nodeOf_.push_back(node);
    }
    size_.push_back(static_cast<int>(members.size()));
    while (nodeOf_.size() % kLanes != 0) {
      nodeOf_.push_back(-1);
    }
    setOf_.resize(nodeOf_.size(), set);
    first_.push_back(static_cast<int>(nodeOf_.size()));
  }
  slots_ = static_cast<int>(nodeOf_.size());
  fillCosts(problem);
  fillNearSets();
}

void SetGraph::fillCosts(const GtspProblem& problem) {
  const double largest = largestCost(problem, setOfNodes(problem));
  scale_ = largest > 0.0 ? std::exp2(20 - std::ilogb(largest)) : 1.0;
  forbidden_ = static_cast<float>((sets() + 1) * std::max(largest * scale_, 1.0));
  const auto n = static_cast<std::size_t>(slots_);
  out_.assign(n * n, kPad);
  in_.assign(n * n, kPad);
  for (int i = 0; i < slots_; ++i) {
    for (int j = 0; j < slots_; ++j) {
      if (nodeOf(i) < 0 || nodeOf(j) < 0 || setOf(i) == setOf(j)) {
        continue;
      }
      const double exact = problem.at(nodeOf(i), nodeOf(j));
      const float rounded = std::isinf(exact) ? forbidden_ : static_cast<float>(exact * scale_);
      out_[rowStart(i, setOf(j)) + static_cast<std::size_t>(j - first(setOf(j)))] = rounded;
      in_[rowStart(j, setOf(i)) + static_cast<std::size_t>(i - first(setOf(i)))] = rounded;
    }
  }
}

void SetGraph::fillNearSets() {
  const int count = sets();
  nearCount_ = std::min(count - 1, kMaxNeighbours);
  near_.reserve(static_cast<std::size_t>(count) * static_cast<std::size_t>(nearCount_));
  std::vector<float> distance(static_cast<std::size_t>(count));
  std::vector<int> order;
  for (int set = 0; set < count; ++set) {
    for (int other = 0; other < count; ++other) {
      const int block = width(set) * width(other);
      const float* away = out(first(set), other);
      const float* back = in(first(set), other);
      distance[static_cast<std::size_t>(other)] = std::min(*std::min_element(away, away + block), *std::min_element(back, back + block));
    }
    order.resize(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    order.erase(order.begin() + set);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return distance[static_cast<std::size_t>(a)] < distance[static_cast<std::size_t>(b)]; });
    near_.insert(near_.end(), order.begin(), order.begin() + nearCount_);
  }
}

double tourCost(const GtspProblem& problem, const std::vector<int>& tour) {
  if (tour.size() < 2) {
    return tour.empty() ? kForbidden : 0.0;
  }
  double sum = problem.at(tour.back(), tour.front());
  for (std::size_t i = 0; i + 1 < tour.size(); ++i) {
    sum += problem.at(tour[i], tour[i + 1]);
  }
  return sum;
}

double largestCost(const GtspProblem& problem, const std::vector<int>& setOfNode) {
  double largest = 0.0;
  for (int i = 0; i < problem.nodes; ++i) {
    for (int j = 0; j < problem.nodes; ++j) {
      const double cost = problem.at(i, j);
      if (cost > largest && !std::isinf(cost) && setOfNode[static_cast<std::size_t>(i)] != setOfNode[static_cast<std::size_t>(j)]) {
        largest = cost;
      }
    }
  }
  return largest;
}

std::vector<int> setOfNodes(const GtspProblem& problem) {
  std::vector<int> setOf(static_cast<std::size_t>(problem.nodes), -1);
  for (std::size_t set = 0; set < problem.sets.size(); ++set) {
    for (const int node : problem.sets[set]) {
      setOf[static_cast<std::size_t>(node)] = static_cast<int>(set);
    }
  }
  return setOf;
}

}  // namespace vp::tour
