#pragma once

#include "core/tour/gtsp.h"

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace vp::tour {

/** The problem as the search wants it: the nodes of a set are neighbouring "slots", every set is padded to whole vector
 *  lanes, costs are single-precision in both directions.
 *  Costs are scaled by a power of two, so integers stay exact while tours cost less than 2^24 units.
 *  A forbidden arc costs more than any tour without one; arcs of padding slots cost kPad and are never chosen. */
class SetGraph {
public:
  static constexpr int kLanes = 8;
  static constexpr float kPad = 1e30F;

  explicit SetGraph(const GtspProblem& problem);

  [[nodiscard]] int sets() const { return static_cast<int>(first_.size()) - 1; }
  [[nodiscard]] int slots() const { return slots_; }
  [[nodiscard]] int first(int set) const { return first_[static_cast<std::size_t>(set)]; }    ///< first slot of a set
  [[nodiscard]] int end(int set) const { return first_[static_cast<std::size_t>(set) + 1]; }  ///< one past its padded slots
  [[nodiscard]] int size(int set) const { return size_[static_cast<std::size_t>(set)]; }      ///< its real slots
  [[nodiscard]] int setOf(int slot) const { return setOf_[static_cast<std::size_t>(slot)]; }
  [[nodiscard]] int nodeOf(int slot) const { return nodeOf_[static_cast<std::size_t>(slot)]; }  ///< -1 for padding
  [[nodiscard]] int slotOf(int node) const { return slotOf_[static_cast<std::size_t>(node)]; }

  [[nodiscard]] int width(int set) const { return end(set) - first(set); }  ///< real and padding slots

  /** Costs of the arcs from a slot to the slots of a set, width(set) numbers. */
  [[nodiscard]] const float* out(int slot, int set) const { return &out_[rowStart(slot, set)]; }
  /** Costs of the arcs to a slot from the slots of a set, width(set) numbers. */
  [[nodiscard]] const float* in(int slot, int set) const { return &in_[rowStart(slot, set)]; }
  [[nodiscard]] float cost(int from, int to) const {
    const int set = setOf(to);
    return out(from, set)[to - first(set)];
  }

  /** What costs were multiplied with. */
  [[nodiscard]] double scale() const { return scale_; }

  /** A tour that costs this much or more has a forbidden arc. */
  [[nodiscard]] float forbidden() const { return forbidden_; }

  /** Whether this cost fits: forbidden arcs must stay dearer than any tour without one. If not, a new graph is needed. */
  [[nodiscard]] bool holds(double cost) const { return cost <= highest_ || cost > std::numeric_limits<double>::max(); }

  /** Changes one arc between nodes of different sets. @pre holds(cost)      @cost O(1) */
  void setCost(int fromNode, int toNode, double cost);

  /** Brings nearSets() up to date after setCost. @cost O(sets log sets) for each set that came nearer or went away */
  void refreshNearSets();

  /** The other sets, nearest first (cheapest arc either way); at most `neighbours()` of them. */
  [[nodiscard]] const int* nearSets(int set) const { return &near_[static_cast<std::size_t>(set) * static_cast<std::size_t>(nearCount_)]; }
  [[nodiscard]] int neighbours() const { return nearCount_; }

private:
  /** Pairs of sets are stored as blocks of width x width, so that what one step reads lies together. */
  [[nodiscard]] std::size_t rowStart(int slot, int set) const {
    const int own = setOf(slot);
    const auto start = static_cast<std::size_t>(first(own)) * static_cast<std::size_t>(slots_);
    return start + static_cast<std::size_t>(width(own)) * static_cast<std::size_t>(first(set)) +
           static_cast<std::size_t>(slot - first(own)) * static_cast<std::size_t>(width(set));
  }
  [[nodiscard]] std::size_t pairOf(int set, int other) const {
    return static_cast<std::size_t>(set) * static_cast<std::size_t>(sets()) + static_cast<std::size_t>(other);
  }
  [[nodiscard]] float rounded(double cost) const;
  void fillCosts(const GtspProblem& problem);
  void fillNearSets();
  void measureDistance(int set, int other);
  void sortNearSets(int set);

  int slots_ = 0;
  int nearCount_ = 0;
  double scale_ = 1.0;
  float forbidden_ = 0.0F;
  double highest_ = 0.0;  ///< the dearest arc that forbidden_ leaves room for
  std::vector<int> first_, size_, setOf_, nodeOf_, slotOf_, near_;
  std::vector<float> distance_;  ///< by pair of sets: the cheapest arc either way
  std::vector<char> pairStale_;  ///< by pair: its cheapest arc became dearer
  std::vector<char> nearStale_;  ///< by set: its order of nearness may have changed
  std::vector<std::pair<int, int>> stalePairs_;
  std::vector<float> out_, in_;
};

/** Cost of a closed tour of nodes; kForbidden if it uses a forbidden arc; 0 for a single node. */
double tourCost(const GtspProblem& problem, const std::vector<int>& tour);

/** Largest finite cost of an arc between different sets; 0 if there is none. */
double largestCost(const GtspProblem& problem, const std::vector<int>& setOfNode);

std::vector<int> setOfNodes(const GtspProblem& problem);

}  // namespace vp::tour
