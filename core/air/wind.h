#pragma once

namespace vp::air {

/** Steady velocity of the air mass over the ground, ENU, *towards*, m/s. Calm is zero, not another type.
 *  "From" degrees and knots appear only in files and on screen. */
struct Wind {
  double east = 0.0;
  double north = 0.0;
  [[nodiscard]] bool isCalm() const { return east == 0.0 && north == 0.0; }
  bool operator==(const Wind&) const = default;
};

}  // namespace vp::air
