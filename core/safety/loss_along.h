#pragma once

#include "core/flight/curve.h"
#include "core/safety/wind_glide.h"
#include "core/safety/wind_set.h"

#include <limits>
#include <vector>

namespace vp::safety {

/** Courses flown on a piece begun on a course [rad], from the smaller to the larger. */
AngleRange coursesOf(double course, const flight::Piece& piece);

/** Greatest losses on circles of one radius, whichever of the glides is flown, by course: a step function over cells of 0.125 degrees from East on,
 * each cell holding the greatest loss on any of its courses. */
class CourseTable {
public:
  static constexpr int kCells = 2880;

  CourseTable(const std::vector<WindGlide>& glides, const WindSet& winds, double radius);

  /** Integral of the loss per metre over the course [m/m rad] from 0 to a course of any size. */
  [[nodiscard]] double upTo(double course) const;
  /** Loss per metre on a course of any size; at an edge of two cells that of the one above. */
  [[nodiscard]] double rateAt(double course) const;
  /** The course that the integral has this value at. @pre the losses are finite */
  [[nodiscard]] double courseAt(double integral) const;

private:
  std::vector<double> sums_;  // at the edges of the cells
};

/** First distance beyond this one on a turn at which the course enters another cell of such tables [m]. @param side  +1 left, -1 right */
double nextCourseBreak(double course, double side, double radius, double distance);

/** Upper bound of the height lost along one piece, piecewise linear in distance. The difference between two distances bounds what is
 *  lost between them. Valid as long as the GlideRates that it came from. */
class LossAlong {
public:
  /** The same everywhere on the piece: still air, or a straight. */
  explicit LossAlong(double rate) : rate_(rate) {}
  /** @param side  +1 left, -1 right */
  LossAlong(const CourseTable& table, double course, double side, double radius);

  /** False where no glide exists on such a piece. */
  [[nodiscard]] bool isFinite() const { return rate_ < std::numeric_limits<double>::infinity(); }
  /** Height lost from the start of the piece to a distance [m]. */
  [[nodiscard]] double upTo(double distance) const {
    return table_ == nullptr ? rate_ * distance : radius_ * side_ * (table_->upTo(course_ + side_ * distance / radius_) - before_);
  }
  /** Loss per metre at a distance that is no break [-]. */
  [[nodiscard]] double rateAt(double distance) const { return table_ == nullptr ? rate_ : table_->rateAt(course_ + side_ * distance / radius_); }
  /** The distance [m] up to which so much is lost. @pre something is lost on every metre, isFinite() */
  [[nodiscard]] double distanceOf(double lost) const {
    return table_ == nullptr ? lost / rate_ : side_ * radius_ * (table_->courseAt(before_ + side_ * lost / radius_) - course_);
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

}  // namespace vp::safety
