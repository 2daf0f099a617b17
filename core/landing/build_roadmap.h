#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/landing/roadmap.h"
#include "core/mission/mission.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace vp::landing {

struct RoadmapRequest {
  geo::Box area;  ///< where glides are wanted [m]
  int threads = 1;
  std::function<void(const Roadmap&)> grew;  ///< watches the roadmap grow where its kind grows; may not change anything
};

/** Builds the roadmap that a mission asks for (PlannerSettings::roadmap and the settings of that kind).
 *  @param expansions  if not null: poses that were added ([1] Table 3)
 *  @errors NoLandingSite (no site on known ground), OutOfRange (empty area), Cancelled   @threads pure */
Result<std::shared_ptr<const Roadmap>> buildRoadmap(const World& world, const mission::PlannerSettings& settings, const RoadmapRequest& request,
                                                    const Job& job, std::int64_t* expansions = nullptr);

}  // namespace vp::landing
