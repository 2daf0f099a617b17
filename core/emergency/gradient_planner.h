#pragma once

#include "core/emergency/gradient_options.h"
#include "core/emergency/gradient_search.h"
#include "core/emergency/holding_areas.h"
#include "core/emergency/landing_planner.h"

#include <memory>

namespace vp::emergency {

/** The contingency planner of [3]: the gradient-guided search with the Dubins ways as fallback, Algorithm 2, for the runways in range.
 *
 *  The Dubins ways are there first, and the search has until the deadline to do better; what is returned is the way of least risk of both, so it is
 *  never worse than either (the paper returns the search's, whatever it risks). With more than one thread both run side by side.
 *  @source Tekaslan, Atkins 2025, Gradient-guided search for autonomous contingency landing planning, Drones 9, 642
 *  What differs: WHY-gradient.md */
class GradientPlanner : public LandingPlanner {
public:
  /** @param holds  made before for the population of requests (HoldingAreas with searchRadius()); null: made in each request that holds */
  explicit GradientPlanner(const GradientOptions& options = {}, std::shared_ptr<const HoldingAreas> holds = nullptr,
                           const GradientLimits& limits = {})
      : options_(options), holds_(std::move(holds)), limits_(limits) {}

  [[nodiscard]] std::string_view name() const override { return "gradient"; }
  [[nodiscard]] LandingAnswer plan(const LandingRequest& request) const override;

private:
  GradientOptions options_;
  std::shared_ptr<const HoldingAreas> holds_;
  GradientLimits limits_;
};

/** The baselines of [3]: four Dubins types and S-turns, of which the one of least risk counts. */
class DubinsPlanner : public LandingPlanner {
public:
  explicit DubinsPlanner(const GradientOptions& options = {}) : options_(options) {}

  [[nodiscard]] std::string_view name() const override { return "dubins"; }
  [[nodiscard]] LandingAnswer plan(const LandingRequest& request) const override;

private:
  GradientOptions options_;
};

}  // namespace vp::emergency
