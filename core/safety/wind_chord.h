#pragma once

namespace vp::safety {

/** Numbers from a least to a greatest. */
struct Between {
  double least = 0.0;
  double most = 0.0;

  static Between of(double a, double b);
};

/** Winds on a line, as seen on a course: where it begins, and how it goes on to its end [m/s]. */
struct Chord {
  double along = 0.0;
  double across = 0.0;
  double alongBy = 0.0;
  double acrossBy = 0.0;
};

/** A part of it, from 0 to 1. */
struct ChordPart {
  double from = 0.0;
  double to = 1.0;
};

/** All that a turn in the winds of a part of a chord may have. */
struct ChordRanges {
  Between along;    ///< m/s, wind
  Between across;   ///< m/s, wind
  Between ahead;    ///< m/s, v cos(crab)
  Between glided;   ///< m/s, the same of the horizontal airspeed
  Between induced;  ///< part of sin(gamma) that grows with the square of the bank's tangent
};

/** True if the loss per metre of the turn only rises along such a part, or only falls: WHY.md section 8. False if that is not sure.
 *  @param square  of the airspeed   @pre ahead + along > 0, glided >= 0 */
bool isOneWay(const Chord& chord, const ChordRanges& ranges, double square);

}  // namespace vp::safety
