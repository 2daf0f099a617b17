#pragma once

#include <vector>

namespace vp::tour {

/** The cheapest arborescence of a complete digraph: cost[u * n + v] of the arc u -> v, every vertex but `root` gets one
 *  parent and is reached from the root. Returns the parents, -1 for the root.
 *  @source Chu, Liu 1965; Edmonds 1967, "Optimum branchings"; all cycles of a level are contracted at once
 *  @cost O(n^2) per level, few levels */
std::vector<int> minArborescence(const std::vector<double>& cost, int n, int root);

}  // namespace vp::tour
