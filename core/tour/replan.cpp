#include "core/tour/replan.h"

#include "core/mission/glide_conditions.h"

#include <algorithm>
#include <utility>

namespace vp::tour {
namespace {

bool sameWorld(const PlanInput& a, const PlanInput& b) {
  return a.terrain == b.terrain && a.frame == b.frame && a.sites == b.sites && a.mission.aircraft == b.mission.aircraft &&
         a.mission.safety == b.mission.safety && mission::sameConditions(a.mission, b.mission);
}

bool sameRoadmapSettings(const mission::PlannerSettings& a, const mission::PlannerSettings& b) {
  return a.roadmap == b.roadmap && a.roadmapSamples == b.roadmapSamples && a.roadmapTime == b.roadmapTime &&
         (a.roadmap == mission::RoadmapKind::Lattice || a.seed == b.seed);
}

bool isInside(const geo::Box& inner, const geo::Box& outer) {
  return inner.minX >= outer.minX && inner.minY >= outer.minY && inner.maxX <= outer.maxX && inner.maxY <= outer.maxY;
}

/// The visits of the last tour whose targets are still where they were, by the numbers of the new input.
std::vector<VisitPose> keptVisits(const std::vector<VisitPose>& visits, const PlanInput& last, const PlanInput& input) {
  std::vector<VisitPose> kept;
  std::vector<bool> used(input.targets.size(), false);
  for (VisitPose visit : visits) {
    const mission::TargetInFrame& old = last.targets[static_cast<std::size_t>(visit.target)];
    for (std::size_t t = 0; t < input.targets.size(); ++t) {
      if (!used[t] && input.targets[t].point == old.point && input.targets[t].altitude == old.altitude) {
        used[t] = true;
        visit.target = static_cast<int>(t);
        kept.push_back(visit);
        break;
      }
    }
  }
  return kept;
}

}  // namespace

PlanBasis Planner::usable(const PlanInput& input) const {
  PlanBasis basis;
  if (!last_ || last_->terrain != input.terrain) {
    return basis;
  }
  basis.pyramid = basis_.pyramid;
  const mission::PlannerSettings& old = last_->mission.planner;
  const mission::PlannerSettings& now = input.mission.planner;
  if (!sameWorld(*last_, input) || !sameRoadmapSettings(old, now) || !basis_.roadmap || !isInside(roadmapArea(input), basis_.area)) {
    return basis;
  }
  basis = basis_;
  const std::vector<VisitPose> kept = keptVisits(basis_.visits, *last_, input);
  // From a few changes on, an order of its own is worth its search.
  const std::size_t most = std::max<std::size_t>(1, input.targets.size() / 5);
  const bool isSmallChange = kept.size() >= 3 && input.targets.size() - kept.size() <= most && last_->targets.size() - kept.size() <= most;
  const bool sameMeasure = old.step == now.step && old.beta == now.beta && old.lowTargets == now.lowTargets && old.seed == now.seed &&
                           old.headings == now.headings && old.method == now.method && last_->mission.ceiling == input.mission.ceiling &&
                           last_->mission.airspace == input.mission.airspace && last_->airspaces == input.airspaces;
  const bool isSameTask = last_->targets == input.targets;  // nothing to place anew: the whole search may do better, and gives a bound
  basis.visits = isSmallChange && !isSameTask && sameMeasure && now.refine == mission::Refine::Full ? kept : std::vector<VisitPose>{};
  return basis;
}

Result<mission::Plan> Planner::plan(const PlanInput& input, const Job& job, PlanTimes* times, const PlanObserver& observer, PlanFailure* failure) {
  PlanBasis basis = usable(input);
  PlanReuse reuse{basis.roadmap != nullptr, !basis.visits.empty()};
  Result<mission::Plan> plan = planTour(input, job, times, observer, failure, &basis);
  if (!plan && plan.error().code == Errc::NoSolution && reuse.tour) {
    basis.visits.clear();
    reuse.tour = false;
    plan = planTour(input, job, times, observer, failure, &basis);
  }
  if (plan) {
    last_ = input;
    basis_ = std::move(basis);
    reused_ = reuse;
  }
  return plan;
}

}  // namespace vp::tour
