#pragma once

#include "core/aircraft/glide_model.h"
#include "core/base/quantity.h"

#include <optional>
#include <vector>

namespace vp::aircraft {

/** A turn that is flown: its radius over ground [m], to which side, +1 left, -1 right, 0 straight on, and how far [rad]. */
struct Bend {
  double radius = 0.0;
  int side = 0;
  double turned = 0.0;
};

/** Height that rolling may cost a glide besides what GlideModel counts, in which the bank changes at once: an upper bound. WHY.md, "Rolling".
 *
 *  A change of bank takes its angle / rate of roll. Who begins it so late that it is over only one such time after the model's change has flown at
 *  most that much longer, and never sunk faster than in the steeper of the two banks. A turn too short for its bank counts with the bank that an
 *  aircraft can have between rolling in and rolling out.  @threads const */
class RollLoss {
public:
  /** Rate of roll that turns are compared by where a profile has none: 14 CFR 23.157 (c)(1). */
  static constexpr double kUsualRate_dps = 15.0;

  RollLoss(const GlideModel& glide, double rollRate_dps);

  /** Costs up to and in each bend of a glide [m], never falling; level at its end. Bends of no length are none: pass none.
   *  @param tour  flown before it, at the tour's airspeed */
  [[nodiscard]] std::vector<double> along(Bend tour, const std::vector<Bend>& bends) const;

  /** From one bend of a glide to the next [m], whatever is flown before and after them: nearly what along() says, for comparing ways. */
  [[nodiscard]] double between(Bend before, Bend after) const;

private:
  /// Of rolling into a bend from level, and out of it to level [m].
  struct Ends {
    double in = 0.0;
    double out = 0.0;
  };
  [[nodiscard]] double sineAt(double bank) const;
  [[nodiscard]] double cost(double angle, double steepest) const;
  [[nodiscard]] double change(Bend before, Bend after) const;
  [[nodiscard]] double changeFromTour(Bend tour, Bend first) const;
  [[nodiscard]] Ends whole(Bend bend, double bankTimesRadius) const;
  [[nodiscard]] std::optional<Ends> brief(Bend bend) const;

  GlideModel glide_;
  double rate_ = 0.0;   ///< rad/s
  double shear_ = 0.0;  ///< greatest airspeed times the change of the wind with height / g
  double crab_ = 0.0;   ///< tangent of the greatest crab angle
  double most_ = 0.0;   ///< tangent of bank times radius, of a glide in the strongest wind behind [m]
  double tour_ = 0.0;   ///< the same of the tour
};

}  // namespace vp::aircraft
