#pragma once

#include "core/safety/descent.h"

#include <limits>

namespace vp::safety {

/** The engine failure on one piece of a tour that leaves the aircraft lowest further on: WHY.md sections 4 and 12. Height above a glide is linear
 *  between breaks of the loss and altitudes at which it changes, so the lowest glide begins at one of those, or at the place itself, where the
 *  tour's own clearance speaks. The descent must outlive this. */
class Failures {
public:
  /** @param reactionLoss  lost at once at the failure [m] */
  Failures(double startAltitude, double endAltitude, double length, Descent& descent, double reactionLoss);

  /** Height [m MSL] at a distance of the lowest of all glides begun by a failure at 0 or at a break before it, the reaction loss counted as if it
   *  came here: so much is left plus that loss. Distances must not fall from call to call. */
  double lowestAt(double distance);

private:
  double lowestOfAll(double distance);
  double lowestByAltitude(double distance);
  [[nodiscard]] double altitudeAt(double distance) const { return start_ + rise_ * (distance / length_); }
  [[nodiscard]] double nextPlace() const;

  double start_ = 0.0;
  double rise_ = 0.0;
  double length_ = 0.0;
  Descent& descent_;
  double reactionLoss_ = 0.0;
  double least_ = 0.0;  // of altitude + loss; by altitude: height of the lowest glide at `at_`
  double next_ = 0.0;   // break of the loss beyond at_
  double at_ = 0.0;
};

}  // namespace vp::safety
