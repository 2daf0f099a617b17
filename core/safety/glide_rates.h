#pragma once

#include "core/aircraft/glide_model.h"
#include "core/flight/curve.h"
#include "core/safety/plan_conditions.h"
#include "core/safety/wind_glide.h"
#include "core/safety/wind_set.h"

#include <algorithm>
#include <map>
#include <vector>

namespace vp::safety {

/** Greatest losses on circles of one radius, whichever of the glides is flown, by course: a step function over cells of 0.125 degrees from East on,
 * each cell holding the greatest loss on any of its courses. */
class CourseTable {
public:
  static constexpr int kCells = 2880;

  CourseTable(const std::vector<WindGlide>& glides, const WindSet& winds, double radius);

  /** Integral of the loss per metre over the course [m/m rad] from 0 to a course of any size. */
  [[nodiscard]] double upTo(double course) const;

private:
  std::vector<double> sums_;  // at the edges of the cells
};

/** Upper bound of the height lost along one piece, piecewise linear in distance. The difference between two distances bounds what is
 *  lost between them. Valid as long as the GlideRates that it came from. */
class LossAlong {
public:
  /** The same everywhere on the piece: still air, or a straight. */
  explicit LossAlong(double rate) : rate_(rate) {}
  /** @param side  +1 left, -1 right */
  LossAlong(const CourseTable& table, double course, double side, double radius);

  /** Height lost from the start of the piece to a distance [m]. */
  [[nodiscard]] double upTo(double distance) const {
    return table_ == nullptr ? rate_ * distance : radius_ * side_ * (table_->upTo(course_ + side_ * distance / radius_) - before_);
  }
  /** First distance beyond this one at which the rate may change; infinity if there is none. */
  [[nodiscard]] double nextBreak(double distance) const;

private:
  double rate_ = 0.0;
  const CourseTable* table_ = nullptr;
  double course_ = 0.0;
  double side_ = 1.0;
  double radius_ = 0.0;
  double before_ = 0.0;  // the table's integral at the start
};

/** What glides of an aircraft lose in every wind of a set at every airspeed of a range, by the checker's own bounds, and how tightly the
 *  aircraft may turn there. In still air, at one airspeed and with the polar as it is, exactly the figures of the GlideModel. Fills its tables when
 * they are first asked for: one per thread.
 *  @cost of a radius that is new, in wind: some 10 ms */
class GlideRates {
public:
  GlideRates() = default;

  /** Still air. @pre model.isCalm() */
  explicit GlideRates(const aircraft::GlideModel& model);

  /** @pre the profile is one that GlideModel accepts; the winds are sound and the aircraft gets on against them (README.md, wind.data) */
  GlideRates(const aircraft::AircraftProfile& profile, const std::vector<air::WindLayer>& winds);
  /** @pre the same */
  GlideRates(const PlanConditions& conditions, const aircraft::AircraftProfile& profile);

  [[nodiscard]] bool isCalm() const { return winds_.isCalm(); }
  [[nodiscard]] const WindSet& winds() const { return winds_; }
  /** At the slowest airspeed. */
  [[nodiscard]] const WindGlide& glide() const { return glides_.front(); }
  [[nodiscard]] const PlanConditions& conditions() const { return conditions_; }
  /** Nothing goes faster over ground, tour or glide [m/s]. */
  [[nodiscard]] double fastestOverGround() const { return std::max(conditions_.glide.most, conditions_.tour.most) + winds_.strongest(); }
  /** Upper bound of the loss along a piece begun on a course [rad]. */
  [[nodiscard]] LossAlong along(double course, const flight::Piece& piece);
  /** Lower bound of the loss per metre along it [-]: how high a glide may still be. */
  [[nodiscard]] double leastAlong(double course, const flight::Piece& piece) const;
  /** Airspeed / greatest ground speed on the courses of the piece [-]: what a slope over ground may be of the same slope in the air,
   *  on the tour and in a glide. */
  [[nodiscard]] double slopeShare(double course, const flight::Piece& piece) const { return shareOf(conditions_.tour, course, piece); }
  [[nodiscard]] double glideSlopeShare(double course, const flight::Piece& piece) const { return shareOf(conditions_.glide, course, piece); }
  /** Height lost per metre straight on in still air [-]. */
  [[nodiscard]] double stillStraight() const { return stillLoss({}); }
  /** The largest loss per metre straight on, over all courses [-]. */
  [[nodiscard]] double mostStraight() const;
  /** Least radius over ground of a glide and of the tour within their bank angles, in the strongest wind from behind [m]. */
  [[nodiscard]] double leastGlideRadius() const { return leastGlideRadius_; }
  [[nodiscard]] double leastTourRadius() const { return leastTourRadius_; }

private:
  [[nodiscard]] double stillLoss(const flight::Piece& piece) const;
  [[nodiscard]] double shareOf(const Airspeeds& speeds, double course, const flight::Piece& piece) const;

  aircraft::GlideModel model_;  // in still air, as in the profile
  bool isAsInProfile_ = true;
  PlanConditions conditions_;
  std::vector<WindGlide> glides_{WindGlide()};  // at the least airspeed, and at the greatest where that is another
  WindSet winds_;
  double leastGlideRadius_ = 0.0;
  double leastTourRadius_ = 0.0;
  std::map<double, CourseTable> tables_;
};

}  // namespace vp::safety
