#pragma once

#include "core/emergency/landing_planner.h"

#include <cstdint>

namespace vp::emergency {

/** Any-time informed RRT* from the aircraft's state: a first answer from direct glides to every runway, then better ones until the deadline.
 *
 *  A tree of poses, each with the most altitude that the aircraft can have there (with a risk: the least risk). Samples count only where the
 *  least loss from the aircraft and the least loss on to some runway leave more height in hand than the best answer so far; the same bound keeps
 *  the tree's own poses in or out. New poses choose the best parent among their neighbours, the aircraft itself and the parent's ancestors, then
 *  rewire their neighbours. Ends without deadline only where the bound proves that nothing better by half a metre exists, or after `iterations`.
 *
 *  @source Vana, Slama, Faigl, Pecenka 2018, Any-time trajectory planning for safe emergency landing, IROS (ref. 36 of Vana, Faigl, Slama 2020): a
 *  tree that grows from the runways; here it grows forwards, as a request has one start, and ends of different height are told apart by height in
 *  hand. Gammell, Srinivasa, Barfoot 2014, Informed RRT*, IROS (samples within ellipses; here one per runway, losses by course in wind); Karaman,
 *  Frazzoli 2011 (rewiring, neighbour radius); Jeong, Lee, Kim 2019 (ancestors)
 *  @threads one thread, whatever the request allows */
class AnytimePlanner final : public LandingPlanner {
public:
  /** @param iterations  at most, samples that were thrown away included; with a deadline that is not reached the answer depends on the seed only */
  explicit AnytimePlanner(std::int64_t iterations = 100'000'000) : iterations_(iterations) {}

  [[nodiscard]] std::string_view name() const override { return "anytime"; }
  [[nodiscard]] LandingAnswer plan(const LandingRequest& request) const override;

private:
  std::int64_t iterations_;
};

}  // namespace vp::emergency
