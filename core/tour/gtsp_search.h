#pragma once

#include "core/base/job.h"
#include "core/tour/gtsp.h"
#include "core/tour/gtsp_graph.h"
#include "core/tour/gtsp_moves.h"
#include "core/tour/gtsp_random.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

namespace vp::tour {

using Deadline = std::optional<std::chrono::steady_clock::time_point>;

/** Large-neighbourhood search in rounds of simulated annealing over the moves of TourMoves. The best tour found so far is
 *  kept in double precision with the best nodes for its order. @pre four sets or more */
class TourSearch {
public:
  /** The graph must show the problem's costs whenever a function is called; both must outlive the search. */
  TourSearch(const GtspProblem& problem, const SetGraph& graph);

  /** Forgets all tours and begins anew. */
  void begin(std::uint64_t seed, double effort);

  /** Takes a known tour of nodes. */
  void startFrom(const std::vector<int>& tour);

  /** A short search from the best tour with moves that begin at these sets; false if stopped by the job.
   *  @pre startFrom was called */
  bool searchAround(const std::vector<int>& sets, const Deadline& deadline, const Job& job);

  /** One annealing; false if stopped by the job. */
  bool runRound(const Deadline& deadline, const Job& job);

  /** Rounds since the best tour became better. */
  [[nodiscard]] int roundsWithoutGain() const { return roundsWithoutGain_; }
  [[nodiscard]] std::int64_t rounds() const { return rounds_; }
  [[nodiscard]] const std::vector<int>& best() const { return best_; }
  [[nodiscard]] double bestCost() const { return bestCost_; }

private:
  struct MoveRecord {
    std::int64_t tries = 0;
    std::int64_t gains = 0;
  };

  bool anneal(std::int64_t steps, double hot, double cold, const Deadline& deadline, const Job& job);
  [[nodiscard]] double typicalArc() const;
  float tryMove();
  void adaptShares();
  void goOnFromBest();
  void offer(const std::vector<int>& tour);
  void offerCurrent();

  const GtspProblem& problem_;
  std::vector<int> setOfNode_;
  const SetGraph& graph_;
  Random random_{0};
  TourMoves moves_;
  double effort_ = 1.0;
  int mostRemoved_ = 0;
  int stretchPercent_ = 0;
  bool stretchMove_ = false;
  MoveRecord stretch_, ruin_;
  std::vector<int> best_;
  double bestCost_ = kForbidden;
  double scaledBest_ = kForbidden;  ///< the same as the graph counts
  float roundBest_ = 0.0F;
  bool warm_ = false;
  int roundsWithoutGain_ = 0;
  std::int64_t rounds_ = 0;
};

}  // namespace vp::tour
