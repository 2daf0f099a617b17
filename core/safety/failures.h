#pragma once

#include "core/safety/glide_rates.h"

#include <algorithm>

namespace vp::safety {

/** The engine failure on one piece of a tour that leaves the aircraft lowest further on: WHY.md section 4. Altitude [m MSL] plus loss up to
 *  the failure is linear between breaks of the loss, so its least is at one of them, or at the place itself, where the tour's own clearance
 *  speaks. The loss must outlive this. */
class Failures {
public:
  Failures(double startAltitude, double endAltitude, double length, const LossAlong& loss)
      : start_(startAltitude), rise_(endAltitude - startAltitude), length_(length), loss_(loss), least_(startAltitude), next_(loss.nextBreak(0.0)) {}

  /** Least of altitude + loss over failures at 0 and at all breaks before a distance. Distances must not fall from call to call. */
  double leastBefore(double distance) {
    while (next_ < distance) {
      least_ = std::min(least_, start_ + rise_ * (next_ / length_) + loss_.upTo(next_));
      next_ = loss_.nextBreak(next_);
    }
    return least_;
  }

private:
  double start_ = 0.0;
  double rise_ = 0.0;
  double length_ = 0.0;
  const LossAlong& loss_;
  double least_ = 0.0;
  double next_ = 0.0;
};

}  // namespace vp::safety
