#include "core/tour/gtsp_reduced.h"

#include "core/tour/gtsp_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vp::tour {

ReducedCosts::ReducedCosts(const GtspProblem& problem) {
  first_.push_back(0);
  std::vector<int> members;
  for (const std::vector<int>& set : problem.sets) {
    members.insert(members.end(), set.begin(), set.end());
    setOf_.resize(members.size(), static_cast<int>(first_.size()) - 1);
    first_.push_back(static_cast<int>(members.size()));
  }
  largest_ = std::max(largestCost(problem, setOfNodes(problem)), 1e-300);
  magnitude_ = (sets() + 1) * largest_;
  cost_.resize(members.size() * members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    for (std::size_t j = 0; j < members.size(); ++j) {
      const double cost = problem.at(members[i], members[j]);
      cost_[i * members.size() + j] = std::isinf(cost) ? magnitude_ : cost;
    }
  }
  integers_ = std::all_of(problem.cost.begin(), problem.cost.end(), [](double c) { return std::isinf(c) || c == std::floor(c); });
}

void ReducedCosts::apply(const std::vector<double>& nodePrice, const std::vector<double>& setPrice) {
  double dearest = 0.0;
  for (int set = 0; set < sets(); ++set) {
    double least = kForbidden;
    for (int tail = first(set); tail < end(set); ++tail) {
      const double added = nodePrice[static_cast<std::size_t>(tail)] + setPrice[static_cast<std::size_t>(set)];
      dearest = std::max({dearest, std::abs(added), std::abs(nodePrice[static_cast<std::size_t>(tail)])});
      double* costs = row(tail);
      for (int head = 0; head < nodes(); ++head) {
        costs[head] += added - nodePrice[static_cast<std::size_t>(head)];
        least = setOf(head) != set && costs[head] < least ? costs[head] : least;
      }
    }
    for (int tail = first(set); tail < end(set); ++tail) {
      double* costs = row(tail);
      for (int head = 0; head < nodes(); ++head) {
        costs[head] -= least;
      }
    }
    constant_ += least - setPrice[static_cast<std::size_t>(set)];
  }
  magnitude_ += 2.0 * dearest;
  changes_ += 3.0;
}

void ReducedCosts::addCut(double weight) {
  constant_ += weight;
  changes_ += 1.0;
}

void ReducedCosts::transpose() {
  const auto n = static_cast<std::size_t>(nodes());
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      std::swap(cost_[i * n + j], cost_[j * n + i]);
    }
  }
}

double ReducedCosts::safe(double value) const {
  const double margin = std::numeric_limits<double>::epsilon() * sets() * magnitude_ * changes_;
  const double bound = value - margin;
  if (bound > sets() * largest_ * (1.0 + 1e-9)) {
    return kForbidden;
  }
  const bool round = integers_ && margin < 1e-3 && std::abs(bound) < 1e12;
  return std::max(0.0, round ? std::ceil(bound - 1e-3) : bound);
}

}  // namespace vp::tour
