#pragma once

#include "core/emergency/landing_planner.h"

namespace vp::emergency {

/** The glide that the roadmap of the tour knows from here (landing::Roadmap::queryTurning), with the altitudes of a glide that begins where the
 *  aircraft is. A heuristic: the roadmap is a sample. Risk is told, not looked for.
 *
 *  A request without a roadmap gets the kind that its mission asks for, over all of the terrain, if that can be built within the deadline.
 *  @threads as many as the request allows while the roadmap is built */
class RoadmapPlanner final : public LandingPlanner {
public:
  [[nodiscard]] std::string_view name() const override { return "roadmap"; }
  [[nodiscard]] LandingAnswer plan(const LandingRequest& request) const override;
};

}  // namespace vp::emergency
