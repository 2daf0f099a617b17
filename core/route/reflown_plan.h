#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/landing/roadmap.h"
#include "core/mission/plan.h"
#include "core/route/fly_by.h"

#include <vector>

namespace vp::route {

/** Decision points of a flown path before their altitudes are known: spaced at most the plan's step, with a point at every
 *  distance asked for, each with the lowest glide that the roadmap, or gliding on along the path, has for it. */
struct FlownPoints {
  std::vector<mission::DecisionPoint> points;
  std::vector<double> distance;  ///< m from the start of the path
  std::vector<double> lowest;    ///< m MSL: ground, safe altitude, and the glide on to the next point
};

/** @param world  null, with the roadmap: points without glides   @param marks  distances at which a point must be   @errors NoSolution - a point from
 * which no glide reaches a site, or a stretch over ground of unknown height: the sentence says where; Cancelled */
Result<FlownPoints> flownPoints(const mission::Plan& plan, const landing::World* world, const landing::Roadmap* roadmap, const FlownPath& path,
                                std::vector<double> marks, const Job& job);

/** The same along an open way to `end`, a point whose glide is known. Points without a glide are no error: their `lowest` is infinite. */
Result<FlownPoints> openPoints(const landing::World* world, const landing::Roadmap* roadmap, const FlownPath& path, std::vector<double> marks,
                               double step, mission::DecisionPoint end, const Job& job);

}  // namespace vp::route
