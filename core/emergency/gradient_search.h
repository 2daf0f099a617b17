#pragma once

#include "core/emergency/best_descent.h"
#include "core/emergency/descent_flight.h"
#include "core/emergency/dubins_ways.h"
#include "core/emergency/gradient_cost.h"
#include "core/emergency/landing_request.h"
#include "core/risk/descent_risk.h"

#include <cstdint>
#include <vector>

namespace vp::emergency {

/** What a search may do. */
struct GradientLimits {
  int expansions = 1200;  ///< states taken from the queue at most
  int afterBest = 250;    ///< of these at most after the best way was found
};

/** What a search did. */
struct GradientCount {
  std::int64_t expanded = 0;   ///< states taken from the queue
  std::int64_t improved = 0;   ///< ways that were the best when they were found
  std::int64_t states = 0;     ///< prisms in the closed set
  std::int64_t connected = 0;  ///< states from which a Dubins way to the goal was tried
};

/** The gradient-guided tree search of [3] sections 4.2 to 4.6 and 5.1: best first by (23), actions of (14) with the adaptive segment length (18),
 *  hexagonal prisms as closed set, ways to the goal from states in the solution volume Z (57) to (59).
 *
 *  An action is flown as it is judged: the turn at once, then straight. The paper's states are corners of a polyline that is flown by, whose arcs it
 *  adds afterwards. Where the paper stops at the first state of Z, this goes on and offers every way it finds. See WHY-gradient.md.
 *  @threads as DescentFlight */
class GradientSearch {
public:
  /** @param people  null: the course and the descent alone guide   @param share  of the range of slopes on all segments
   *  @param best    is offered the ways; outlives this */
  GradientSearch(DescentFlight& flight, BestDescent& best, const GradientTask& task, const GradientOptions& options, const risk::LegRisk* risk,
                 const risk::DescentRisk* people, double share);

  /** @param before  pieces from the request's pose to the task's start   @param risk  of them */
  GradientCount run(const Pieces& before, double risk, const GradientLimits& limits, const Countdown& countdown);

private:
  struct State {
    geo::Pose pose;
    double altitude = 0.0;
    double flown = 0.0;
    double risk = 0.0;  ///< from the request's pose, as LandingRequest::risk has it
    int parent = -1;
    flight::Piece turn;  ///< of length 0: none
    flight::Piece straight;
  };
  struct Open {
    double cost = 0.0;
    int state = -1;
    /// Of equal costs the older state first, so that the order is the same everywhere.
    bool operator<(const Open& other) const { return cost != other.cost ? cost > other.cost : state > other.state; }
  };

  [[nodiscard]] double segmentLength(double altitude, double change) const;
  /// The state that an action leads to; false if the ground is too near or the goal too far.
  bool act(int parent, double change, State& next);
  /// (23) of a state that an action has led to; sets its risk.
  double costOf(State& state);
  [[nodiscard]] bool isInSolutionVolume(const State& state) const;
  bool connect(const Pieces& before, int state);
  [[nodiscard]] Pieces piecesTo(int state) const;

  DescentFlight* flight_;
  BestDescent* best_;
  GradientTask task_;
  GradientOptions options_;
  const risk::LegRisk* risk_;
  const risk::DescentRisk* people_;
  double share_;
  GradientCost cost_;
  DubinsWays ways_;
  std::vector<State> states_;
  double widestSegment_ = 0.0;
};

}  // namespace vp::emergency
