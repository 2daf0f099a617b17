#pragma once

#include "core/aircraft/aircraft_profile.h"

#include <vector>

namespace vp::aircraft {

/** Height lost by a glide at constant airspeed and bank: the point-mass model of the source papers.
 *
 *  radius r = v^2 / (g tan bank); n = 1/cos bank; q = rho v^2 / 2; C_L = n W / (q S);
 *  sin(gamma) = q S (C_D0 + L C_L^2) / W; height lost per metre of ground path = tan(gamma).
 *  All numbers in SI. Radius 0 stands for straight flight in `loss...` functions: no turn has it.
 *  @threads pure
 *  @source Vana et al. 2018, Any-time trajectory planning for safe emergency landing (ref. 36 of Vana, Faigl, Slama
 *  2020); aerodynamics as in DESIGN section 2. What the model leaves out: rolling into the turn takes no time. */
class GlideModel {
public:
  GlideModel() = default;

  /** @pre mass, wing area, density and speed of the profile are positive, banks in (0, 90) degrees */
  explicit GlideModel(const AircraftProfile& profile);

  [[nodiscard]] double airspeed() const { return airspeed_; }
  /** Turn radius at a bank angle [m]. */
  [[nodiscard]] double radiusOf(Angle bank) const;
  /** Bank angle of a turn of this radius [m]. */
  [[nodiscard]] Angle bankOf(double radius) const;
  /** Height lost per metre of ground path in straight flight [-], tan(gamma). */
  [[nodiscard]] double straightLoss() const { return straightLoss_; }
  /** Height lost per metre of ground path in a turn of this radius [m] [-]; straight flight for radius 0.
   *  Infinite where the drag exceeds the weight: no glide exists. */
  [[nodiscard]] double lossAt(double radius) const;
  /** Radii that a glide may use, one per glide bank of the profile, descending. */
  [[nodiscard]] const std::vector<double>& glideRadii() const { return glideRadii_; }
  /** Smallest loss per metre of any flight state [-]: the straight glide. Admissible for every bound. */
  [[nodiscard]] double leastLoss() const { return straightLoss_; }
  [[nodiscard]] double tourRadius() const { return tourRadius_; }
  /** Smallest radius that the profile allows anywhere [m]. */
  [[nodiscard]] double minRadius() const { return minRadius_; }

private:
  double airspeed_ = 0.0;
  double weight_ = 0.0;               // N
  double dynamicPressureArea_ = 0.0;  // q S [N]
  double zeroLiftDrag_ = 0.0;
  double inducedDrag_ = 0.0;
  double straightLoss_ = 0.0;
  double tourRadius_ = 0.0;
  double minRadius_ = 0.0;
  std::vector<double> glideRadii_;
};

}  // namespace vp::aircraft
