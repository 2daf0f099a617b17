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
 * each cell holding the greatest loss on any of its courses. Cells are worked out for the courses that are asked for.
 *  @cost 0.3 to 3 us for a cell that is new, more where the winds of several layers count */
class CourseTable {
public:
  static constexpr int kCells = 2880;

  CourseTable(const std::vector<WindGlide>& glides, const WindSet& winds, double radius);

  /** False where on some course of the circle no glide exists. */
  [[nodiscard]] bool isFinite() const { return isFinite_; }
  /** Works out the cells of these courses that are not known yet.  @pre glides and winds are those that the table was made for */
  void learn(const std::vector<WindGlide>& glides, const WindSet& winds, AngleRange courses);

  /** Integral of the loss per metre over the course [m/m rad] from a course to another, of any size: the same whatever else is known.
   *  @pre the courses between are known */
  [[nodiscard]] double between(double from, double to) const;
  /** Loss per metre on a course of any size; at an edge of two cells that of the one above.  @pre it is known */
  [[nodiscard]] double rateAt(double course) const;
  /** The course up to which the integral from another has this value, of any sign. @pre the losses are finite and known there */
  [[nodiscard]] double courseAt(double from, double integral) const;

private:
  static constexpr int kBlock = 16;  // cells that are learned together

  /// A course as a cell, counted on over all laps, and the part of it.
  struct Place {
    double cell = 0.0;
    double part = 0.0;
  };
  [[nodiscard]] static Place placeOf(double course);
  [[nodiscard]] static std::size_t indexOf(double cell);
  [[nodiscard]] double sumTo(double cell) const;
  void learnBlock(const std::vector<WindGlide>& glides, const WindSet& winds, int block);

  double radius_ = 0.0;
  bool isFinite_ = true;
  std::vector<bool> isKnown_;  // by block
  int unknown_ = 0;            // blocks
  std::vector<double> rates_;  // by cell, in whole quanta; 0 where it is not known
  std::vector<double> sums_;   // of them, at the edges of the cells: exact
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
  /** Height lost from the start of the piece to a distance on it [m]. */
  [[nodiscard]] double upTo(double distance) const {
    return table_ == nullptr ? rate_ * distance : radius_ * side_ * table_->between(course_, course_ + side_ * distance / radius_);
  }
  /** Loss per metre at a distance that is no break [-]. */
  [[nodiscard]] double rateAt(double distance) const { return table_ == nullptr ? rate_ : table_->rateAt(course_ + side_ * distance / radius_); }
  /** The distance [m] up to which so much is lost. @pre something is lost on every metre, isFinite() */
  [[nodiscard]] double distanceOf(double lost) const {
    return table_ == nullptr ? lost / rate_ : side_ * radius_ * (table_->courseAt(course_, side_ * lost / radius_) - course_);
  }
  /** First distance beyond this one at which the rate may change; infinity if there is none. */
  [[nodiscard]] double nextBreak(double distance) const;

private:
  double rate_ = 0.0;
  const CourseTable* table_ = nullptr;
  double course_ = 0.0;
  double side_ = 1.0;
  double radius_ = 0.0;
};

}  // namespace vp::safety
