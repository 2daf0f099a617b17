#pragma once

#include "core/audit/sample_air.h"
#include "core/mission/mission.h"

namespace vp::audit {

/** A unit vector along the track over ground. */
struct Along {
  double east = 1.0;
  double north = 0.0;
};

/** What one metre of a glide did. */
struct MetreFlown {
  bool isPossible = false;   ///< false: the wind is too strong for the track, or the drag exceeds the weight
  double lost = 0.0;         ///< m of height
  double took = 0.0;         ///< s
  double bankTangent = 0.0;  ///< of the bank that was needed, positive to the left
};

/** The motion of a gliding aircraft that keeps its track over ground, by its accelerations.
 *
 *  Over one metre the velocity over ground before and after it follow from the wind triangle: the airspeed is held, the track is given. Their
 *  difference over the time between is the acceleration, whatever made it: the curve, the wind that comes from another side on it, or another wind
 *  lower down. Its part across the nose is the lift's, so tan(bank) = that part / g and the load n = sqrt(1 + tan^2); the drag of the polar at
 *  that load, C_D0 q S + L (n W)^2/(q S), is what the weight has to pay: sin(gamma) = D/W, and where the wind changes with height by dW/dh
 *  the air takes or gives u . dW/dh besides (u velocity through the air).
 *  As in the source papers the lift carries the weight (not weight cos(gamma)) and turns are as wide as level ones; the kinetic energy that
 *  is set free as true airspeed falls with altitude is not counted. All three make a glide steeper than it is.
 *  Shares no formula with core/aircraft and core/safety.
 *  @source [1] section 3 and DESIGN section 2 for the polar; wind triangle: [3] section III; forces: Newton's second law */
class GlideMotion {
public:
  /** @param air, table  must outlive this */
  GlideMotion(const mission::Mission& mission, const SampleAir& air, const AirTable& table);

  /** Flies a metre (`length` of it) at a height.
   *  @param before, middle, after  along the track, at the start, the middle and the end of the metre */
  [[nodiscard]] MetreFlown fly(const Along& before, const Along& middle, const Along& after, double length, double height) const;

  /** Whether wind and air are the same at every height, so that equal metres cost the same. */
  [[nodiscard]] bool isSameAtEveryHeight() const { return air_.levels.size() < 2 && table_.isConstant(); }
  /** True airspeed of the glide there [m/s]. */
  [[nodiscard]] double airspeed(double height) const { return airspeed_ * table_.speedFactor(height); }
  /** True airspeed of the tour there [m/s]. */
  [[nodiscard]] double tourAirspeed(double height) const { return powerSpeed_ > 0.0 ? powerSpeed_ : airspeed(height); }
  /** Most that a metre can be flown in [m/s]: the faster of the two airspeeds with the wind behind. */
  [[nodiscard]] double mostGroundSpeed(double height) const;
  /** Bank that a turn takes at this airspeed in the wind there [rad], positive to the left. @param curvature  over ground, positive to the left [1/m]
   */
  [[nodiscard]] double bankOf(const Along& track, double curvature, double airspeed, double height) const;
  /** Rate of sink at a bank [m/s]. @param tangent  of it */
  [[nodiscard]] double sinkRate(double tangent, double height) const;

private:
  const SampleAir& air_;
  const AirTable& table_;
  double airspeed_ = 0.0;    ///< at the density of the polar, m/s
  double powerSpeed_ = 0.0;  ///< of the power setting, m/s; 0: none
  double parasitic_ = 0.0;   ///< of weight, with the factor of the pilot
  double induced_ = 0.0;     ///< of weight, at load 1
};

}  // namespace vp::audit
