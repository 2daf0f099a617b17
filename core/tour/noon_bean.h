#pragma once

#include "core/tour/gtsp.h"

#include <optional>
#include <vector>

namespace vp::tour {

/** A generalized TSP as an asymmetric TSP over the same nodes, with whole-number costs as solvers take them.
 *  The nodes of a set form a cycle of cost 0; every arc that leaves node v of a set starts at v's predecessor in that
 *  cycle instead and costs `penalty` more, so that an optimal tour enters a set, runs once through it and leaves: the
 *  node at which it enters is the node visited.
 *  @source Noon, Bean 1993, "An efficient transformation of the generalized traveling salesman problem", INFOR 31(1) */
struct NoonBean {
  int nodes = 0;
  std::vector<std::vector<int>> sets;
  std::vector<int> cost;  ///< row-major; forbiddenCost where no arc may be used
  double scale = 1.0;     ///< costs were multiplied by this and rounded: a tour is off by at most sets / (2 scale)
  int penalty = 0;        ///< more than any tour of the generalized problem costs, scaled
  int forbiddenCost = 0;  ///< more than any arc that may be used
};

/** Transforms. Costs are scaled so that a whole tour with all its penalties stays below 2^31 - 1: whole numbers that fit
 *  are kept as they are (scale 1), others get the largest power of two that fits. Empty if whole numbers of that size
 *  cannot tell the tours apart, which takes thousands of sets. @pre two sets or more, checkProblem holds */
std::optional<NoonBean> transformNoonBean(const GtspProblem& problem);

/** The tour of the generalized problem, one node per set: where each set is entered first. Any order of all nodes is
 *  understood, a tour that does not run through the sets one by one only gives a worse result. */
std::vector<int> decodeNoonBean(const GtspProblem& problem, const std::vector<int>& atspTour);

}  // namespace vp::tour
