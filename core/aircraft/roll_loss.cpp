#include "core/aircraft/roll_loss.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::aircraft {
namespace {

/// Turns further than this are charged their whole bank [rad].
constexpr double kMostOfBrief = 0.5 * Angle::kPi;
/// Part of the airspeed that is at least ahead while the slope is no steeper than 45 degrees: crab angles are those of such glides.
constexpr double kAhead = 0.7071;
/// By how much of its own time a roll into a short turn may begin late.
constexpr double kLate = 0.5;
/// Of the whole bank's cost: a turn that is hardly too short for its bank is charged that.
constexpr double kSurely = 0.98;
constexpr double kSlack = 1.0 + 2e-5;  // as WHY.md, "Slack"
constexpr double kSameRadius = 1e-9;  // of it: the glide goes on in the turn of the tour

/// Tangent of bank times radius over ground at a speed over ground [m].
double bankTimesRadius(double groundSpeed) {
  return groundSpeed * groundSpeed / kGravity.si();
}

}  // namespace

RollLoss::RollLoss(const GlideModel& glide, double rollRate_dps) : glide_(glide.everywhere()), rate_(Angle::degrees(rollRate_dps).radians()) {
  shear_ = glide.airspeed() * glide.shear() / kGravity.si();
  if (const double wind = glide.strongestWind(), airspeed = glide.airspeed() * kAhead; shear_ > 0.0) {
    crab_ = wind < airspeed ? wind / std::sqrt(airspeed * airspeed - wind * wind) : std::numeric_limits<double>::infinity();
  }
  most_ = bankTimesRadius(glide.airspeed() + glide.strongestWind());
  tour_ = bankTimesRadius(std::max(glide.airspeed(), glide.tourAirspeed()) + glide.strongestWind());
}

/// Rate of sink over airspeed in this bank, at most; in wind that changes with height as WHY.md, "Shear". @param bank  its tangent
double RollLoss::sineAt(double bank) const {
  // the slope in a bank is that of the circle which it gives in still air
  const auto steady = [this](double tangent) {
    const double slope = glide_.lossAt(tangent > 0.0 ? glide_.airspeed() * glide_.airspeed() / (kGravity.si() * tangent) : 0.0);
    return std::isfinite(slope) ? slope / std::hypot(1.0, slope) * kSlack : 1.0;
  };
  if (shear_ == 0.0) {
    return steady(bank);
  }
  if (!(shear_ < 1.0) || !std::isfinite(crab_)) {
    return 1.0;
  }
  const double load = shear_ * crab_;
  const double sheared = steady(bank + load * 2.0 * steady(bank)) / (1.0 - shear_);
  return steady(bank + load * sheared) / (1.0 - shear_) <= sheared ? std::min(1.0, sheared) : 1.0;
}

/// @param angle     by which the bank changes, rad
/// @param steepest  tangent of the steeper bank
double RollLoss::cost(double angle, double steepest) const {
  return angle > 0.0 ? angle / rate_ * glide_.airspeed() * sineAt(steepest) : 0.0;
}

/// The whole banks, in the wind that makes the most of it.
double RollLoss::change(Bend before, Bend after) const {
  if (before.side == 0 && after.side == 0) {
    return 0.0;
  }
  if (before.side == 0 || after.side == 0) {
    return whole(before.side == 0 ? after : before, most_).in;
  }
  const double steepest = most_ / std::min(before.radius, after.radius);
  if (before.side != after.side) {
    return cost(std::atan(most_ / before.radius) + std::atan(most_ / after.radius), steepest);
  }
  // atan(c / R1) - atan(c / R2) is greatest where c is the mean of the radii, whatever the wind: tan of it (R2 - R1) / (2 sqrt(R1 R2))
  return cost(std::atan(std::abs(after.radius - before.radius) / (2.0 * std::sqrt(before.radius * after.radius))), steepest);
}

double RollLoss::changeFromTour(Bend tour, Bend first) const {
  if (tour.side == 0) {
    return change(tour, first);
  }
  const double bank = std::atan(tour_ / tour.radius);
  if (first.side == 0) {
    return cost(bank, tour_ / tour.radius);
  }
  const double steepest = std::max(tour_ / tour.radius, most_ / first.radius);
  if (first.side != tour.side) {
    return cost(bank + std::atan(most_ / first.radius), steepest);
  }
  const bool isSame = std::abs(first.radius - tour.radius) <= kSameRadius * tour.radius;
  return isSame ? 0.0 : cost(std::max(bank, std::atan(most_ / first.radius)), steepest);  // either may be the steeper
}

RollLoss::Ends RollLoss::whole(Bend bend, double bankTimesRadius) const {
  if (bend.side == 0) {
    return {};
  }
  const double tangent = bankTimesRadius / bend.radius;
  const double once = cost(std::atan(tangent), tangent);
  return {once, once};
}

/** Rolling in to a bank b and out again at the rate p turns the nose by 2 g / (v p) ln(1 / cos b), so tan^2 b = exp(turned v p / g) - 1. Nothing where the whole bank costs less, or the bend is no short one. */
std::optional<RollLoss::Ends> RollLoss::brief(Bend bend) const {
  if (bend.side == 0 || bend.turned > kMostOfBrief) {
    return std::nullopt;
  }
  const double sine = sineAt(most_ / bend.radius);
  const double ahead = glide_.leastAirspeed() * std::sqrt(1.0 - sine * sine);  // m/s, over ground without wind, in the whole bank
  const double wind = glide_.strongestWind() * glide_.leastAirspeed() / glide_.airspeed();
  if (!(ahead > wind)) {
    return std::nullopt;
  }
  const double sheared = bend.radius * sine * shear_ / (1.0 - shear_) * kGravity.si() / (ahead * (ahead - wind));
  const double nose = bend.turned * (1.0 + wind / ahead + sheared);
  const double bank = std::sqrt(std::expm1(nose * glide_.airspeed() * rate_ / kGravity.si()));  // tangent
  const double once = cost(std::atan(bank), bank);
  const Ends ends{(1.0 + kLate) * once, once};
  return ends.in < kSurely * whole(bend, most_).in ? std::optional(ends) : std::nullopt;
}

double RollLoss::between(Bend before, Bend after) const {
  if (before.side != 0 && before.side == after.side) {
    return change(before, after);
  }
  return brief(before).value_or(whole(before, most_)).out + brief(after).value_or(whole(after, most_)).in;
}

std::vector<double> RollLoss::along(Bend tour, const std::vector<Bend>& bends) const {
  const auto at = [&](std::size_t k) { return k < bends.size() ? bends[k] : Bend(); };
  const auto before = [&](std::size_t k) { return k > 0 ? bends[k - 1] : tour; };
  const auto isSameSide = [](Bend a, Bend b) { return a.side != 0 && a.side == b.side; };
  std::vector<std::optional<Ends>> brief(bends.size() + 1);
  for (std::size_t k = 0; k < bends.size(); ++k) {
    if (!isSameSide(before(k), bends[k]) && !isSameSide(bends[k], at(k + 1))) {
      brief[k] = this->brief(bends[k]);
    }
  }
  const auto changeInto = [&](std::size_t k) {
    const std::optional<Ends> out = k > 0 ? brief[k - 1] : std::nullopt;
    if (!out && !brief[k]) {
      return k > 0 ? change(before(k), at(k)) : changeFromTour(tour, at(k));
    }
    return out.value_or(whole(before(k), k > 0 ? most_ : tour_)).out + brief[k].value_or(whole(at(k), most_)).in;
  };
  std::vector<double> costs;
  double sum = 0.0;
  for (std::size_t k = 0; k < bends.size(); ++k) {
    sum += changeInto(k);
    costs.push_back(sum);
  }
  if (!costs.empty()) {
    costs.back() += changeInto(bends.size());
  }
  return costs;
}

}  // namespace vp::aircraft
