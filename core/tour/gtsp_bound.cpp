#include "core/tour/gtsp_bound.h"

#include "core/tour/gtsp_cuts.h"
#include "core/tour/gtsp_reduced.h"
#include "core/tour/min_arborescence.h"

#include <algorithm>
#include <cmath>

namespace vp::tour {

namespace {

std::size_t idx(int i) {
  return static_cast<std::size_t>(i);
}

/** Looks for prices of sets and nodes whose 1-arborescence costs much. */
class Ascent {
public:
  explicit Ascent(const ReducedCosts& costs) : costs_(costs), sets_(costs.sets()), nodes_(costs.nodes()) {
    nodePrice_.assign(idx(nodes_), 0.0);
    nodeStep_ = bestNodePrice_ = nodePrice_;
    setPrice_.assign(idx(sets_), 0.0);
    setStep_ = bestSetPrice_ = setPrice_;
    between_.resize(idx(sets_) * idx(sets_));
    tail_.resize(between_.size());
    head_.resize(between_.size());
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

  [[nodiscard]] const std::vector<double>& nodePrice() const { return bestNodePrice_; }
  [[nodiscard]] const std::vector<double>& setPrice() const { return bestSetPrice_; }

private:
  [[nodiscard]] std::size_t pair(int from, int to) const { return idx(from) * idx(sets_) + idx(to); }

  /** The cheapest priced arc between every two sets. */
  void contract() {
    std::fill(between_.begin(), between_.end(), kForbidden);
    for (int from = 0; from < sets_; ++from) {
      for (int tail = costs_.first(from); tail < costs_.end(from); ++tail) {
        const double* row = costs_.row(tail);
        const double base = nodePrice_[idx(tail)] + setPrice_[idx(from)];
        for (int to = 0; to < sets_; ++to) {
          if (to == from) {
            continue;
          }
          double least = kForbidden;
          int best = -1;
          for (int head = costs_.first(to); head < costs_.end(to); ++head) {
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

  const ReducedCosts& costs_;
  int sets_;
  int nodes_;
  std::vector<double> nodePrice_, nodeStep_, nodeExcess_, bestNodePrice_;
  std::vector<double> setPrice_, setStep_, setExcess_, bestSetPrice_;
  std::vector<double> between_;
  std::vector<int> tail_, head_;
};

/** Steps for which a known tour, the value reached and the time are the measure. */
class BoundSearch {
public:
  BoundSearch(const GtspProblem& problem, double upperBound, const BoundEffort& effort, const Job& job)
      : costs_(problem), upper_(upperBound), effort_(effort), job_(job) {}

  Result<double> run() {
    constexpr double kUsefulGain = 1e-3;  // of the bound, in one pass of cuts and prices
    constexpr int kPatience = 3;
    if (!raisePrices(effort_.rounds, 1.0)) {
      return stopped();
    }
    std::int64_t budget = effort_.arcs;
    int idle = 0;
    for (int pass = 0; idle < kPatience && budget > 0 && !enough(); ++pass) {
      const double before = best_;
      if (!raiseCuts(costs_, pass % costs_.sets(), budget, effort_.deadline, job_) || !raisePrices(effort_.rounds / 4, 0.5)) {
        return stopped();
      }
      budget -= std::int64_t{effort_.rounds / 4} * costs_.nodes() * costs_.nodes() / 4;
      costs_.transpose();
      idle = best_ > before + kUsefulGain * std::abs(best_) ? 0 : idle + 1;
    }
    return costs_.safe(best_);
  }

private:
  static tl::unexpected<Error> stopped() { return fail(Errc::Cancelled, "stopped while computing a lower bound"); }
  [[nodiscard]] bool isLate() const { return effort_.deadline && std::chrono::steady_clock::now() >= *effort_.deadline; }
  [[nodiscard]] double goal() const { return std::isinf(upper_) ? 2.0 * std::abs(best_) + 1.0 : upper_; }
  [[nodiscard]] bool enough() const { return costs_.safe(best_) >= goal() || isLate(); }

  /** Subgradient steps; the best prices go into the costs. False if stopped by the job. */
  bool raisePrices(int rounds, double factor) {
    constexpr int kPatience = 10;  // rounds without gain until the steps are halved
    Ascent ascent(costs_);
    double best = -kForbidden;
    int idle = 0;
    for (int round = 0; round < rounds && factor > 1e-4; ++round) {
      if (job_.stopRequested()) {
        return false;
      }
      const double value = costs_.constant() + ascent.evaluate();
      if (value > best) {
        idle = value > best + 1e-4 * std::abs(best) ? 0 : idle + 1;
        best = value;
        ascent.remember();
      } else {
        ++idle;
      }
      best_ = std::max(best_, best);
      const double excess = ascent.excess();
      if (excess == 0.0 || enough()) {
        break;
      }
      if (idle >= kPatience) {
        idle = 0;
        factor *= 0.6;
        ascent.goBack();
        ascent.evaluate();
      }
      ascent.step(factor * std::max(goal() - value, 1e-6 * std::abs(goal())) / excess);
    }
    costs_.apply(ascent.nodePrice(), ascent.setPrice());
    best_ = std::max(best_, costs_.constant());
    return true;
  }

  ReducedCosts costs_;
  double upper_;
  const BoundEffort& effort_;
  const Job& job_;
  double best_ = -kForbidden;
};

}  // namespace

Result<double> lowerBound(const GtspProblem& problem, double upperBound, const BoundEffort& effort, const Job& job) {
  return BoundSearch(problem, upperBound, effort, job).run();
}

}  // namespace vp::tour
