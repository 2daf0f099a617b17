#include "ui/jobs/plan_placement.h"

#include <algorithm>

namespace vp::jobs {
namespace {

/// Moves places from one frame into another.
struct Move {
  geo::LocalFrame from;
  geo::LocalFrame to;

  [[nodiscard]] geo::Point operator()(geo::Point p) const { return to.toPoint(from.toLatLon(p)); }
  [[nodiscard]] geo::Pose operator()(const geo::Pose& pose) const {
    const geo::LatLon place = from.toLatLon(pose.point());
    const geo::Point p = to.toPoint(place);
    return {p.x, p.y, to.headingOf(from.trueCourseOf(pose.heading, pose.point()), place)};
  }
};

}  // namespace

std::shared_ptr<const mission::Plan> placedIn(std::shared_ptr<const mission::Plan> plan, const geo::LocalFrame& frame,
                                              const terrain::ElevationGrid& grid) {
  if (!(plan->frameOrigin == frame.origin())) {
    auto moved = std::make_shared<mission::Plan>(*plan);
    const Move move{geo::LocalFrame(plan->frameOrigin), frame};
    moved->frameOrigin = frame.origin();
    for (mission::DecisionPoint& point : moved->tour) {
      point.pose = move(point.pose);
    }
    for (mission::SiteInFrame& site : moved->sites) {
      site.pose = move(site.pose);
    }
    for (mission::TargetInFrame& target : moved->targets) {
      target.point = move(target.point);
    }
    plan = std::move(moved);
  }
  const bool isCovered =
      std::all_of(plan->tour.begin(), plan->tour.end(), [&grid](const mission::DecisionPoint& point) { return grid.isKnownAt(point.pose.point()); });
  return isCovered ? plan : nullptr;
}

}  // namespace vp::jobs
