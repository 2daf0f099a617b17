#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/landing/tree_roadmap.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace vp::landing {

struct RrtStarOptions {
  geo::Box area;                  ///< where samples are drawn [m]
  int samples = 7500;             ///< expansions to make
  std::optional<double> seconds;  ///< stop earlier after this time; the result then depends on the machine
  std::uint64_t seed = 1;
  std::function<void(const TreeRoadmap&)> grew;  ///< watches the roadmap grow, every 500 expansions; may not change anything
};

/** How a roadmap was built. */
struct RrtStarStatistics {
  std::int64_t expansions = 0;  ///< nodes added
  std::int64_t rejected = 0;    ///< samples without any safe glide
};

/** Builds the roadmap of landing glides over all sites at once.
 *
 *  [1] Algorithm 1: draw a pose uniformly, steer from it towards the nearest node and keep the last part of that
 *  glide, connect the new pose to the parent that needs the least height (Near and the sites), rewire the neighbours
 *  that a glide through the new pose lowers. Differences, each because the paper's form is vague or not safe:
 *  - height condition with the loss up to each point (see required_height.h);
 *  - neighbours by plain distance within a radius that shrinks as sqrt(1/n), pre-sorted by an admissible bound;
 *    default RRT* neighbour counts for this dimension make most candidates useless (Karaman, Frazzoli 2011, (5));
 *  - ancestors of the chosen parent are tried as well (Quick-RRT*).
 *  Deterministic for a seed unless `seconds` is set.
 *  @errors NoLandingSite (no site on known ground), Cancelled   @threads pure */
Result<TreeRoadmap> buildRrtStarRoadmap(const World& world, const RrtStarOptions& options, const Job& job, RrtStarStatistics* statistics = nullptr);

/** Samples that give the density of [1] section 8 (7,500 on 25 km^2) on small areas and grow with the square root of
 *  the area on larger ones, where the aircraft is higher and detail matters less; at most 20,000. */
int defaultSamples(const geo::Box& area);

}  // namespace vp::landing
