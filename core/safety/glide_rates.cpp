#include "core/safety/glide_rates.h"

#include "core/base/expect.h"

#include <cmath>
#include <limits>

namespace vp::safety {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kCell = 2.0 * Angle::kPi / CourseTable::kCells;
constexpr double kEdge = 1e-12;  // rad that a cell reaches beyond its edges, more than rounding of a course

/// Courses flown on a piece, from the smaller to the larger.
AngleRange coursesOf(double course, const flight::Piece& piece) {
  if (piece.turn == flight::Turn::Straight) {
    return {course, course};
  }
  const double angle = piece.length / piece.radius;
  const double turned = angle < 2.0 * Angle::kPi ? angle : 2.0 * Angle::kPi;  // also if it is no number
  return piece.turn == flight::Turn::Left ? AngleRange{course, course + turned} : AngleRange{course - turned, course};
}

}  // namespace

CourseTable::CourseTable(const WindGlide& glide, const WindSet& winds, double radius) : sums_(kCells + 1, 0.0) {
  for (int i = 0; i < kCells; ++i) {
    const auto cell = static_cast<std::size_t>(i);
    sums_[cell + 1] = sums_[cell] + kCell * glide.mostInTurn(winds, radius, {i * kCell - kEdge, (i + 1) * kCell + kEdge});
  }
}

double CourseTable::upTo(double course) const {
  const double cells = course / kCell;
  const double whole = std::floor(cells);
  const double laps = std::floor(whole / kCells);
  const auto cell = static_cast<std::size_t>(whole - laps * kCells);
  return laps * sums_.back() + sums_[cell] + (cells - whole) * (sums_[cell + 1] - sums_[cell]);
}

LossAlong::LossAlong(const CourseTable& table, double course, double side, double radius)
    : table_(&table), course_(course), side_(side), radius_(radius), before_(table.upTo(course)) {}

double LossAlong::nextBreak(double distance) const {
  if (table_ == nullptr) {
    return kInfinity;
  }
  const double cells = (course_ + side_ * distance / radius_) / kCell;
  double edge = side_ > 0.0 ? std::floor(cells) + 1.0 : std::ceil(cells) - 1.0;
  double next = side_ * (edge * kCell - course_) * radius_;
  while (!(next > distance)) {  // an edge that rounding has put here
    edge += side_;
    next = side_ * (edge * kCell - course_) * radius_;
  }
  return next;
}

GlideRates::GlideRates(const aircraft::GlideModel& model) : model_(model) {
  VP_EXPECT(model.isCalm());
}

GlideRates::GlideRates(const aircraft::AircraftProfile& profile, const std::vector<air::WindLayer>& winds)
    : model_(profile), glide_(profile), winds_(winds) {
  const double faster = (model_.airspeed() + winds_.strongest()) / model_.airspeed();
  widening_ = faster * faster;
}

LossAlong GlideRates::along(double course, const flight::Piece& piece) {
  const bool isStraight = piece.turn == flight::Turn::Straight;
  if (isCalm()) {
    return LossAlong(model_.lossAt(isStraight ? 0.0 : piece.radius));
  }
  if (isStraight) {
    return LossAlong(glide_.mostStraight(winds_, course));
  }
  auto known = tables_.find(piece.radius);
  if (known == tables_.end()) {
    known = tables_.emplace(piece.radius, CourseTable(glide_, winds_, piece.radius)).first;
  }
  if (!(known->second.upTo(2.0 * Angle::kPi) < kInfinity)) {
    return LossAlong(kInfinity);
  }
  return {known->second, wrapTwoPi(course), piece.turn == flight::Turn::Left ? 1.0 : -1.0, piece.radius};
}

double GlideRates::leastAlong(double course, const flight::Piece& piece) const {
  if (isCalm()) {
    return model_.lossAt(piece.turn == flight::Turn::Straight ? 0.0 : piece.radius);
  }
  return glide_.leastLoss(winds_, coursesOf(course, piece));
}

double GlideRates::slopeShare(double course, const flight::Piece& piece) const {
  return isCalm() ? 1.0 : model_.airspeed() / (model_.airspeed() + winds_.mostAlong(coursesOf(course, piece)));
}

double GlideRates::mostStraight() const {
  return isCalm() ? model_.straightLoss() : glide_.lossAt(glide_.straightSine(), -winds_.strongest(), 0.0);
}

}  // namespace vp::safety
