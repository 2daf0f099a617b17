#pragma once

#include "core/tour/gtsp_graph.h"
#include "core/tour/gtsp_node_choice.h"
#include "core/tour/gtsp_random.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace vp::tour {

/** A current tour of slots and a candidate that a random move made from it, with its cost.
 *  After a move, only nodes near a changed place are chosen anew (layered shortest path between nodes that stay). */
class TourMoves {
public:
  TourMoves(const SetGraph& graph, Random& random);

  /** Forgets what a run before left behind, so that the next depends on the seed alone. */
  void restart();

  /** Makes the moves begin at one of these sets; an empty list means all. */
  void focusOn(std::vector<int> sets) { focus_ = std::move(sets); }

  /** Takes a tour as the current one. */
  void setCurrent(const std::vector<int>& slots);

  /** Makes a current tour by inserting the sets in random order, each where it is cheapest. */
  void buildRandomly();

  /** Ruin and recreate: takes strings of neighbouring sets out and puts each set back where it costs least.
   *  @source Christiaens, Vanden Berghe 2020, "Slack induction by string removals" (strings of neighbouring places);
   *  Smith, Imeson 2017, "GLNS" (insertion with node choice). Here the neighbours of the place choose again too. */
  float ruinAndRecreate(int mostRemoved);

  /** Turns a stretch around so that a set is followed by one of its near sets, all nodes of the stretch chosen anew. */
  float reverseStretch();

  /** Moves a stretch behind one of the near sets of its end, sometimes turned around. */
  float moveStretch();

  /** Makes the candidate the current tour. */
  void accept();

  /** Chooses all nodes of the current tour anew with one node fixed. */
  void polishCurrent();

  [[nodiscard]] float currentCost() const { return currentCost_; }
  [[nodiscard]] const std::vector<int>& current() const { return current_; }

private:
  struct Place {
    float added = 0.0F;
    int after = 0;  ///< set
  };

  void openLists();
  void removeStrings(int count);
  void takeOut(int set);
  void putBack(int set);
  void findPlaces(int set);
  void considerPlace(int set, int after);
  bool insertWithNeighbours(int set);
  void insert(int set, int slot, int after);
  void readLists(int start);
  void measureLink(int set);
  void touch(int set) { touched_[static_cast<std::size_t>(set)] = 1; }
  float finishCandidate();
  float costOfStretches();
  void sampleSkip();
  [[nodiscard]] int pickSet();
  [[nodiscard]] int near(int set, int closest);

  const SetGraph& graph_;
  Random& random_;
  NodeChooser chooser_;
  int sets_;
  std::vector<int> current_, candidate_;  ///< slots in visiting order
  std::vector<int> position_;             ///< by set, in the current tour
  std::vector<float> arc_;                ///< by set, cost of the arc that leaves it in the current tour
  float currentCost_ = 0.0F;
  float candidateCost_ = 0.0F;
  // the tour under change, by set
  std::vector<int> next_, previous_, slot_;
  std::vector<float> link_;  ///< cost of the arc to the next set
  std::vector<char> inTour_, touched_, fresh_;
  int count_ = 0;
  std::vector<int> removed_;
  std::vector<Place> places_;
  std::vector<std::uint64_t> seen_;  ///< the search for a place that looked behind this set last
  std::uint64_t search_ = 0;
  std::vector<float> arrive_, leave_;
  int untilSkip_ = 0;
  std::vector<int> focus_;
};

}  // namespace vp::tour
