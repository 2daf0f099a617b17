#pragma once

#include <span>
#include <vector>

namespace vp::tour {

/** Steepness that the altitude along the ground may have, as tangents, both > 0. */
struct PitchLimits {
  double climb = 0.0;    ///< tan(psi_max)
  double descent = 0.0;  ///< tan(-psi_min)
};

/** Raises altitudes until no step is steeper than the limits: one pass forward for the descent, one backward for the
 *  climb ([1] (13), lines 2 and 3; the paper's tan(psi_min) is negative). altitude[i] belongs to distance[i], which
 *  ascends. The result is the lowest profile above the given one that keeps the limits. @cost O(m) */
void raiseForPitch(std::span<const double> distance, std::span<double> altitude, PitchLimits limits);

/** The same around a closed loop: step[i] is the distance from point i to point i + 1, the last to the first. */
void raiseForPitchAround(std::span<const double> step, std::span<double> altitude, PitchLimits limits);

/** Raises only the two ends, as far as the pitch limits ask for given all points. Followed by the least concave majorant it
 *  gives the same as raiseForPitch followed by it: between raised ends the majorant is nowhere steeper than the limits, so it
 *  lies above the lowest profile that keeps them. @cost O(m) */
void raiseEndsForPitch(std::span<const double> distance, std::span<double> altitude, PitchLimits limits);

/** The points that the least concave majorant goes through, first and last included. @cost O(m) */
void concaveHull(std::span<const double> distance, std::span<const double> altitude, std::vector<std::size_t>& hull);

/** Replaces altitudes by their least concave majorant, the upper convex hull of the points ([1] (14); the paper iterates
 *  to it, the hull gives it at once). Ends stay. Slopes lie between those of the given profile, so pitch limits keep.
 *  @cost O(m) */
void concaveMajorant(std::span<const double> distance, std::span<double> altitude, std::vector<std::size_t>& hull);

/** Length of the polyline through (distance, altitude) [m]. */
double lengthInSpace(std::span<const double> distance, std::span<const double> altitude);

}  // namespace vp::tour
