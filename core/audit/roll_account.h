#pragma once

#include "core/audit/glide_motion.h"
#include "core/audit/ground_track.h"

#include <optional>

namespace vp::audit {

/** What rolling into bends and out of them may cost beside what the motion counts, in which the bank changes at once.
 *
 *  A change of bank takes its angle over the rate of roll. As in DESIGN section 2 the aircraft may be late by so much that it flies that time
 *  longer, at the sink of the steeper of the two banks: that is charged, with the banks, the airspeed and the wind of this very sample. A turn of no
 * more than a right angle between others may end before its bank is reached: then the bank that is reached in it, rolling in and out again, is found
 * by adding up the turn in steps, and charged one and a half times in and once out.
 *  @source FAA-H-8083-3C, chapter 3 (what a roll is); the rest is Newton's second law */
class RollAccount {
public:
  /** @param rate  of roll [rad/s] */
  RollAccount(const GlideMotion& motion, double rate) : motion_(motion), rate_(rate) {}

  /** Begins a glide: what was flown before it. @param bank  of the tour [rad], positive to the left */
  void begin(double bank) {
    before_ = {bank, {}};
    lost_ = 0.0;
  }
  /** Rolls from what was flown into a bend.
   *  @param isAlone  whether neither the bend before nor the one after it is to its side
   *  @param bank  of its first metre [rad]   @param speed  over ground there [m/s] */
  void rollInto(const Bend& bend, bool isAlone, double bank, double speed, double height);
  /** The bank at the end of the bend that is flown [rad]. */
  void leaveWith(double bank) { before_.bank = bank; }
  /** Rolls level at the end. */
  void rollLevel(double height) { rollInto(Bend(), false, 0.0, 1.0, height); }

  [[nodiscard]] double lost() const { return lost_; }

private:
  struct Flown {
    double bank = 0.0;
    std::optional<double> brief;  ///< the bank that was reached in it, if it was too short for its own
  };
  [[nodiscard]] double costOf(double angle, double steepest, double height) const;
  [[nodiscard]] double reachedWithin(double turned, double height) const;

  const GlideMotion& motion_;
  double rate_ = 0.0;
  Flown before_;
  double lost_ = 0.0;
};

}  // namespace vp::audit
