#include "core/tour/gtsp_bound.h"

#include "core/tour/gtsp_graph.h"
#include "core/tour/min_arborescence.h"

#include <algorithm>
#include <cmath>

namespace vp::tour {

namespace {

std::size_t idx(int i) {
  return static_cast<std::size_t>(i);
}

class Ascent {
public:
  explicit Ascent(const GtspProblem& problem) : sets_(static_cast<int>(problem.sets.size())) {
    first_.push_back(0);
    std::vector<int> nodes;
    for (const std::vector<int>& members : problem.sets) {
      nodes.insert(nodes.end(), members.begin(), members.end());
      first_.push_back(static_cast<int>(nodes.size()));
    }
    largest_ = std::max(largestCost(problem, setOfNodes(problem)), 1e-300);
    const double forbidden = (sets_ + 1) * largest_;
    cost_.resize(nodes.size() * nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (std::size_t j = 0; j < nodes.size(); ++j) {
        const double cost = problem.at(nodes[i], nodes[j]);
        cost_[i * nodes.size() + j] = std::isinf(cost) ? forbidden : cost;
      }
    }
    nodes_ = static_cast<int>(nodes.size());
    nodePrice_.assign(nodes.size(), 0.0);
    nodeStep_ = nodePrice_;
    setPrice_.assign(idx(sets_), 0.0);
    setStep_ = setPrice_;
    between_.resize(idx(sets_) * idx(sets_));
    tail_.resize(between_.size());
    head_.resize(between_.size());
    checkIntegers(problem);
  }

  /** The bound for the present prices; notes in what way its 1-arborescence is no tour. */
  double evaluate() {
    contract();
    int root = 0;
    const std::vector<int> parent = minArborescence(between_, sets_, root);
    std::fill(nodeExcess_.begin(), nodeExcess_.end(), 0.0);
    nodeExcess_.resize(idx(nodes_), 0.0);
    setExcess_.assign(idx(sets_), -1.0);
    double value = 0.0;
    for (int set = 0; set < sets_; ++set) {
      int from = parent[idx(set)];
      if (set == root) {
        from = 1;
        for (int other = 2; other < sets_; ++other) {
          from = between_[pair(other, root)] < between_[pair(from, root)] ? other : from;
        }
      }
      value += between_[pair(from, set)] - setPrice_[idx(set)];
      setExcess_[idx(from)] += 1.0;
      nodeExcess_[idx(tail_[pair(from, set)])] += 1.0;
      nodeExcess_[idx(head_[pair(from, set)])] -= 1.0;
    }
    return value;
  }

  [[nodiscard]] double excess() const {
    double sum = 0.0;
    for (const double e : nodeExcess_) {
      sum += e * e;
    }
    for (const double e : setExcess_) {
      sum += e * e;
    }
    return sum;
  }

  /** Moves the prices along the excess, smoothed with the last direction (Camerini, Fratta, Maffioli 1975). */
  void step(double length) {
    constexpr double kMemory = 0.3;
    for (std::size_t i = 0; i < nodeStep_.size(); ++i) {
      nodeStep_[i] = kMemory * nodeStep_[i] + (1.0 - kMemory) * nodeExcess_[i];
      nodePrice_[i] += length * nodeStep_[i];
    }
    for (std::size_t i = 0; i < setStep_.size(); ++i) {
      setStep_[i] = kMemory * setStep_[i] + (1.0 - kMemory) * setExcess_[i];
      setPrice_[i] += length * setStep_[i];
    }
  }

  void remember() {
    bestNodePrice_ = nodePrice_;
    bestSetPrice_ = setPrice_;
  }
  void goBack() {
    nodePrice_ = bestNodePrice_;
    setPrice_ = bestSetPrice_;
    std::fill(nodeStep_.begin(), nodeStep_.end(), 0.0);
    std::fill(setStep_.begin(), setStep_.end(), 0.0);
  }

  /** What rounding may have added is taken off, whole numbers are rounded up. */
  [[nodiscard]] double safe(double value) const {
    double prices = 0.0;
    for (const double p : bestNodePrice_) {
      prices = std::max(prices, std::abs(p));
    }
    for (const double p : bestSetPrice_) {
      prices = std::max(prices, std::abs(p));
    }
    const double margin = 1e-13 * sets_ * (largest_ * (sets_ + 1) + prices);
    const double bound = value - margin;
    if (bound > sets_ * largest_ * (1.0 + 1e-9)) {
      return kForbidden;
    }
    const bool round = integers_ && margin < 1e-3 && std::abs(bound) < 1e12;
    return std::max(0.0, round ? std::ceil(bound - 1e-3) : bound);
  }

private:
  [[nodiscard]] std::size_t pair(int from, int to) const { return idx(from) * idx(sets_) + idx(to); }

  void checkIntegers(const GtspProblem& problem) {
    integers_ = std::all_of(problem.cost.begin(), problem.cost.end(), [](double c) { return std::isinf(c) || c == std::floor(c); });
  }

  /** The cheapest priced arc between every two sets. */
  void contract() {
    std::fill(between_.begin(), between_.end(), kForbidden);
    for (int from = 0; from < sets_; ++from) {
      for (int tail = first_[idx(from)]; tail < first_[idx(from) + 1]; ++tail) {
        const double* row = &cost_[idx(tail) * idx(nodes_)];
        const double base = nodePrice_[idx(tail)] + setPrice_[idx(from)];
        for (int to = 0; to < sets_; ++to) {
          if (to == from) {
            continue;
          }
          double least = kForbidden;
          int best = -1;
          for (int head = first_[idx(to)]; head < first_[idx(to) + 1]; ++head) {
            const double priced = row[head] - nodePrice_[idx(head)];
            best = priced < least ? head : best;
            least = priced < least ? priced : least;
          }
          if (least + base < between_[pair(from, to)]) {
            between_[pair(from, to)] = least + base;
            tail_[pair(from, to)] = tail;
            head_[pair(from, to)] = best;
          }
        }
      }
    }
  }

  int sets_;
  int nodes_ = 0;
  double largest_ = 0.0;
  bool integers_ = false;
  std::vector<int> first_;
  std::vector<double> cost_;
  std::vector<double> nodePrice_, nodeStep_, nodeExcess_, bestNodePrice_;
  std::vector<double> setPrice_, setStep_, setExcess_, bestSetPrice_;
  std::vector<double> between_;
  std::vector<int> tail_, head_;
};

}  // namespace

Result<double> lowerBound(const GtspProblem& problem, double upperBound, const BoundEffort& effort, const Job& job) {
  constexpr int kPatience = 10;  // rounds without gain until the steps are halved
  Ascent ascent(problem);
  double best = -kForbidden;
  double factor = 1.0;
  int idle = 0;
  for (int round = 0; round < effort.rounds && factor > 1e-4; ++round) {
    if (job.stopRequested()) {
      return fail(Errc::Cancelled, "stopped while computing a lower bound");
    }
    const double value = ascent.evaluate();
    if (value > best) {
      idle = value > best + 1e-4 * std::abs(best) ? 0 : idle + 1;
      best = value;
      ascent.remember();
    } else {
      ++idle;
    }
    const double excess = ascent.excess();
    const double goal = std::isinf(upperBound) ? 2.0 * std::abs(best) + 1.0 : upperBound;
    const bool late = effort.deadline && std::chrono::steady_clock::now() >= *effort.deadline;
    if (excess == 0.0 || ascent.safe(best) >= goal || late) {
      break;
    }
    if (idle >= kPatience) {
      idle = 0;
      factor *= 0.6;
      ascent.goBack();
      ascent.evaluate();
    }
    ascent.step(factor * std::max(goal - value, 1e-6 * std::abs(goal)) / excess);
  }
  return ascent.safe(best);
}

}  // namespace vp::tour
