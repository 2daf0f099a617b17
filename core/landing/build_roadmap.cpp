#include "core/landing/build_roadmap.h"

#include "core/landing/lattice_roadmap.h"
#include "core/landing/rrt_star.h"

#include <limits>
#include <utility>

namespace vp::landing {
namespace {

Result<std::shared_ptr<const Roadmap>> buildLattice(const World& world, const RoadmapRequest& request, const Job& job, std::int64_t* expansions) {
  LatticeStatistics statistics;
  Result<LatticeRoadmap> built = buildLatticeRoadmap(world, {request.area, std::nullopt}, job, &statistics);
  if (!built) {
    return forward(built);
  }
  if (expansions != nullptr) {
    *expansions = statistics.reached;
  }
  const auto roadmap = std::make_shared<const LatticeRoadmap>(std::move(*built));
  if (request.grew) {
    request.grew(*roadmap);  // too fast to be watched while it grows
  }
  return roadmap;
}

Result<std::shared_ptr<const Roadmap>> buildTree(const World& world, const mission::PlannerSettings& settings, const RoadmapRequest& request,
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

}  // namespace

Result<std::shared_ptr<const Roadmap>> buildRoadmap(const World& world, const mission::PlannerSettings& settings, const RoadmapRequest& request,
                                                    const Job& job, std::int64_t* expansions) {
  return settings.roadmap == mission::RoadmapKind::Lattice ? buildLattice(world, request, job, expansions)
                                                           : buildTree(world, settings, request, job, expansions);
}

}  // namespace vp::landing
