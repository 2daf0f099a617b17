#pragma once

#include "core/tour/gtsp.h"

#include <cstddef>
#include <vector>

namespace vp::tour {

/** The costs of a problem less what is proved already: every closed tour costs at least `constant` and what it costs here.
 *  Nodes are numbered set by set; arcs inside a set are never read. Forbidden arcs cost more than any tour without one. */
class ReducedCosts {
public:
  explicit ReducedCosts(const GtspProblem& problem);

  [[nodiscard]] int sets() const { return static_cast<int>(first_.size()) - 1; }
  [[nodiscard]] int nodes() const { return static_cast<int>(setOf_.size()); }
  [[nodiscard]] int first(int set) const { return first_[static_cast<std::size_t>(set)]; }
  [[nodiscard]] int end(int set) const { return first_[static_cast<std::size_t>(set) + 1]; }
  [[nodiscard]] int setOf(int node) const { return setOf_[static_cast<std::size_t>(node)]; }
  [[nodiscard]] double* row(int tail) { return &cost_[static_cast<std::size_t>(tail) * setOf_.size()]; }
  [[nodiscard]] const double* row(int tail) const { return &cost_[static_cast<std::size_t>(tail) * setOf_.size()]; }
  [[nodiscard]] double largest() const { return largest_; }
  [[nodiscard]] double constant() const { return constant_; }

  /** Adds to every arc the prices of its tail and of its tail's set and takes away the price of its head: every tour
   *  changes by the sum of the sets' prices. Then what leaves each set at least goes into the constant; no arc is negative. */
  void apply(const std::vector<double>& nodePrice, const std::vector<double>& setPrice);

  /** Says that every tour has an arc of a kind whose costs were lowered by `weight`. */
  void addCut(double weight);

  /** All arcs turned around; tours are the same, flown backwards. */
  void transpose();

  /** A value as a bound that holds: what rounding may have added is taken off, whole numbers are rounded up, and
   *  kForbidden stands for what no tour without forbidden arcs can cost. */
  [[nodiscard]] double safe(double value) const;

private:
  std::vector<int> first_, setOf_;
  std::vector<double> cost_;
  double largest_ = 0.0;
  double constant_ = 0.0;
  double magnitude_ = 0.0;  ///< the largest number that a cost was made from
  double changes_ = 100.0;  ///< how often a cost was rounded at most
  bool integers_ = false;
};

}  // namespace vp::tour
