#pragma once

#include "core/air/wind_layer.h"
#include "core/aircraft/aircraft_profile.h"
#include "core/aircraft/course_loss.h"
#include "core/aircraft/glide_conditions.h"

#include <memory>
#include <vector>

namespace vp::aircraft {

/** Height lost by a glide at constant airspeed: the point-mass model of the source papers, in calm air and in wind.
 *
 *  In still air: radius r = v^2 / (g tan bank); n = 1/cos bank; q = rho v^2 / 2; C_L = n W / (q S);
 *  sin(gamma) = q S (C_D0 + L C_L^2) / W; height lost per metre of path = tan(gamma).
 *  In wind the aircraft keeps its track over ground, so paths stay what they are, straight lines and circles over ground; what a metre
 *  costs depends on the course (course_loss.h), and circles are so wide that no wind of the forecast asks for more than the bank:
 *  r = (v + w)^2 / (g tan bank), w the strongest.
 *  Where masses and densities range (GlideConditions), v is the greatest true airspeed, and winds count as strong as the slowest aircraft
 *  feels them: WHY.md, "Airspeeds that range". All numbers in SI. Radius 0 stands for straight flight in `lossAt`: no turn has it.
 *  @threads pure
 *  @source Vana et al. 2018, Any-time trajectory planning for safe emergency landing (ref. 36 of Vana, Faigl, Slama
 *  2020); aerodynamics as in DESIGN section 2. What the model leaves out: rolling into the turn takes no time. */
class GlideModel {
public:
  GlideModel() = default;

  /** @param conditions  that the glides must hold for
   *  @pre mass, wing area, density and speed of the profile are positive, banks in (0, 90) degrees, the drag factor is at least 1 */
  explicit GlideModel(const AircraftProfile& profile, const GlideConditions& conditions = {});

  /** Greatest true airspeed of the glide [m/s]. */
  [[nodiscard]] double airspeed() const { return airspeed_; }
  /** True airspeed that the tour is flown at [m/s], the greatest where it ranges. */
  [[nodiscard]] double tourAirspeed() const { return tourAirspeed_; }
  [[nodiscard]] bool isCalm() const { return winds_.empty(); }
  /** Slope over ground [-] that never needs more than this pitch in the air: with the wind behind, the same pitch gives a shallower one. */
  [[nodiscard]] double slopeOf(Angle pitch) const { return tan(pitch) * (isCalm() ? 1.0 : tourAirspeed_ / (tourAirspeed_ + strongestWind_)); }
  /** Strongest wind [m/s], as the slowest aircraft feels it: times greatest / least airspeed. */
  [[nodiscard]] double strongestWind() const { return strongestWind_; }
  /** Greatest speed over ground of tour and glide [m/s], an upper bound: the airspeed of either, and the strongest wind. */
  [[nodiscard]] double mostGroundSpeed() const { return (tourAirspeed_ > airspeed_ ? tourAirspeed_ : airspeed_) + strongestWind_; }
  /** Greatest part of any wind along a course of the local frame [rad], as strong as the slowest aircraft feels it [m/s]; not below zero. */
  [[nodiscard]] double mostTailwind(double course) const;
  /** Radius over ground of a gliding turn that never needs more than this bank [m]. */
  [[nodiscard]] double radiusOf(Angle bank) const;
  /** Greatest bank of a gliding turn over ground of this radius [m]. */
  [[nodiscard]] Angle bankOf(double radius) const;
  /** Height lost per metre in straight flight in still air [-], tan(gamma). */
  [[nodiscard]] double straightLoss() const { return straightLoss_; }
  /** Height lost per metre of path in a turn of this radius [m] in still air [-]; straight flight for radius 0.
   *  Infinite where the drag exceeds the weight: no glide exists. */
  [[nodiscard]] double lossAt(double radius) const;
  /** Radii that a glide may use, one per glide bank of the profile, descending. */
  [[nodiscard]] const std::vector<double>& glideRadii() const { return glideRadii_; }
  /** Smallest loss per metre of ground of any glide on any course [-]. Admissible for every bound. */
  [[nodiscard]] double leastLoss() const { return leastLoss_; }
  /** Greatest loss per metre straight on any course [-]. */
  [[nodiscard]] double mostStraightLoss() const;
  /** Greatest loss per metre in a turn of this radius on any course [-]. */
  [[nodiscard]] double mostTurnLoss(double radius) const;
  /** Height lost in half a circle of this radius [m], on the worst course. */
  [[nodiscard]] double mostInHalfTurn(double radius) const;
  /** Height lost over a straight displacement [m], in calm air or wind; no other way between its ends loses less. */
  [[nodiscard]] double lossOver(double east, double north) const;
  [[nodiscard]] double tourRadius() const { return tourRadius_; }
  /** Smallest radius that the profile allows anywhere [m]. */
  [[nodiscard]] double minRadius() const { return minRadius_; }
  /** What courses cost with turns of this radius [m]; null in calm air. Lives as long as any copy of this model, where the radius is one
   *  of the glides' or the tour's; others are made anew and live as long as what is returned. */
  [[nodiscard]] std::shared_ptr<const CourseLoss> courseLoss(double radius) const;

private:
  [[nodiscard]] std::shared_ptr<const CourseLoss> makeCourseLoss(double radius) const;

  double airspeed_ = 0.0;
  double tourAirspeed_ = 0.0;
  double dragFactor_ = 1.0;
  double strongestWind_ = 0.0;
  double weight_ = 0.0;               // N
  double dynamicPressureArea_ = 0.0;  // q S [N]
  double zeroLiftDrag_ = 0.0;
  double inducedDrag_ = 0.0;
  double straightLoss_ = 0.0;
  double leastLoss_ = 0.0;
  double tourRadius_ = 0.0;
  double minRadius_ = 0.0;
  std::vector<double> glideRadii_;
  std::vector<air::WindSector> winds_;                       ///< empty in calm air
  std::vector<std::shared_ptr<const CourseLoss>> byRadius_;  ///< of the glides' radii, then the tour's
};

}  // namespace vp::aircraft
