#pragma once

#include "core/emergency/fmt_search.h"
#include "core/emergency/landing_planner.h"

#include <string>
#include <utility>

namespace vp::emergency {

/** FMT* over points on the ground, made flyable by Dubins curves.
 *
 *  `fmt-octree`: first a few samples wherever a landing may lead, then more near the glide that they gave; legs are free if they lie in the octree
 *  of free space over ground that is enlarged by the least turning circle. `fmt`: as many samples at once, legs tested by steps. Both try a
 *  single curve to each runway first, and both end when their samples are used up: with a deadline that is not reached the answer depends on
 *  the seed only.
 *  @source [5] sections 4.1 and 4.2; what differs: README.md   @threads one thread, whatever the request allows */
class FmtPlanner final : public LandingPlanner {
public:
  explicit FmtPlanner(FmtOptions options) : options_(std::move(options)) {}

  [[nodiscard]] std::string_view name() const override { return options_.usesOctree ? "fmt-octree" : "fmt"; }
  [[nodiscard]] LandingAnswer plan(const LandingRequest& request) const override;

  /** The options of `fmt`: as many samples as the other draws in a round with a glide found. */
  static FmtOptions plain();

private:
  FmtOptions options_;
};

}  // namespace vp::emergency
