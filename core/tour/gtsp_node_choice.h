#pragma once

#include "core/tour/gtsp.h"
#include "core/tour/gtsp_graph.h"

#include <vector>

namespace vp::tour {

/** Chooses nodes for a fixed order of sets by a layered shortest path (Fischetti, Salazar, Toth 1997, "cluster
 *  optimization"): one layer per set, so the choice is the best there is between two fixed nodes. */
class NodeChooser {
public:
  explicit NodeChooser(const SetGraph& graph) : graph_(graph), reach_(static_cast<std::size_t>(graph.slots())) {}

  /** Re-chooses tour[from], ..., tour[from + count - 1] (positions modulo the tour's length, 1 <= count < length) and
   *  returns the cost of this stretch including the arcs from the node before it and to the node behind it. */
  float choose(std::vector<int>& tour, int from, int count);

private:
  const SetGraph& graph_;
  std::vector<float> reach_;  ///< by slot: least cost from the node before the stretch
};

/** The best nodes for the order in which `tour` visits the sets, around the whole loop and in double precision.
 *  Never costs more than `tour`. */
std::vector<int> bestNodesForOrder(const GtspProblem& problem, const std::vector<int>& setOfNode, const std::vector<int>& tour);

}  // namespace vp::tour
