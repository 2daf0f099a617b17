#include "core/landing/build_roadmap.h"

#include "core/landing/rrt_star.h"

#include <limits>
#include <utility>

namespace vp::landing {

Result<std::shared_ptr<const Roadmap>> buildRoadmap(const World& world, const mission::PlannerSettings& settings, const RoadmapRequest& request,
                                                    const Job& job, std::int64_t* expansions) {
  RrtStarOptions options;
  options.area = request.area;
  options.samples = settings.roadmapSamples.value_or(settings.roadmapTime ? std::numeric_limits<int>::max() / 64 : defaultSamples(request.area));
  options.seed = settings.seed;
  options.grew = request.grew;
  if (settings.roadmapTime) {
    options.seconds = settings.roadmapTime->si();
  }
  RrtStarStatistics statistics;
  Result<TreeRoadmap> built = buildRrtStarRoadmap(world, options, job, &statistics);
  if (!built) {
    return forward(built);
  }
  if (expansions != nullptr) {
    *expansions = statistics.expansions;
  }
  return std::make_shared<const TreeRoadmap>(std::move(*built));
}

}  // namespace vp::landing
