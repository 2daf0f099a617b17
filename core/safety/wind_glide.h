#pragma once

#include "core/aircraft/aircraft_profile.h"
#include "core/safety/plan_conditions.h"
#include "core/safety/wind_set.h"

namespace vp::safety {

struct Chord;
struct ChordPart;
struct ShearCost;

/** Height lost per metre over ground when the aircraft keeps a line or a circle over ground at constant true airspeed, crabbing
 *  into a steady wind. Derivation, and why each bound is one: WHY.md section 8. Wind at a place: `along` the course and `across`
 *  it [m/s], along^2 + across^2 < airspeed^2. Radius over ground [m].   @threads const */
class WindGlide {
public:
  WindGlide() = default;

  /** @pre mass, wing area, density and speed of the profile are positive */
  explicit WindGlide(const aircraft::AircraftProfile& profile);
  /** At one of the airspeeds of the conditions, with their drag.  @pre the same, airspeed > 0 */
  WindGlide(const aircraft::AircraftProfile& profile, const PlanConditions& conditions, double airspeed);
  /** The same where the wind changes with height. */
  WindGlide(const aircraft::AircraftProfile& profile, const PlanConditions& conditions, double airspeed, const ShearCost& shear);

  /** tan(bank) that keeps a circle of radius 1 m; that of another radius is this / radius. */
  [[nodiscard]] double bankTangent(double along, double across) const;
  /** sin(gamma) on a circle [-]. */
  [[nodiscard]] double sinkSine(double along, double across, double radius) const;
  /** Loss per metre at a given sin(gamma) [-]; infinite where the aircraft does not get on. */
  [[nodiscard]] double lossAt(double sine, double along, double across) const;
  /** Loss per metre of ground on a circle [-]. */
  [[nodiscard]] double lossInTurn(double along, double across, double radius) const { return lossAt(sinkSine(along, across, radius), along, across); }

  /** True if on every course a circle of this radius can be glided on in every wind up to this one [m/s]. */
  [[nodiscard]] bool getsOn(double strongest, double radius) const;

  /** Greatest loss per metre straight on, over all winds of the set: exact but for rounding (1e-13 relative). */
  [[nodiscard]] double mostStraight(const WindSet& winds, double course) const;
  /** Greatest loss per metre on a circle, over all winds of the set and all these courses: never below it, at most 2e-6 of it
   *  above.   @cost two values for each arc of the set, and some 6 for each of its segments */
  [[nodiscard]] double mostInTurn(const WindSet& winds, double radius, AngleRange courses) const;
  /** At least so much is lost per metre on any of these courses, straight on or turning, by the best pilot with the least drag of the
   *  propeller: a lower bound, not the least. */
  [[nodiscard]] double leastLoss(const WindSet& winds, AngleRange courses) const;
  /** sin(gamma) with wings level [-]. */
  [[nodiscard]] double straightSine() const { return straightSine_; }
  /** Of sin(gamma) in turns, what grows with the square of the bank's tangent [-]. */
  [[nodiscard]] double inducedSine() const { return inducedSine_; }
  /** Horizontal airspeed of the straight glide [m/s], and with this tangent of bank; 0 where no glide exists. */
  [[nodiscard]] double horizontalSpeed(double bankTangent = 0.0) const;

private:
  [[nodiscard]] double mostOnArc(double speed, AngleRange off, double radius) const;
  [[nodiscard]] double mostOnChord(const Chord& chord, double radius, ChordPart part, double found, int depth) const;

  double airspeed_ = 0.0;
  double straightSine_ = 0.0;  // sin(gamma) with wings level
  double turnSine_ = 0.0;      // the same as a part of that in turns: more where shear costs more there
  double leastSine_ = 0.0;     // the same without the drag factor, with the least drag of the propeller
  double inducedSine_ = 0.0;   // of it, induced: grows with the load factor squared
};

}  // namespace vp::safety
