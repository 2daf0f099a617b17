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

/// The profile at its own mass: where masses range, so do the airspeeds of the conditions.
aircraft::GlideModel ofOneMass(aircraft::AircraftProfile profile) {
  profile.leastMass_kg.reset();
  profile.mostMass_kg.reset();
  return aircraft::GlideModel(profile);
}

}  // namespace

CourseTable::CourseTable(const std::vector<WindGlide>& glides, const WindSet& winds, double radius) : sums_(kCells + 1, 0.0) {
  for (int i = 0; i < kCells; ++i) {
    const auto cell = static_cast<std::size_t>(i);
    double most = 0.0;
    for (const WindGlide& glide : glides) {
      most = std::max(most, glide.mostInTurn(winds, radius, {i * kCell - kEdge, (i + 1) * kCell + kEdge}));
    }
    sums_[cell + 1] = sums_[cell] + kCell * most;
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
  conditions_.glide = {model.airspeed(), model.airspeed()};
  conditions_.tour = conditions_.glide;
  leastGlideRadius_ = model.glideRadii().back();
  leastTourRadius_ = model.tourRadius();
}

GlideRates::GlideRates(const aircraft::AircraftProfile& profile, const std::vector<air::WindLayer>& winds)
    : GlideRates(conditionsOf(profile, winds), profile) {}

GlideRates::GlideRates(const PlanConditions& conditions, const aircraft::AircraftProfile& profile)
    : model_(ofOneMass(profile)), isAsInProfile_(conditions.isAsInProfile(profile)), conditions_(conditions), winds_(conditions.winds) {
  const auto [least, most] = conditions.glide;
  glides_ = {WindGlide(profile, conditions, least)};
  if (most > least) {
    glides_.emplace_back(profile, conditions, most);
  }
  // ((airspeed + strongest wind) / airspeed)^2, of the airspeed of the model's radii
  const auto widening = [&](double airspeed) {
    const double faster = (airspeed + winds_.strongest()) / model_.airspeed();
    return faster * faster;
  };
  leastGlideRadius_ = widening(most) * model_.glideRadii().back();
  leastTourRadius_ = widening(conditions.tour.most) * model_.tourRadius();
}

LossAlong GlideRates::along(double course, const flight::Piece& piece) {
  if (isCalm()) {
    return LossAlong(stillLoss(piece));
  }
  if (piece.turn == flight::Turn::Straight) {
    double most = 0.0;
    for (const WindGlide& glide : glides_) {
      most = std::max(most, glide.mostStraight(winds_, course));
    }
    return LossAlong(most);
  }
  auto known = tables_.find(piece.radius);
  if (known == tables_.end()) {
    known = tables_.emplace(piece.radius, CourseTable(glides_, winds_, piece.radius)).first;
  }
  if (!(known->second.upTo(2.0 * Angle::kPi) < kInfinity)) {
    return LossAlong(kInfinity);
  }
  return {known->second, wrapTwoPi(course), piece.turn == flight::Turn::Left ? 1.0 : -1.0, piece.radius};
}

/// In still air the fastest banks the most, and straight on all lose alike.
double GlideRates::stillLoss(const flight::Piece& piece) const {
  const bool isStraight = piece.turn == flight::Turn::Straight;
  if (isAsInProfile_) {
    return model_.lossAt(isStraight ? 0.0 : piece.radius);
  }
  const WindGlide& fastest = glides_.back();
  return isStraight ? fastest.lossAt(fastest.straightSine(), 0.0, 0.0) : fastest.lossInTurn(0.0, 0.0, piece.radius);
}

double GlideRates::leastAlong(double course, const flight::Piece& piece) const {
  if (isCalm() && isAsInProfile_) {
    return stillLoss(piece);
  }
  double least = kInfinity;
  for (const WindGlide& glide : glides_) {
    least = std::min(least, glide.leastLoss(winds_, coursesOf(course, piece)));
  }
  return least;
}

double GlideRates::shareOf(const Airspeeds& speeds, double course, const flight::Piece& piece) const {
  if (isCalm()) {
    return 1.0;
  }
  const double along = winds_.mostAlong(coursesOf(course, piece));
  return std::min(speeds.least / (speeds.least + along), speeds.most / (speeds.most + along));
}

double GlideRates::mostStraight() const {
  return isCalm() ? stillLoss({}) : glide().lossAt(glide().straightSine(), -winds_.strongest(), 0.0);
}

}  // namespace vp::safety
