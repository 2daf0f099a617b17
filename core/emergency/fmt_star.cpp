#include "core/emergency/fmt_star.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace vp::emergency {
namespace {

/// Expansions between two questions whether to end: some ten microseconds each, more with many neighbours.
constexpr std::int64_t kPolled = 4;

}  // namespace

FmtStar::FmtStar(const FmtSpace& space, std::function<bool()> isOver)
    : space_(space), isOver_(std::move(isOver)), nodes_(space.size()), near_(space.size()) {
  nodes_[0].state = State::Open;
  open_.push_back({0.0, 0});
  counts_.visited = 1;
}

const std::vector<int>& FmtStar::nearOf(int node) {
  const auto at = static_cast<std::size_t>(node);
  if (!nodes_[at].isNearKnown) {
    space_.near(node, near_[at]);
    nodes_[at].isNearKnown = true;
  }
  return near_[at];
}

/// Joins an unvisited node to the open one through which it is cheapest, if that way is free.
void FmtStar::join(int node, std::vector<Queued>& joined) {
  Node& to = nodes_[static_cast<std::size_t>(node)];
  double least = std::numeric_limits<double>::infinity();
  int through = -1;
  for (const int other : nearOf(node)) {
    const Node& from = nodes_[static_cast<std::size_t>(other)];
    if (from.state != State::Open || space_.isGoal(other)) {
      continue;
    }
    const double cost = space_.arrival(from.parent, other, from.cost, node);
    if (cost < least) {
      least = cost;
      through = other;
    }
  }
  // the way that was blocked before is so still
  if (through < 0 || through == to.blocked) {
    return;
  }
  ++counts_.tested;
  if (space_.isFree(through, nodes_[static_cast<std::size_t>(through)].cost, node, least)) {
    to.cost = least;
    to.parent = through;
    joined.push_back({least, node});
  } else {
    to.blocked = through;
  }
}

void FmtStar::expand(int node) {
  joined_.clear();
  for (const int other : nearOf(node)) {
    if (nodes_[static_cast<std::size_t>(other)].state == State::Unvisited) {
      join(other, joined_);
    }
  }
  // open only now: none of them was to be joined through another
  for (const Queued& one : joined_) {
    nodes_[static_cast<std::size_t>(one.node)].state = State::Open;
    open_.push_back(one);
    std::push_heap(open_.begin(), open_.end());
    ++counts_.visited;
  }
}

int FmtStar::next(double most) {
  for (std::int64_t expanded = 0; !open_.empty(); ++expanded) {
    if (open_.front().cost > most || (isOver_ && expanded % kPolled == 0 && isOver_())) {
      return -1;
    }
    const int node = open_.front().node;
    std::pop_heap(open_.begin(), open_.end());
    open_.pop_back();
    const bool isGoal = space_.isGoal(node);
    if (!isGoal) {
      expand(node);
    }
    nodes_[static_cast<std::size_t>(node)].state = State::Closed;
    if (isGoal) {
      return node;
    }
  }
  return -1;
}

std::vector<int> FmtStar::wayTo(int node) const {
  std::vector<int> way;
  for (; node >= 0; node = nodes_[static_cast<std::size_t>(node)].parent) {
    way.push_back(node);
  }
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace vp::emergency
