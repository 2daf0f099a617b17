#pragma once

#include "core/flight/curve.h"
#include "core/safety/glide_rates.h"
#include "core/safety/plan_conditions.h"

#include <optional>
#include <vector>

namespace vp::safety {

/** Height that rolling into turns and out of them may cost a glide beyond what the model counts, in which the bank changes at once: WHY.md
 * section 14. A change of bank takes its angle / rate of roll, and is charged as that much more time at the greatest rate of sink of the steeper
 * bank. An arc too short for its bank is charged the bank that it can have between rolling in and out.
 *  @threads const */
class RollCost {
public:
  /** @pre the profile gives a rate of roll and is sound, as the conditions are; the rates are theirs */
  RollCost(const PlanConditions& conditions, const aircraft::AircraftProfile& profile, const GlideRates& rates);

  /** From one piece of a glide to the next [m], in the wind that makes the most of it. Pieces of no length do not count: pass none. */
  [[nodiscard]] double between(const flight::Piece& before, const flight::Piece& after) const;
  /** From a piece of the tour, flown at the airspeed of the tour, to the first of a glide [m]. */
  [[nodiscard]] double afterTour(const flight::Piece& tour, const flight::Piece& first) const;

  /** Greatest bank [rad] that an aircraft rolling by the profile's rate may have on an arc, if it rolls in until it must roll out again: upper bound
   * over all winds and airspeeds.  @param turned  course turned on it [rad] */
  [[nodiscard]] double bankWithin(double turned, double radius) const;

  /** Costs up to and on each piece of a glide [m], never falling; rolling level at its end counts on its last piece.
   *  @param tour  flown before it; none: level */
  [[nodiscard]] std::vector<double> along(const std::optional<flight::Piece>& tour, const std::vector<flight::Piece>& pieces) const;

private:
  /// Of rolling into an arc from level and out of it to level [m].
  struct Ends {
    double in = 0.0;
    double out = 0.0;
  };
  [[nodiscard]] double costOf(double angle, double tangent) const;
  [[nodiscard]] Ends wholeRolls(double tangent) const;
  [[nodiscard]] std::optional<Ends> shortRolls(const flight::Piece& arc) const;

  double rate_ = 0.0;         // rad/s
  double airspeed_ = 0.0;     // m/s, greatest of the glide
  double levelSine_ = 0.0;    // sin(gamma) with wings level, in the greatest shear
  double turnSine_ = 0.0;     // the same as a part of that in turns
  double inducedSine_ = 0.0;  // of it what grows with the square of the bank's tangent
  double glideBank_ = 0.0;    // greatest tangent of bank times radius in any wind [m]
  double leastBank_ = 0.0;    // the least of the same
  double tourBank_ = 0.0;     // the same of the tour
  double slowest_ = 0.0;      // m/s, least airspeed of the glide
  double strongest_ = 0.0;    // m/s, wind
  double kappa_ = 0.0;        // greatest airspeed x greatest change of the wind with height / gravity
};

}  // namespace vp::safety
