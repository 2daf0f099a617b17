#pragma once

#include "core/emergency/landing_request.h"
#include "core/landing/rolling.h"
#include "core/safety/landing_check.h"

#include <memory>
#include <optional>

namespace vp::emergency {

/** The independent checker for the landing paths of one world and mission: built once, asked for many paths. What it works out about winds for one
 *  path serves the others: the first path in layers of wind takes milliseconds, others a tenth of one.
 *  @threads check() and rollingOf() may be called from many threads */
class LandingJudge {
public:
  /** Of the world, the mission and the frame of a request; keeps the first two.   @pre they are not null */
  explicit LandingJudge(const LandingRequest& request);

  [[nodiscard]] bool isOf(const LandingRequest& request) const;
  [[nodiscard]] safety::LandingReport check(const mission::LandingPath& path) const { return checker_.check(path); }
  /** Height that rolling into the turns of a path may cost [m]; none where the aircraft's profile gives no rate of roll. */
  [[nodiscard]] std::optional<double> rollingOf(const mission::LandingPath& path) const;

private:
  std::shared_ptr<const landing::World> world_;
  std::shared_ptr<const mission::Mission> mission_;
  geo::LatLon frameOrigin_;
  safety::LandingChecker checker_;
  std::optional<landing::Rolling> rolling_;  ///< where the profile gives a rate of roll
};

/** The request with a judge, its own if that fits it.   @pre world and mission are not null */
LandingRequest withJudge(LandingRequest request);

}  // namespace vp::emergency
