#pragma once

#include "core/flight/dubins.h"

#include <cmath>

namespace vp::flight {

/** A direction in the local frame as a unit vector: cosine and sine of a heading. */
struct Direction {
  double east = 1.0;
  double north = 0.0;

  Direction() = default;
  Direction(double e, double n) : east(e), north(n) {}
  explicit Direction(double heading) : east(std::cos(heading)), north(std::sin(heading)) {}
};

/** Two poses between which Dubins paths are wanted, for several radii and with bounds that cost no trigonometry.
 *
 *  The words are built from their turning circles: the straight part of CSC lies on a tangent of the two circles. Its length
 *  is a square root away; the angles need an arc tangent each, and only words that can still win get it, because the turns
 *  of a word differ (equal sides) or add up (opposite sides) to the change of heading, which bounds them from below.
 *  @threads pure   @accuracy as dubinsWord; tst_pose_pair compares them */
class PosePair {
public:
  PosePair(const geo::Pose& from, const geo::Pose& to) : PosePair(from, Direction(from.heading), to, Direction(to.heading)) {}

  /** Where the directions of the headings are known already. */
  PosePair(const geo::Pose& from, Direction fromDirection, const geo::Pose& to, Direction toDirection);

  /** The word of least height loss, as leastLossDubins(from, to, radius, loss). @pre radius > 0, loss.turn >= loss.straight >= 0 */
  [[nodiscard]] DubinsPath leastLoss(double radius, TurnLoss loss) const;

  /** Lower bound of the height lost by any way at all: straight over the distance, and more for the turns that the headings ask for. */
  [[nodiscard]] double leastLossBound(double radius, TurnLoss loss) const {
    const double excess = loss.byCourse == nullptr ? loss.turn - loss.straight : loss.byCourse->leastExcess();
    return loss.straightOver(dx_, dy_, distance_) + excess * radius * leastTurn();
  }

  /** Lower bound of the height lost by any word with this radius; far away it misses only turns that the straight part's direction asks for. */
  [[nodiscard]] double lossBound(double radius, TurnLoss loss) const;

  [[nodiscard]] double distance() const { return distance_; }
  /** Radians that every word turns by at least, in [0, pi]. */
  [[nodiscard]] double leastTurn() const { return std::abs(turn_); }

private:
  struct Csc {
    Word word = Word::LSL;
    double startSide = 1.0;  ///< +1 left, -1 right
    double endSide = 1.0;
    double east = 0.0;  ///< from the centre of the first circle to that of the second
    double north = 0.0;
    double straight = 0.0;  ///< length of the straight part; below zero: no such word
    double turnedAtLeast = 0.0;

    /// Along the straight part, times some length.
    [[nodiscard]] Direction along(double radius) const {
      // the inner tangent crosses the line of centres at an angle of atan(2 r / straight)
      const double across = startSide == endSide ? 0.0 : 2.0 * radius * startSide;
      return startSide == endSide ? Direction(east, north) : Direction(east * straight - north * across, north * straight + east * across);
    }
  };
  [[nodiscard]] static double boundOf(const Csc& csc, double radius, TurnLoss loss);
  [[nodiscard]] Csc csc(Word word, double startSide, double endSide, double radius) const;
  [[nodiscard]] DubinsPath solve(const Csc& csc, double radius) const;

  geo::Pose from_;
  geo::Pose to_;
  Direction fromDirection_;
  Direction toDirection_;
  double dx_ = 0.0;
  double dy_ = 0.0;
  double distance_ = 0.0;
  double turn_ = 0.0;       ///< change of heading in [-pi, pi]
  double turnLeft_ = 0.0;   ///< the same in [0, 2 pi), turning left
  double turnRight_ = 0.0;  ///< the same in [0, 2 pi), turning right
};

}  // namespace vp::flight
