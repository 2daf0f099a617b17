#pragma once

#include "core/flight/curve.h"
#include "core/safety/glide_rates.h"
#include "core/safety/plan_conditions.h"

#include <optional>
#include <vector>

namespace vp::safety {

/** Height that rolling into turns and out of them may cost a glide beyond what the model counts, in which the bank changes at once: WHY.md
 * section 14. A change of bank takes its angle / rate of roll, and is charged as that much more time at the greatest rate of sink of the steeper
 * bank.
 *  @threads const */
class RollCost {
public:
  /** @pre the profile gives a rate of roll and is sound, as the conditions are; the rates are theirs */
  RollCost(const PlanConditions& conditions, const aircraft::AircraftProfile& profile, const GlideRates& rates);

  /** From one piece of a glide to the next [m], in the wind that makes the most of it. Pieces of no length do not count: pass none. */
  [[nodiscard]] double between(const flight::Piece& before, const flight::Piece& after) const;
  /** From a piece of the tour, flown at the airspeed of the tour, to the first of a glide [m]. */
  [[nodiscard]] double afterTour(const flight::Piece& tour, const flight::Piece& first) const;

  /** Costs up to and on each piece of a glide [m], never falling; rolling level at its end counts on its last piece.
   *  @param tour  flown before it; none: level */
  [[nodiscard]] std::vector<double> along(const std::optional<flight::Piece>& tour, const std::vector<flight::Piece>& pieces) const;

private:
  [[nodiscard]] double costOf(double angle, double tangent) const;

  double rate_ = 0.0;         // rad/s
  double airspeed_ = 0.0;     // m/s, greatest of the glide
  double levelSine_ = 0.0;    // sin(gamma) with wings level, in the greatest shear
  double inducedSine_ = 0.0;  // of it what grows with the square of the bank's tangent
  double glideBank_ = 0.0;    // greatest tangent of bank times radius in any wind [m]
  double leastBank_ = 0.0;    // the least of the same
  double tourBank_ = 0.0;     // the same of the tour
};

}  // namespace vp::safety
