#pragma once

#include "core/flight/curve.h"
#include "core/mission/mission.h"

#include <optional>
#include <vector>

namespace vp::safety {

/** What holds on the last part of every glide, from the gate to the touchdown point: WHY.md section 11. The default: there is none. */
struct LastPart {
  std::optional<double> slope;         ///< height lost per metre over ground; none: what the glide loses
  std::optional<double> surfaceSlope;  ///< of the obstacle surface; none: the whole clearance
  double surfaceStart = 0.0;           ///< m of path before the touchdown point at which it begins
  std::optional<double> keyHeight;     ///< m above the touchdown point's elevation, at least so much at the gate

  /** Clearance asked for with so many metres of path to go [m]. */
  [[nodiscard]] double clearanceAt(double toGo, double whole) const;
};

/** A glide cut at its gate. */
struct SplitGlide {
  std::vector<flight::Piece> before;
  flight::Piece last;  ///< of length 0 where a glide has no last part
  LastPart part;
};

/** @return nothing if the glide does not end in what the approach asks for: a straight of its length, or one full circle
 *  @pre all pieces are integrable (ground_path.h), the settings are sound */
std::optional<SplitGlide> splitAtGate(const std::vector<flight::Piece>& pieces, const mission::ApproachSettings& approach);

/** Where the approach of a touchdown pose begins. */
geo::Pose gateOf(const geo::Pose& touchdown, const mission::ApproachSettings& approach);

}  // namespace vp::safety
