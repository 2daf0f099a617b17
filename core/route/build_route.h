#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/landing/roadmap.h"
#include "core/mission/route.h"
#include "core/route/corners.h"

#include <memory>

namespace vp::route {

/** What re-flying a plan needs: the world of its glides and a roadmap over the area of its tour. Made once for all routes. */
struct Ground {
  landing::World world;
  std::shared_ptr<const landing::Roadmap> roadmap;
};

/** @param terrain  in the plan's frame, as for the checker   @errors as landing::buildRoadmap; OutOfRange - no tour; Cancelled */
Result<Ground> prepareGround(const mission::Plan& plan, std::shared_ptr<const terrain::ElevationGrid> terrain, const Job& job);

struct RouteOptions {
  double stepsPerDegree = 1e6;  ///< places are rounded to whole multiples of 1 / so many degrees, as the file will give them
  CornerLimits limits;
  double lateral = 8.0;  ///< m from the tour, half of it at a target, that are worth fewer waypoints
};

struct BuiltRoute {
  mission::Route route;
  /** The path that fly-by turns give, as a plan for core/safety. Its targets are where that path passes nearest to the targets
   *  of the tour (Route::visit), at the same height; it has no spirals, no bound and no certificate. */
  mission::Plan reflown;
};

/** Turns the tour, with the ways from and to home where the plan has them, into waypoints and flies them: fly-by turns of the tour's radius, altitude
 *  linear in distance. That path is nowhere below the tour nor below what its own glides need, and keeps the pitch limits; core/safety is to judge
 * it. A climb-out may be some feet lower than the plan's, as it is no steeper in whole feet.
 *  @param ground  null where nothing is known of it: then the route has no glides and can only be unverified
 *  @errors OutOfRange - no tour, ways that do not fit it, or turns that follow each other too closely; NoSolution - no glide from a point; Cancelled
 *  @threads pure   @cost one roadmap query for each decision point of the flown path */
Result<BuiltRoute> buildRoute(const mission::Plan& plan, const Ground* ground, const RouteOptions& options, const Job& job);

}  // namespace vp::route
