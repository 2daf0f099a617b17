#include "core/tour/gtsp_cuts.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace vp::tour {

namespace {

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

/** The nodes that a set reaches for nothing. */
struct Group {
  std::vector<int> members;
  std::vector<char> has;  ///< by node
  bool reachesRoot = false;
};

class CutRaiser {
public:
  CutRaiser(ReducedCosts& costs, int root) : costs_(costs), root_(root), free_(1e-10 * costs.largest()), groups_(at(costs.sets())) {
    for (int set = 0; set < costs.sets(); ++set) {
      Group& group = groups_[at(set)];
      group.has.assign(at(costs.nodes()), 0);
      for (int node = costs.first(set); node < costs.end(set); ++node) {
        add(group, node);
      }
    }
  }

  /** The smallest group that does not reach the root; null if all do. */
  Group* smallest() {
    Group* best = nullptr;
    for (int set = 0; set < costs_.sets(); ++set) {
      Group& group = groups_[at(set)];
      if (set != root_ && !group.reachesRoot && (best == nullptr || group.members.size() < best->members.size())) {
        best = &group;
      }
    }
    return best;
  }

  /** Adds what the group reaches for nothing. @return the cheapest arc that leaves the group then */
  double grow(Group& group, std::int64_t& budget) {
    for (std::size_t seen = 0; seen < group.members.size(); ++seen) {
      const int tail = group.members[seen];
      const double* row = costs_.row(tail);
      for (int head = 0; head < costs_.nodes(); ++head) {
        if (row[head] <= free_ && group.has[at(head)] == 0 && costs_.setOf(head) != costs_.setOf(tail)) {
          add(group, head);
          group.reachesRoot = group.reachesRoot || costs_.setOf(head) == root_;
        }
      }
      budget -= costs_.nodes();
      if (group.reachesRoot) {
        return 0.0;
      }
    }
    double least = kForbidden;
    for (const int tail : group.members) {
      const double* row = costs_.row(tail);
      for (int head = 0; head < costs_.nodes(); ++head) {
        if (row[head] < least && group.has[at(head)] == 0 && costs_.setOf(head) != costs_.setOf(tail)) {
          least = row[head];
        }
      }
    }
    budget -= 2 * std::ssize(group.members) * costs_.nodes();
    return least;
  }

  void cut(const Group& group, double weight) {
    for (const int tail : group.members) {
      double* row = costs_.row(tail);
      for (int head = 0; head < costs_.nodes(); ++head) {
        if (group.has[at(head)] == 0 && costs_.setOf(head) != costs_.setOf(tail)) {
          row[head] -= weight;
        }
      }
    }
    costs_.addCut(weight);
  }

private:
  static void add(Group& group, int node) {
    group.has[at(node)] = 1;
    group.members.push_back(node);
  }

  ReducedCosts& costs_;
  int root_;
  double free_;
  std::vector<Group> groups_;
};

}  // namespace

bool raiseCuts(ReducedCosts& costs, int root, std::int64_t& budget, const std::optional<std::chrono::steady_clock::time_point>& deadline,
               const Job& job) {
  CutRaiser raiser(costs, root);
  while (Group* group = raiser.smallest()) {
    if (job.stopRequested()) {
      return false;
    }
    if (budget < 0 || (deadline && std::chrono::steady_clock::now() >= *deadline)) {
      return true;
    }
    const std::size_t size = group->members.size();
    const double weight = raiser.grow(*group, budget);
    if (group->reachesRoot || (group->members.size() > size && raiser.smallest() != group)) {
      continue;  // a smaller one first
    }
    raiser.cut(*group, weight);
  }
  return true;
}

}  // namespace vp::tour
