#pragma once

#include "core/emergency/landing_answer.h"
#include "core/emergency/landing_request.h"

#include <string_view>

namespace vp::emergency {

/** One way to find a landing after an engine failure.
 *  @threads plan() is reentrant: a planner holds options only, never state of a request */
class LandingPlanner {
public:
  virtual ~LandingPlanner() = default;

  /** By which it is chosen on a command line: "anytime". */
  [[nodiscard]] virtual std::string_view name() const = 0;

  /** The best answer by the deadline, or earlier if there is nothing left to try. Stopped, it returns its best so far.
   *
   *  Where no runway can be reached: why not, and a path without a site if there is one (longestGlide). The same request gives the same answer
   *  where time does not decide. What does not make sense (requestFault) is answered with that sentence and no path.
   *  @pre request.world and request.mission are not null */
  [[nodiscard]] virtual LandingAnswer plan(const LandingRequest& request) const = 0;

protected:
  LandingPlanner() = default;
  LandingPlanner(const LandingPlanner&) = default;
  LandingPlanner(LandingPlanner&&) = default;
  LandingPlanner& operator=(const LandingPlanner&) = default;
  LandingPlanner& operator=(LandingPlanner&&) = default;
};

}  // namespace vp::emergency
