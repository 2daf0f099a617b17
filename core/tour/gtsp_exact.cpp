#include "core/tour/gtsp_exact.h"

#include "core/tour/gtsp_graph.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::tour {

namespace {

constexpr int kStarts = 4;  // start nodes handled together
constexpr double kMostValues = 64e6;
constexpr int kMostSets = 20;

using Values = std::array<double, kStarts>;
constexpr Values kNone = {kForbidden, kForbidden, kForbidden, kForbidden};

std::size_t smallestSet(const GtspProblem& problem) {
  const auto smaller = [](const std::vector<int>& a, const std::vector<int>& b) { return a.size() < b.size(); };
  return static_cast<std::size_t>(std::min_element(problem.sets.begin(), problem.sets.end(), smaller) - problem.sets.begin());
}

/** One table: least cost from each of up to four start nodes through a subset of the other sets to a node. */
class SubsetTable {
public:
  SubsetTable(const GtspProblem& problem, double upperBound) : problem_(problem), start_(smallestSet(problem)), limit_(upperBound * (1.0 + 1e-9)) {
    for (std::size_t set = 0; set < problem.sets.size(); ++set) {
      if (set == start_) {
        continue;
      }
      firstOf_.push_back(static_cast<int>(nodes_.size()));
      nodes_.insert(nodes_.end(), problem.sets[set].begin(), problem.sets[set].end());
    }
    firstOf_.push_back(static_cast<int>(nodes_.size()));
    others_ = static_cast<int>(firstOf_.size()) - 1;
    values_.resize((std::size_t{1} << others_) * nodes_.size());
    costBetween_.resize(nodes_.size() * nodes_.size());
    for (std::size_t head = 0; head < nodes_.size(); ++head) {
      for (std::size_t tail = 0; tail < nodes_.size(); ++tail) {
        costBetween_[head * nodes_.size() + tail] = problem.at(nodes_[tail], nodes_[head]);
      }
    }
    findRemainders();
  }

  [[nodiscard]] const std::vector<int>& startNodes() const { return problem_.sets[start_]; }

  /** False if stopped. */
  bool fill(std::size_t firstStart, const Job& job) {
    starts_.fill(-1);
    for (std::size_t k = 0; k < kStarts && firstStart + k < startNodes().size(); ++k) {
      starts_[k] = startNodes()[firstStart + k];
    }
    for (unsigned mask = 1; mask < (1U << others_); ++mask) {
      if (job.stopRequested()) {
        return false;
      }
      for (int set = 0; set < others_; ++set) {
        if ((mask >> set & 1U) != 0U) {
          fillSet(mask, set);
        }
      }
    }
    return true;
  }

  /** The best tour from these starts if it beats `best`. */
  void takeBest(double& best, std::optional<std::vector<int>>& tour) const {
    const unsigned full = (1U << others_) - 1U;
    for (std::size_t k = 0; k < kStarts; ++k) {
      for (int node = 0; starts_[k] >= 0 && node < static_cast<int>(nodes_.size()); ++node) {
        const double cost = value(full, node)[k] + problem_.at(nodes_[static_cast<std::size_t>(node)], starts_[k]);
        if (cost < best) {
          best = cost;
          tour = trace(full, node, k);
        }
      }
    }
  }

private:
  const Values& value(unsigned mask, int node) const { return values_[mask * nodes_.size() + static_cast<std::size_t>(node)]; }
  Values& value(unsigned mask, int node) { return values_[mask * nodes_.size() + static_cast<std::size_t>(node)]; }
  [[nodiscard]] double cost(int tail, int head) const {
    return costBetween_[static_cast<std::size_t>(head) * nodes_.size() + static_cast<std::size_t>(tail)];
  }
  [[nodiscard]] int firstOf(int set) const { return firstOf_[static_cast<std::size_t>(set)]; }

  /** What the sets outside a subset and the way home cost at least: the cheapest arc into each. */
  void findRemainders() {
    const std::vector<int> setOf = setOfNodes(problem_);
    std::vector<double> cheapest(problem_.sets.size(), kForbidden);
    for (int tail = 0; tail < problem_.nodes; ++tail) {
      for (int head = 0; head < problem_.nodes; ++head) {
        const auto set = static_cast<std::size_t>(setOf[static_cast<std::size_t>(head)]);
        if (static_cast<int>(set) != setOf[static_cast<std::size_t>(tail)]) {
          cheapest[set] = std::min(cheapest[set], problem_.at(tail, head));
        }
      }
    }
    const double home = cheapest[start_];
    cheapest.erase(cheapest.begin() + static_cast<std::ptrdiff_t>(start_));
    remainder_.assign(std::size_t{1} << others_, home);
    for (std::size_t mask = 0; mask < remainder_.size(); ++mask) {
      for (std::size_t set = 0; set < cheapest.size(); ++set) {
        remainder_[mask] += (mask >> set & 1U) == 0U ? cheapest[set] : 0.0;
      }
    }
  }

  void fillSet(unsigned mask, int set) {
    const unsigned rest = mask & ~(1U << set);
    for (int head = firstOf(set); head < firstOf(set + 1); ++head) {
      Values least = kNone;
      if (rest == 0U) {
        for (std::size_t k = 0; k < kStarts; ++k) {
          least[k] = starts_[k] >= 0 ? problem_.at(starts_[k], nodes_[static_cast<std::size_t>(head)]) : kForbidden;
        }
      }
      for (int before = 0; before < others_; ++before) {
        if ((rest >> before & 1U) == 0U) {
          continue;
        }
        for (int tail = firstOf(before); tail < firstOf(before + 1); ++tail) {
          const Values& from = value(rest, tail);
          const double arc = cost(tail, head);
          for (std::size_t k = 0; k < kStarts; ++k) {
            const double sum = from[k] + arc;
            least[k] = sum < least[k] ? sum : least[k];
          }
        }
      }
      for (double& entry : least) {
        entry = entry + remainder_[mask] > limit_ ? kForbidden : entry;
      }
      value(mask, head) = least;
    }
  }

  /** Walks back: the tail is the one whose value and arc give exactly the value of the head. */
  [[nodiscard]] std::vector<int> trace(unsigned mask, int node, std::size_t start) const {
    std::vector<int> tour;
    while (true) {
      tour.push_back(nodes_[static_cast<std::size_t>(node)]);
      const auto above = std::upper_bound(firstOf_.begin(), firstOf_.end(), node);
      const unsigned rest = mask & ~(1U << (above - firstOf_.begin() - 1));
      if (rest == 0U) {
        break;
      }
      const double goal = value(mask, node)[start];
      int tail = -1;
      for (int set = 0; set < others_ && tail < 0; ++set) {
        for (int u = firstOf(set); (rest >> set & 1U) != 0U && u < firstOf(set + 1) && tail < 0; ++u) {
          tail = value(rest, u)[start] + cost(u, node) == goal ? u : -1;
        }
      }
      mask = rest;
      node = tail;
    }
    tour.push_back(starts_[start]);
    std::reverse(tour.begin(), tour.end());
    return tour;
  }

  const GtspProblem& problem_;
  std::size_t start_;
  double limit_;
  int others_ = 0;
  std::vector<int> nodes_;    ///< of the other sets, set by set
  std::vector<int> firstOf_;  ///< first entry of nodes_ by set
  std::array<int, kStarts> starts_{};
  std::vector<double> remainder_;
  std::vector<double> costBetween_;  ///< by head, then tail
  std::vector<Values> values_;       ///< by subset, then node
};

}  // namespace

bool fitsExactSearch(const GtspProblem& problem) {
  const auto sets = static_cast<int>(problem.sets.size());
  return sets <= kMostSets && std::exp2(sets - 1) * problem.nodes * kStarts <= kMostValues;
}

Result<std::optional<std::vector<int>>> solveExactly(const GtspProblem& problem, double upperBound, const Job& job) {
  SubsetTable table(problem, upperBound);
  double best = kForbidden;
  std::optional<std::vector<int>> tour;
  for (std::size_t first = 0; first < table.startNodes().size(); first += kStarts) {
    if (!table.fill(first, job)) {
      return fail(Errc::Cancelled, "stopped while searching the best tour");
    }
    table.takeBest(best, tour);
  }
  return tour;
}

}  // namespace vp::tour
