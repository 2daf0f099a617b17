#pragma once

#include "core/aircraft/glide_model.h"
#include "core/safety/loss_along.h"

#include <map>
#include <vector>

namespace vp::safety {

/** What glides lose in every wind of one set at every airspeed of one range: those of a band of altitudes, or of all together. In still air, at
 *  the profile's own airspeed and with its polar as it is, exactly the figures of the GlideModel.
 *  @cost of courses that are new for a radius, in wind: 0.3 to 3 us for each eighth of a degree   @threads one per thread */
class BandRates {
public:
  BandRates() = default;
  /** Still air. @pre model.isCalm() */
  explicit BandRates(const aircraft::GlideModel& model) : model_(model) {}
  /** @param model   in still air, as in the profile
   *  @param glides  at the ends of the range of airspeeds, ascending; none: the model's figures are those of the range, in still air */
  BandRates(const aircraft::GlideModel& model, bool isAsInProfile, std::vector<WindGlide> glides, WindSet winds);

  [[nodiscard]] bool isCalm() const { return winds_.isCalm(); }
  [[nodiscard]] const WindSet& winds() const { return winds_; }
  /** At the slowest airspeed. */
  [[nodiscard]] const WindGlide& slowest() const { return glides_.front(); }
  /** Upper bound of the loss along a piece begun on a course [rad]. Valid as long as this. */
  [[nodiscard]] LossAlong along(double course, const flight::Piece& piece);
  /** Lower bound of the loss per metre along it [-]. */
  [[nodiscard]] double leastAlong(double course, const flight::Piece& piece) const;
  /** Loss per metre in still air [-]. */
  [[nodiscard]] double stillLoss(const flight::Piece& piece) const;

private:
  aircraft::GlideModel model_;
  bool isAsInProfile_ = true;
  std::vector<WindGlide> glides_{WindGlide()};
  WindSet winds_;
  std::map<double, CourseTable> tables_;  // by radius
};

}  // namespace vp::safety
