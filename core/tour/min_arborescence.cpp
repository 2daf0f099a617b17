#include "core/tour/min_arborescence.h"

#include <cstddef>
#include <limits>
#include <utility>

namespace vp::tour {

namespace {

std::size_t cell(int u, int v, int n) {
  return static_cast<std::size_t>(u) * static_cast<std::size_t>(n) + static_cast<std::size_t>(v);
}

/** Vertices of one cycle of parents get one number, every other vertex its own. */
struct Contraction {
  std::vector<int> group;
  std::vector<char> onCycle;
  int groups = 0;
  bool any = false;
};

Contraction contractCycles(const std::vector<int>& parent, int n) {
  Contraction result{std::vector<int>(static_cast<std::size_t>(n), -1), std::vector<char>(static_cast<std::size_t>(n), 0), 0, false};
  std::vector<int> seenFrom(static_cast<std::size_t>(n), -1);
  const auto at = [](auto& list, int i) -> auto& {
    return list[static_cast<std::size_t>(i)];
  };
  for (int start = 0; start < n; ++start) {
    int v = start;
    while (v >= 0 && at(seenFrom, v) < 0) {
      at(seenFrom, v) = start;
      v = at(parent, v);
    }
    if (v < 0 || at(seenFrom, v) != start || at(result.onCycle, v) != 0) {
      continue;
    }
    result.any = true;
    for (int w = v; at(result.onCycle, w) == 0; w = at(parent, w)) {
      at(result.onCycle, w) = 1;
      at(result.group, w) = result.groups;
    }
    ++result.groups;
  }
  for (int v = 0; v < n; ++v) {
    if (at(result.group, v) < 0) {
      at(result.group, v) = result.groups++;
    }
  }
  return result;
}

}  // namespace

std::vector<int> minArborescence(const std::vector<double>& cost, int n, int root) {
  std::vector<int> parent(static_cast<std::size_t>(n), -1);
  std::vector<double> least(static_cast<std::size_t>(n), std::numeric_limits<double>::infinity());
  for (int u = 0; u < n; ++u) {
    for (int v = 0; v < n; ++v) {
      const double c = cost[cell(u, v, n)];
      if (u != v && v != root && c < least[static_cast<std::size_t>(v)]) {
        least[static_cast<std::size_t>(v)] = c;
        parent[static_cast<std::size_t>(v)] = u;
      }
    }
  }
  const Contraction smaller = contractCycles(parent, n);
  if (!smaller.any) {
    return parent;
  }
  const int m = smaller.groups;
  std::vector<double> reduced(static_cast<std::size_t>(m) * static_cast<std::size_t>(m), std::numeric_limits<double>::infinity());
  std::vector<std::pair<int, int>> arc(reduced.size());
  for (int u = 0; u < n; ++u) {
    for (int v = 0; v < n; ++v) {
      const int groupU = smaller.group[static_cast<std::size_t>(u)];
      const int groupV = smaller.group[static_cast<std::size_t>(v)];
      if (groupU == groupV || v == root) {
        continue;
      }
      const double c = cost[cell(u, v, n)] - (smaller.onCycle[static_cast<std::size_t>(v)] != 0 ? least[static_cast<std::size_t>(v)] : 0.0);
      if (c < reduced[cell(groupU, groupV, m)]) {
        reduced[cell(groupU, groupV, m)] = c;
        arc[cell(groupU, groupV, m)] = {u, v};
      }
    }
  }
  const std::vector<int> above = minArborescence(reduced, m, smaller.group[static_cast<std::size_t>(root)]);
  for (int group = 0; group < m; ++group) {
    if (above[static_cast<std::size_t>(group)] >= 0) {
      const auto [u, v] = arc[cell(above[static_cast<std::size_t>(group)], group, m)];
      parent[static_cast<std::size_t>(v)] = u;
    }
  }
  return parent;
}

}  // namespace vp::tour
