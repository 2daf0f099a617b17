#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace vp::emergency {

/** What FMT* searches: samples, which are near one another, what going there costs and whether the way is free. Node 0 is the start. */
class FmtSpace {
public:
  virtual ~FmtSpace() = default;

  [[nodiscard]] virtual std::size_t size() const = 0;
  /** Appends the nodes near one: the same both ways. */
  virtual void near(int node, std::vector<int>& found) const = 0;
  /** Cost at `to`, coming straight from a node with this cost; infinity: not possible.
   *  @param parent  that `from` was reached from, -1 at the start: a course changes there */
  [[nodiscard]] virtual double arrival(int parent, int from, double cost, int to) const = 0;
  /** Whether that way is free. @param arrival  as above, finite */
  [[nodiscard]] virtual bool isFree(int from, double cost, int to, double arrival) const = 0;
  [[nodiscard]] virtual bool isGoal(int node) const = 0;

protected:
  FmtSpace() = default;
  FmtSpace(const FmtSpace&) = default;
  FmtSpace(FmtSpace&&) = default;
  FmtSpace& operator=(const FmtSpace&) = default;
  FmtSpace& operator=(FmtSpace&&) = default;
};

/** How an FmtStar went. */
struct FmtCounts {
  std::int64_t visited = 0;  ///< nodes of the tree
  std::int64_t tested = 0;   ///< ways whose freedom was asked for
};

/** Fast marching tree: grows a tree of least cost outwards over samples, each joined to the open node that is cheapest through it; only that one
 *  way is tested, and where it is blocked the sample waits for the next open node near it.
 *
 *  With arrival() a metric and samples that grow dense, costs converge to the optimum (asymptotic optimality, fmtRadius()).
 *  @source Janson, Schmerling, Clark, Pavone 2015, Fast Marching Tree, IJRR 34, Algorithm 2; [5] Algorithm A1. What differs: README.md */
class FmtStar {
public:
  /** @param isOver  asked now and then: true ends the search. May be empty. Space and isOver outlive this */
  explicit FmtStar(const FmtSpace& space, std::function<bool()> isOver = {});

  /** Grows on until a goal is closed: no cheaper way to it will be found. Nothing is joined through goals.
   *  @param most  gives up at the first node that costs more
   *  @return the goal; -1: there is no more, or the search was ended */
  int next(double most);

  [[nodiscard]] double costOf(int node) const { return nodes_[static_cast<std::size_t>(node)].cost; }
  /** From the start to a node of the tree, both included. */
  [[nodiscard]] std::vector<int> wayTo(int node) const;
  [[nodiscard]] const FmtCounts& counts() const { return counts_; }

private:
  enum class State : unsigned char { Unvisited, Open, Closed };
  struct Node {
    double cost = 0.0;
    int parent = -1;
    int blocked = -1;  ///< the node from which it was last found not to be free
    State state = State::Unvisited;
    bool isNearKnown = false;
  };
  struct Queued {
    double cost = 0.0;
    int node = 0;
    /// Dearest first, so that a heap gives the cheapest; ties by number.
    bool operator<(const Queued& other) const { return cost != other.cost ? cost > other.cost : node > other.node; }
  };

  const std::vector<int>& nearOf(int node);
  void join(int node, std::vector<Queued>& joined);
  void expand(int node);

  const FmtSpace& space_;
  std::function<bool()> isOver_;
  std::vector<Node> nodes_;
  std::vector<std::vector<int>> near_;
  std::vector<Queued> open_;    ///< a heap
  std::vector<Queued> joined_;  ///< by the node that is being expanded
  FmtCounts counts_;
};

}  // namespace vp::emergency
