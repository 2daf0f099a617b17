#include "core/tour/gtsp_graph.h"

#include <algorithm>
#include <cmath>

namespace vp::tour {

namespace {
constexpr int kMaxNeighbours = 64;
constexpr double kHeadroom = 4.0;  // arcs may become this much dearer than the dearest until the graph is built anew
}  // namespace

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
  highest_ = kHeadroom * std::max(largest, 1.0 / scale_);
  forbidden_ = static_cast<float>((sets() + 1) * highest_ * scale_);
  const auto n = static_cast<std::size_t>(slots_);
  out_.assign(n * n, kPad);
  in_.assign(n * n, kPad);
  for (int i = 0; i < slots_; ++i) {
    for (int j = 0; j < slots_; ++j) {
      if (nodeOf(i) < 0 || nodeOf(j) < 0 || setOf(i) == setOf(j)) {
        continue;
      }
      const float cost = rounded(problem.at(nodeOf(i), nodeOf(j)));
      out_[rowStart(i, setOf(j)) + static_cast<std::size_t>(j - first(setOf(j)))] = cost;
      in_[rowStart(j, setOf(i)) + static_cast<std::size_t>(i - first(setOf(i)))] = cost;
    }
  }
}

float SetGraph::rounded(double cost) const {
  return std::isinf(cost) ? forbidden_ : static_cast<float>(cost * scale_);
}

void SetGraph::fillNearSets() {
  const auto count = static_cast<std::size_t>(sets());
  nearCount_ = std::min(sets() - 1, kMaxNeighbours);
  near_.resize(count * static_cast<std::size_t>(nearCount_));
  distance_.resize(count * count);
  pairStale_.assign(count * count, 0);
  nearStale_.assign(count, 0);
  for (int set = 0; set < sets(); ++set) {
    for (int other = 0; other < set; ++other) {
      measureDistance(set, other);
    }
  }
  for (int set = 0; set < sets(); ++set) {
    sortNearSets(set);
  }
}

void SetGraph::measureDistance(int set, int other) {
  const int block = width(set) * width(other);
  const float* away = out(first(set), other);
  const float* back = in(first(set), other);
  const float least = std::min(*std::min_element(away, away + block), *std::min_element(back, back + block));
  distance_[pairOf(set, other)] = distance_[pairOf(other, set)] = least;
}

void SetGraph::sortNearSets(int set) {
  std::vector<std::pair<float, int>> order;
  order.reserve(static_cast<std::size_t>(sets()));
  for (int other = 0; other < sets(); ++other) {
    if (other != set) {
      order.emplace_back(distance_[pairOf(set, other)], other);
    }
  }
  std::sort(order.begin(), order.end());
  int* near = &near_[static_cast<std::size_t>(set) * static_cast<std::size_t>(nearCount_)];
  std::transform(order.begin(), order.begin() + nearCount_, near, [](const auto& entry) { return entry.second; });
}

void SetGraph::setCost(int fromNode, int toNode, double cost) {
  const int from = slotOf(fromNode);
  const int to = slotOf(toNode);
  const int tail = setOf(from);
  const int head = setOf(to);
  const float now = rounded(cost);
  float& stored = out_[rowStart(from, head) + static_cast<std::size_t>(to - first(head))];
  const float before = stored;
  stored = now;
  in_[rowStart(to, tail) + static_cast<std::size_t>(from - first(tail))] = now;
  const float nearest = distance_[pairOf(tail, head)];
  if (now < nearest) {
    distance_[pairOf(tail, head)] = distance_[pairOf(head, tail)] = now;
    nearStale_[static_cast<std::size_t>(tail)] = nearStale_[static_cast<std::size_t>(head)] = 1;
  } else if (before == nearest && now > before && pairStale_[pairOf(tail, head)] == 0) {
    pairStale_[pairOf(tail, head)] = pairStale_[pairOf(head, tail)] = 1;
    stalePairs_.emplace_back(tail, head);
  }
}

void SetGraph::refreshNearSets() {
  for (const auto& [set, other] : stalePairs_) {
    const float before = distance_[pairOf(set, other)];
    measureDistance(set, other);
    pairStale_[pairOf(set, other)] = pairStale_[pairOf(other, set)] = 0;
    if (distance_[pairOf(set, other)] != before) {
      nearStale_[static_cast<std::size_t>(set)] = nearStale_[static_cast<std::size_t>(other)] = 1;
    }
  }
  stalePairs_.clear();
  for (int set = 0; set < sets(); ++set) {
    if (nearStale_[static_cast<std::size_t>(set)] != 0) {
      sortNearSets(set);
      nearStale_[static_cast<std::size_t>(set)] = 0;
    }
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
