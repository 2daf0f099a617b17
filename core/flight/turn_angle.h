#pragma once

#include "core/base/quantity.h"

namespace vp::flight {

/** The angle of a turn in its own direction, in [0, 2 pi). A turn closer to a full circle than 1e-9 rad is a turn of zero that
 *  rounding pushed below zero. For arguments within a few turns, where stepping is several times faster than fmod. */
inline double turnAngle(double radians) {
  constexpr double kTwoPi = 2.0 * Angle::kPi;
  constexpr double kFullCircleTolerance = 1e-9;
  while (radians < 0.0) {
    radians += kTwoPi;
  }
  while (radians >= kTwoPi) {
    radians -= kTwoPi;
  }
  return kTwoPi - radians < kFullCircleTolerance ? 0.0 : radians;
}

}  // namespace vp::flight
