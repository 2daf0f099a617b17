#pragma once

#include "core/air/wind_at.h"
#include "core/aircraft/glide_model.h"
#include "core/flight/dubins.h"

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace vp::flight {

/** What the glides of an aircraft lose with turns of this radius over ground [m], in calm air or wind.
 *  @pre the radius is one of the glides' or the tour's; the model, or a copy of it, outlives the answer */
inline TurnLoss turnLossOf(const aircraft::GlideModel& model, double radius) {
  if (const std::shared_ptr<const aircraft::CourseLoss> byCourse = model.courseLoss(radius)) {
    return {byCourse->leastStraight(), byCourse->leastTurn(), byCourse.get()};
  }
  return {model.straightLoss(), model.lossAt(radius)};
}

/** The same by the index of a glide radius, or with their number of the tour's. */
inline TurnLoss turnLossAt(const aircraft::GlideModel& model, std::size_t radius) {
  if (const aircraft::CourseLoss* const byCourse = model.courseLossOf(radius)) {
    return {byCourse->leastStraight(), byCourse->leastTurn(), byCourse};
  }
  return {model.straightLoss(), model.stillTurnLossOf(radius)};
}

/** The same of each band alone, where losses differ by altitude; else the one that holds everywhere. */
std::vector<TurnLoss> bandLossesOf(const aircraft::GlideModel& model, std::size_t radius);

/** Height lost along a piece of glide, from its start on. */
class PieceLoss {
public:
  /** @param course  at the start of the piece, rad   @pre losses are those of the piece's radius */
  PieceLoss(const Piece& piece, double course, const TurnLoss& losses) : course_(course) {
    if (piece.turn != Turn::Straight) {
      rate_ = losses.turn;
      byCourse_ = losses.byCourse;
      turnedPerMetre_ = static_cast<double>(static_cast<int>(piece.turn)) / piece.radius;
    } else {
      rate_ = losses.byCourse == nullptr ? losses.straight : losses.byCourse->straightRate(std::cos(course), std::sin(course));
    }
  }
  /** Of a piece that loses the same on every metre. */
  explicit PieceLoss(double rate) : rate_(rate) {}

  /** Height lost from the start to this length [m]. */
  [[nodiscard]] double upTo(double length) const {
    return byCourse_ == nullptr ? rate_ * length : byCourse_->turn(course_, turnedPerMetre_ * length);
  }

  /** Greatest loss per metre up to this length. */
  [[nodiscard]] double mostPerMetre(double length) const {
    return byCourse_ == nullptr ? rate_ : byCourse_->mostInTurn(course_, turnedPerMetre_ * length);
  }

private:
  double rate_ = 0.0;
  double course_ = 0.0;
  double turnedPerMetre_ = 0.0;
  const aircraft::CourseLoss* byCourse_ = nullptr;  ///< none: `rate_` on every metre
};

/** Height lost along each piece of a glide [m], in calm air or wind. Radii may be any. */
std::vector<double> lossesOf(const aircraft::GlideModel& model, const geo::Pose& start, const std::vector<Piece>& pieces);

/** Height lost along one piece up to a length [m]. */
double lossUpTo(const aircraft::GlideModel& model, const geo::Pose& start, const Piece& piece, double length);

/** Length of a piece times the most that a metre of it loses [m]: what a tour must have left at its beginning, as between its ends
 *  the height of the tour is linear and what the glide loses is not. */
double mostLossOver(const aircraft::GlideModel& model, const geo::Pose& start, const Piece& piece);

/** Height that a tour must have at the beginning of a piece so that gliding on along it, from anywhere, ends at `end` or higher [m MSL]: mostLossOver
 *  by the losses at these altitudes. Both heights are before the engine has stopped.
 *  @param lostAtOnce  height lost when it does, m */
double mostHeightBefore(const aircraft::GlideModel& model, const geo::Pose& start, const Piece& piece, double end, double lostAtOnce);

/** Height of a glide so many metres along a piece that it begins at `altitude`, in each band with its losses [m MSL]. */
double heightAlong(const aircraft::GlideModel& model, const geo::Pose& start, const Piece& piece, double altitude, double length);

/** Time under power at the glide's airspeed along a piece, the track over ground kept [s]. @param rise  height gained on it, m */
double cruiseSeconds(double airspeed, air::Wind wind, const geo::Pose& start, const Piece& piece, double rise);

/** Time of a glide along a piece [s]: in wind, of the slowest. */
double glideSeconds(const aircraft::GlideModel& model, const geo::Pose& start, const Piece& piece);

}  // namespace vp::flight
