#pragma once

#include "core/risk/leg_risk.h"
#include "core/risk/population.h"

#include <memory>
#include <string>

namespace vp::risk {

/** The part of a descent that [3] counts people under, in heights [m MSL] and one slope. */
struct DescentWindow {
  double top = 0.0;        ///< min(h_0, h_c): nobody is at risk from higher
  double goal = 0.0;       ///< h_N, where the final approach begins
  double ground = 0.0;     ///< elevation of the site: heights of [3] (42) count from here
  double slope = 0.0;      ///< tan(gamma_opt), > 0
  double airspeed = 40.0;  ///< m/s, > 0
  bool operator==(const DescentWindow&) const = default;
};

/** Overflown population risk of [3], (41) to (46), as a sum over legs: 0 over empty ground, at most 1 for a descent from `top` to `goal` at the
 * slope.
 *
 *  (44) weighs density by w_p1 = 1 - h / min(h_0, h_c), which grows as the aircraft comes down, and by w_p2 = (1 - l / d_opt)^2, which falls to the
 *  goal. On a descent at the optimal slope 1 - l / d_opt is (h - h_N) / (h_0 - h_N), so both depend on height alone, and legs add up whatever planner
 *  made them. Normalized by the greatest product of weights, kappa_w = 4/27 (top - goal) / (top - ground) (Lemma 3; its (45) names w_p1 twice, w_p1
 *  w_p2 is meant), by the greatest density and by the time of the whole descent.
 *  Above `top` and below `goal` nothing counts. Time is that in still air, as the paper has it.  @threads const members are pure */
class DescentRisk : public LegRisk {
public:
  /** @param population  not null   @pre top > goal >= ground, slope and airspeed > 0 */
  DescentRisk(std::shared_ptr<const Population> population, const DescentWindow& window);

  [[nodiscard]] double of(const geo::Pose& from, const flight::Piece& piece, double startAltitude, double endAltitude) const override;
  [[nodiscard]] std::string name() const override { return "overflown population risk"; }
  [[nodiscard]] std::string unit() const override { return ""; }

  [[nodiscard]] const DescentWindow& window() const { return window_; }
  [[nodiscard]] const std::shared_ptr<const Population>& population() const { return population_; }
  /** Length of the whole descent [m]: risk * length / length of a leg is g_p of that leg alone, the time average of (44), in [0, 1]. */
  [[nodiscard]] double length() const { return (window_.top - window_.goal) / window_.slope; }

private:
  [[nodiscard]] double weight(double altitude) const;

  std::shared_ptr<const Population> population_;
  DescentWindow window_;
  double scale_ = 0.0;  ///< 1 / (kappa_w kappa_eta length)
};

}  // namespace vp::risk
