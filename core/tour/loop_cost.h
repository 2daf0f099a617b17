#pragma once

#include "core/flight/curve.h"
#include "core/tour/forbidden_airspace.h"
#include "core/tour/profile.h"

#include <deque>
#include <limits>
#include <span>
#include <vector>

namespace vp::tour {

/** How deep a spiral at a visit may go ([1] Fig. 7). */
struct SpiralGround {
  double bottom = std::numeric_limits<double>::infinity();  ///< lowest height that the ground or the target allows [m MSL]
  double circle = 0.0;                                      ///< circumference [m]
  flight::Turn turn = flight::Turn::Left;
  std::vector<HeightGate> gates = {};  ///< of forbidden airspace beside the circle

  /** The ground for a spiral from `top`: no lower than the airspaces below it; infinite bottom if it begins inside one. */
  [[nodiscard]] double bottomFrom(double top) const;
};

/** What a visit costs in the loop. */
struct LoopVisit {
  double altitude = 0.0;  ///< of the target, m MSL
  SpiralGround spiral;    ///< infinite bottom where the tour passes above
};

/** A leg between two visits as the loop sees it: all that its lowest altitudes S_j can do to a profile.
 *
 *  The loop raises the ends of a leg to z_0 and z_m, passes pitch limits over it, and takes the least concave majorant. With
 *  z_0 >= startNeed and z_m >= endNeed that majorant is the upper hull of S_j and the two ends: an altitude that a pitch limit
 *  asks for lies on a line from some S_j down to at most an end, so under the chord between the two. */
struct LegShape {
  struct Corner {
    double distance = 0.0;  ///< from the start of the leg, m
    double altitude = 0.0;  ///< m MSL
  };

  double length = std::numeric_limits<double>::infinity();  ///< over ground, m
  double startNeed = 0.0;                                   ///< lowest start from which every S_j is reached within the climb limit, m MSL
  double endNeed = 0.0;                                     ///< lowest end that the descent limit allows behind every S_j, m MSL
  double peak = 0.0;                                        ///< highest S_j, m MSL
  std::vector<Corner> hull;                                 ///< upper hull of S_j between the ends

  struct Gate {
    double from = 0.0;  ///< m from the start of the leg
    double to = 0.0;
    HeightGate gate;
  };
  std::vector<Gate> gates = {};  ///< that S_j passes below: a loop that is higher may have to go over them
};

/** @param distance  of the points from the start, ascending from 0   @param lowest  S_j, before pitch limits */
LegShape shapeOf(std::span<const double> distance, std::span<const double> lowest, PitchLimits limits, std::span<const LegShape::Gate> gates = {});

/** Cost of a closed loop of legs, as assembleTour builds it: the higher end at each visit, pitch limits around the loop, and
 *  the least concave majorant between visits. Length in space and penalty, [1] (5). Rises with every S_j where no spirals are
 *  flown, so that legs with too low S_j give a lower bound (segment.h).
 *  @threads one object per thread: it keeps working memory */
class LoopCost {
public:
  /** @param ceiling  m MSL; loops that pass above it cost infinitely much */
  LoopCost(PitchLimits limits, double beta, double ceiling) : limits_(limits), beta_(beta), ceiling_(ceiling) {}

  /** @param legs  leg i leads from visit i to the next, the last to the first   @cost O(visits + corners) */
  [[nodiscard]] double operator()(std::span<const LegShape* const> legs, std::span<const LoopVisit> visits);

private:
  bool passGates(std::span<const LegShape* const> legs, std::span<const LoopVisit> visits);
  bool raiseOverGates(std::size_t leg, double start, double end, bool& isRaised);
  void layChain(const LegShape& leg, double start, double end);
  void findAltitudes(std::span<const LegShape* const> legs, std::span<const LoopVisit> visits);
  [[nodiscard]] double lengthOf(const LegShape& leg, double start, double end);
  [[nodiscard]] double costOf(const LoopVisit& visit, double altitude) const;

  PitchLimits limits_;
  double beta_ = 2.0;
  double ceiling_ = std::numeric_limits<double>::max();
  std::vector<double> altitude_;  ///< at the visits
  std::vector<LegShape::Corner> chain_;
  std::vector<const LegShape*> legs_;
  std::deque<LegShape> raised_;  ///< that have to go over forbidden airspace in this loop
};

/** Spiral from `top` to its bottom and back: whole circles down and up, none if it gains less than a metre. */
struct SpiralTurns {
  int down = 0;
  int up = 0;
};
SpiralTurns spiralTurns(const SpiralGround& ground, double top, PitchLimits limits);

/** Length of a spiral [m]. */
double spiralLength(const SpiralGround& ground, double top, SpiralTurns turns);

}  // namespace vp::tour
