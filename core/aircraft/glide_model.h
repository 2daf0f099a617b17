#pragma once

#include "core/air/wind_layer.h"
#include "core/aircraft/aircraft_profile.h"
#include "core/aircraft/course_loss.h"
#include "core/aircraft/glide_conditions.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace vp::aircraft {

class GlideBands;

/** Height lost by a glide at constant airspeed: the point-mass model of the source papers, in calm air and in wind.
 *
 *  In still air: radius r = v^2 / (g tan bank); n = 1/cos bank; q = rho v^2 / 2; C_L = n W / (q S);
 *  sin(gamma) = q S (C_D0 + L C_L^2) / W; height lost per metre of path = tan(gamma).
 *  In wind the aircraft keeps its track over ground, so paths stay what they are, straight lines and circles over ground; what a metre
 *  costs depends on the course (course_loss.h), and circles are so wide that no wind of the forecast asks for more than the bank:
 *  r = (v + w)^2 / (g tan bank), w the strongest.
 *  Where masses and densities range (GlideConditions), v is the greatest true airspeed, and winds count as strong as the slowest aircraft
 *  feels them: WHY.md, "Airspeeds that range". Where losses differ by altitude this is what holds at every altitude, but for bounds, and bands()
 *  has what holds between two. All numbers in SI. Radius 0 stands for straight flight in `lossAt`: no turn has it.
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
  /** Least true airspeed of the glide [m/s]. */
  [[nodiscard]] double leastAirspeed() const { return leastAirspeed_; }
  /** True airspeed that the tour is flown at [m/s], the greatest where it ranges. */
  [[nodiscard]] double tourAirspeed() const { return tourAirspeed_; }
  [[nodiscard]] bool isCalm() const { return winds_.empty(); }
  /** Slope over ground [-] that never needs more than this pitch in the air: with the wind behind, the same pitch gives a shallower one. */
  [[nodiscard]] double slopeOf(Angle pitch) const { return tan(pitch) * (isCalm() ? 1.0 : tourAirspeed_ / (tourAirspeed_ + strongestWind_)); }
  /** Strongest wind [m/s], as the slowest aircraft feels it: times greatest / least airspeed. */
  [[nodiscard]] double strongestWind() const { return strongestWind_; }
  /** Greatest change of the wind with height between neighbouring layers [1/s]; 0 with one. */
  [[nodiscard]] double shear() const { return shear_; }
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
  /** Smallest loss per metre of ground of any glide on any course at any altitude [-]. Admissible for every bound. */
  [[nodiscard]] double leastLoss() const;
  /** Greatest loss per metre straight on any course [-]. */
  [[nodiscard]] double mostStraightLoss() const;
  /** Greatest loss per metre in a turn of this radius on any course [-]. */
  [[nodiscard]] double mostTurnLoss(double radius) const;
  /** Height lost in half a circle of this radius [m], on the worst course. */
  [[nodiscard]] double mostInHalfTurn(double radius) const;
  /** Height lost over a straight displacement [m], in calm air or wind; no other way between its ends loses less. */
  [[nodiscard]] double lossOver(double east, double north) const;
  /** The same at the altitude where that is least [m]: for bounds. */
  [[nodiscard]] double leastLossOver(double east, double north) const;
  [[nodiscard]] double tourRadius() const { return tourRadius_; }
  /** Smallest radius that the profile allows anywhere [m]. */
  [[nodiscard]] double minRadius() const { return minRadius_; }
  /** What courses cost with turns of this radius [m]; null in calm air. Lives as long as any copy of this model, where the radius is one
   *  of the glides' or the tour's; others are made anew and live as long as what is returned. */
  [[nodiscard]] std::shared_ptr<const CourseLoss> courseLoss(double radius) const;
  /** The same by the index of a glide radius, or with their number that of the tour; lives as long as any copy of this model. */
  [[nodiscard]] const CourseLoss* courseLossOf(std::size_t radius) const { return isCalm() ? nullptr : byRadius_[radius].get(); }
  /** lossAt() by that index. */
  [[nodiscard]] double stillTurnLossOf(std::size_t radius) const { return stillTurnLoss_[radius]; }

  /** What holds between two altitudes, where losses differ by altitude; null where they do not. Lives as long as any copy of this model. */
  [[nodiscard]] const GlideBands* bands() const { return bands_.get(); }
  /** Of a model that GlideBands gave: the first and the last of its bands, and up to where it holds [m MSL]. Else 0, 0 and infinity. */
  [[nodiscard]] std::size_t firstBand() const { return firstBand_; }
  [[nodiscard]] std::size_t lastBand() const { return lastBand_; }
  [[nodiscard]] double holdsUpTo() const { return holdsUpTo_; }

  /** The same losses at all altitudes. */
  [[nodiscard]] GlideModel everywhere() const;

private:
  friend class GlideBands;
  /// What is different in some bands.
  struct Cover {
    std::size_t first = 0;
    std::size_t last = 0;
    double top = std::numeric_limits<double>::infinity();
    SpeedRange speeds;
    std::vector<air::WindLayer> winds;
    std::vector<const GlideModel*> within;  ///< the bands alone, where there are several
  };
  GlideModel(const GlideModel& whole, const Cover& cover);

  void setWinds(const std::vector<air::WindLayer>& layers, const SpeedRange& speeds);
  void tabulate(const std::vector<const GlideModel*>& within);
  [[nodiscard]] std::shared_ptr<const CourseLoss> makeCourseLoss(double radius, const std::vector<const CourseLoss*>& within = {}) const;

  double airspeed_ = 0.0;
  double leastAirspeed_ = 0.0;
  double tourAirspeed_ = 0.0;
  double dragFactor_ = 1.0;
  double strongestWind_ = 0.0;
  double shear_ = 0.0;                // greatest change of the wind with height, 1/s
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
  std::vector<double> stillTurnLoss_;                        ///< of the same
  std::size_t firstBand_ = 0;
  std::size_t lastBand_ = 0;
  double holdsUpTo_ = std::numeric_limits<double>::infinity();
  std::shared_ptr<const GlideBands> bands_;
};

}  // namespace vp::aircraft
