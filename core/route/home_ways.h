#pragma once

#include "core/base/result.h"
#include "core/route/layout.h"

#include <vector>

namespace vp::route {

/** Where a way from or to home is given an altitude: one of its own waypoints or one of the closed tour's. */
struct HomeKnot {
  int own = -1;           ///< index into HomeWay::corners
  int loop = -1;          ///< index into Layout::corners
  double distance = 0.0;  ///< m along the way
  double turned = 0.0;    ///< rad, of the turn there, left positive
};

/** A way from or to a home runway as waypoints, flown with fly-by turns. It runs from the far end of the runway to `join`, or from `join`
 *  to the threshold, and is the path of the closed tour at `join` and, before or behind it, at all that is not the way's. */
struct HomeWay {
  std::vector<mission::DecisionPoint> certified;  ///< what is flown, of the plan: its way and the part of its tour up to or from `join`
  double certifiedGuarantee = 0.0;                ///< m along it from which the plan promises glides
  std::vector<Corner> corners;                    ///< not those of the closed tour
  std::vector<geo::LatLon> places;                ///< of these, as the file will give them
  FlownPath path;
  std::vector<HomeKnot> knots;  ///< ascending
  std::size_t join = 0;         ///< corner of the closed tour in the middle of whose turn both paths are one
  Track track;
  Comparison comparison;
};

/** @param moreCircles  of the climb-out, in addition to the plan's, where whole feet cost more height than its last circle has left over
 *  @errors OutOfRange - turns that follow each other too closely   @pre plan.departure */
Result<HomeWay> flyDeparture(const mission::Plan& plan, const Layout& loop, const RouteOptions& options, int moreCircles);

/** The last turn leads onto the runway's centre line, as pilots fly it, wherever the file's rounding puts its waypoint.
 *  @errors OutOfRange - the same   @pre plan.arrival */
Result<HomeWay> flyArrival(const mission::Plan& plan, const Layout& loop, const RouteOptions& options);

/** Corners of the closed tour from that of the departure's last own leg to that of the arrival's first, in flying order: all targets are
 *  among them, and both ways have joined before they leave. */
std::vector<std::size_t> loopCornersFlown(const mission::Plan& plan, const Layout& loop, const HomeWay& departure, const HomeWay& arrival);

}  // namespace vp::route
