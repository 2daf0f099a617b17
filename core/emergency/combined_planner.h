#pragma once

#include "core/emergency/landing_planner.h"

#include <memory>
#include <utility>
#include <vector>

namespace vp::emergency {

/** Runs several planners within one deadline and returns the best path that the checker accepts, under the name of the planner that found it.
 *
 *  Planners run beside one another, as many at once as the request allows; with fewer threads than planners those that wait share the time that is
 *  left. What they find is judged while they go on, the newest of each; they are asked to stop early enough for the last to be judged too.
 *  Best is what comes through the weather more likely (in steps of one in a thousand), then what has the least risk, without a risk or at the same
 * the most height in hand, manoeuvres taken off; a path to a runway always before one to none, of which the one that gets farthest counts. Nothing is
 * returned that was not verified.
 *  @threads the checker runs on the calling thread beside the planners */
class CombinedPlanner final : public LandingPlanner {
public:
  /** @param planners   in the order in which they begin
   *  @param inWeather  that begin before them where the request has weather, and are not asked where it has none */
  explicit CombinedPlanner(std::vector<std::unique_ptr<const LandingPlanner>> planners,
                           std::vector<std::unique_ptr<const LandingPlanner>> inWeather = {})
      : planners_(std::move(planners)), inWeather_(std::move(inWeather)) {}

  [[nodiscard]] std::string_view name() const override { return "combined"; }
  [[nodiscard]] LandingAnswer plan(const LandingRequest& request) const override;

private:
  std::vector<std::unique_ptr<const LandingPlanner>> planners_;
  std::vector<std::unique_ptr<const LandingPlanner>> inWeather_;
};

}  // namespace vp::emergency
