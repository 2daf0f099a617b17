#pragma once

#include "core/aircraft/glide_model.h"
#include "core/flight/curve.h"
#include "core/safety/band_rates.h"
#include "core/safety/height_bands.h"
#include "core/safety/loss_along.h"
#include "core/safety/plan_conditions.h"
#include "core/safety/wind_glide.h"
#include "core/safety/wind_set.h"
#include "core/safety/wind_shear.h"

#include <algorithm>
#include <vector>

namespace vp::safety {

/** What glides of an aircraft lose in every wind and at every airspeed that may be met, by the checker's own bounds, and how tightly the aircraft may
 *  turn there. Winds and airspeeds depend on the altitude: rates are those of one of the bands that altitudes are cut into, or of all altitudes
 *  together. In still air, at one airspeed and with the polar as it is, exactly the figures of the GlideModel. Fills its tables when they are first
 *  asked for: one per thread.   @cost of courses that are new for a radius, in wind: that of BandRates for each band that is met */
class GlideRates {
public:
  GlideRates() = default;

  /** Still air. @pre model.isCalm() */
  explicit GlideRates(const aircraft::GlideModel& model);

  /** @pre the profile is one that GlideModel accepts; the winds are sound and the aircraft gets on against them (README.md, wind.data) */
  GlideRates(const aircraft::AircraftProfile& profile, const std::vector<air::WindLayer>& winds);
  /** @pre the same */
  GlideRates(const PlanConditions& conditions, const aircraft::AircraftProfile& profile);

  [[nodiscard]] bool isCalm() const { return all_.isCalm(); }
  /** Of all altitudes together. */
  [[nodiscard]] const WindSet& winds() const { return all_.winds(); }
  /** At the slowest airspeed. */
  [[nodiscard]] const WindGlide& glide() const { return all_.slowest(); }
  [[nodiscard]] const PlanConditions& conditions() const { return conditions_; }
  /** Nothing goes faster over ground, tour or glide [m/s]. */
  [[nodiscard]] double fastestOverGround() const { return std::max(conditions_.glide.most, conditions_.tour.most) + winds().strongest(); }

  /** Altitudes between neighbouring bands, ascending [m MSL]; none: one band. */
  [[nodiscard]] const std::vector<double>& edges() const { return edges_; }
  [[nodiscard]] std::size_t bandCount() const { return edges_.size() + 1; }
  [[nodiscard]] bool isLayered() const { return !edges_.empty(); }
  /** Upper bound of the loss along a piece begun on a course [rad], within a band. Valid as long as this. */
  [[nodiscard]] LossAlong alongIn(std::size_t band, double course, const flight::Piece& piece) {
    return (isLayered() ? bands_[band] : all_).along(course, piece);
  }
  /** The same at any altitude. */
  [[nodiscard]] LossAlong along(double course, const flight::Piece& piece) { return all_.along(course, piece); }
  /** The largest loss per metre straight on along a course, at altitudes from `bottom` to `top` [-]. */
  [[nodiscard]] double mostStraightBetween(double course, double bottom, double top);
  /** Lower bound of the loss per metre along a piece, at any altitude [-]: how high a glide may still be. */
  [[nodiscard]] double leastAlong(double course, const flight::Piece& piece) const { return all_.leastAlong(course, piece); }
  /** Airspeed / greatest ground speed on the courses of the piece [-]: what a slope over ground may be of the same slope in the air,
   *  on the tour and in a glide, at any altitude. */
  [[nodiscard]] double slopeShare(double course, const flight::Piece& piece) const { return shareOf(conditions_.tour, course, piece); }
  [[nodiscard]] double glideSlopeShare(double course, const flight::Piece& piece) const { return shareOf(conditions_.glide, course, piece); }
  /** Slope over ground of the steepest descent / its slope in the air [-]: as glideSlopeShare, less what a wind that changes with height may take of
   *  the rate of sink. */
  [[nodiscard]] double descentShare(double course, const flight::Piece& piece) const;
  /** The worst that the change of the wind with height does at any altitude. */
  [[nodiscard]] const ShearCost& shear() const { return shear_; }
  /** Height lost per metre straight on in still air [-]. */
  [[nodiscard]] double stillStraight() const { return stillStraight_; }
  /** The largest loss per metre straight on, over all courses and altitudes [-]. */
  [[nodiscard]] double mostStraight() const;
  /** Least radius over ground of a glide and of the tour within their bank angles, in the strongest wind from behind, at any altitude [m]. */
  [[nodiscard]] double leastGlideRadius() const { return leastGlideRadius_; }
  [[nodiscard]] double leastTourRadius() const { return leastTourRadius_; }

private:
  [[nodiscard]] double shareOf(const Airspeeds& speeds, double course, const flight::Piece& piece) const;

  PlanConditions conditions_;
  BandRates all_;  // at any altitude
  std::vector<double> edges_;
  std::vector<BandRates> bands_;  // one more than edges, from the lowest; none if there are no edges
  ShearCost shear_;
  double stillStraight_ = 0.0;
  double leastGlideRadius_ = 0.0;
  double leastTourRadius_ = 0.0;
};

}  // namespace vp::safety
