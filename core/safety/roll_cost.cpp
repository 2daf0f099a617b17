#include "core/safety/roll_cost.h"

#include "core/safety/limits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::safety {
namespace {

/// Arcs that turn further are no corrections of the course, and are charged their whole bank.
constexpr double kMostOfShort = Angle::kPi / 2.0;  // rad

/// How late a roll into a short arc may begin, as a part of its own time: as it is charged for whole banks (WHY.md section 14).
constexpr double kLate = 0.5;

bool isSameSide(const flight::Piece& a, const flight::Piece& b) {
  return a.turn == b.turn && a.turn != flight::Turn::Straight;
}

/** Pieces that lie on one line or circle. */
struct Curve {
  flight::Piece piece;    // of their whole length
  std::size_t first = 0;  // of them
  std::size_t last = 0;
};

/// Pieces of no length belong to none.
std::vector<Curve> curvesOf(const std::vector<flight::Piece>& pieces) {
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const flight::Piece& piece = pieces[i];
    if (!(piece.length > kSpacingTolerance)) {
      continue;
    }
    if (!curves.empty() && isSameSide(curves.back().piece, piece) && curves.back().piece.radius == piece.radius) {
      curves.back().piece.length += piece.length;
      curves.back().last = i;
    } else {
      curves.push_back({piece, i, i});
    }
  }
  return curves;
}

}  // namespace

RollCost::RollCost(const PlanConditions& conditions, const aircraft::AircraftProfile& profile, const GlideRates& rates)
    : rate_(Angle::degrees(*profile.rollRate_dps).radians()), airspeed_(conditions.glide.most) {
  const WindGlide fastest(profile, conditions, airspeed_, rates.shear());
  turnSine_ = fastest.sinkSine(0.0, 0.0, std::numeric_limits<double>::infinity());
  levelSine_ = std::max(fastest.straightSine(), turnSine_);
  inducedSine_ = fastest.inducedSine();
  slowest_ = conditions.glide.least;
  strongest_ = rates.winds().strongest();
  kappa_ = 1.0 / rates.shear().least - 1.0;
  const auto bankOf = [&](double airspeed) {
    return (airspeed + rates.winds().strongest()) * (airspeed + rates.winds().strongest()) / kGravity.si();
  };
  glideBank_ = bankOf(airspeed_);
  const double slowest = std::max(0.0, conditions.glide.least - rates.winds().strongest());
  leastBank_ = std::min(glideBank_, slowest * slowest / kGravity.si());
  tourBank_ = bankOf(std::max(airspeed_, conditions.tour.most));
}

double RollCost::costOf(double angle, double tangent) const {
  return angle / rate_ * airspeed_ * std::min(1.0, levelSine_ + inducedSine_ * tangent * tangent);
}

/// In a wind that asks for the tangent c/R of a bank. To the other side both banks count, greatest where c is; to the same side the difference of the
/// two is greatest where c is nearest to the mean of the radii.
double RollCost::between(const flight::Piece& before, const flight::Piece& after) const {
  const bool wasTurning = before.turn != flight::Turn::Straight;
  const bool isTurning = after.turn != flight::Turn::Straight;
  if (!wasTurning || !isTurning) {
    const double radius = wasTurning ? before.radius : after.radius;
    return wasTurning || isTurning ? costOf(std::atan(glideBank_ / radius), glideBank_ / radius) : 0.0;
  }
  const double tangent = glideBank_ / std::min(before.radius, after.radius);
  if (before.turn != after.turn) {
    return costOf(std::atan(glideBank_ / before.radius) + std::atan(glideBank_ / after.radius), tangent);
  }
  const double bank = std::clamp(std::sqrt(before.radius * after.radius), leastBank_, glideBank_);
  return costOf(std::abs(std::atan(bank / before.radius) - std::atan(bank / after.radius)), tangent);
}

double RollCost::afterTour(const flight::Piece& tour, const flight::Piece& first) const {
  if (tour.turn == flight::Turn::Straight) {
    return between(tour, first);
  }
  const double most = std::atan(tourBank_ / tour.radius);
  if (first.turn == flight::Turn::Straight) {
    return costOf(most, tourBank_ / tour.radius);
  }
  const double tangent = std::max(tourBank_ / tour.radius, glideBank_ / first.radius);
  if (first.turn != tour.turn) {
    return costOf(most + std::atan(glideBank_ / first.radius), tangent);
  }
  const bool isSame = std::abs(first.radius - tour.radius) <= kRadiusTolerance * tour.radius;
  return isSame ? 0.0 : costOf(std::max(most, std::atan(glideBank_ / first.radius)), tangent);  // either may be the steeper
}

/// The angle that the nose turns by is that of the course and what the crab changes meanwhile: on the way round, and as the wind changes with height.
double RollCost::bankWithin(double turned, double radius) const {
  const double tangent = glideBank_ / radius;
  const double sine = turnSine_ + inducedSine_ * tangent * tangent;
  const double ahead = sine < 1.0 ? slowest_ * std::sqrt(1.0 - sine * sine) : 0.0;
  if (!(ahead > strongest_)) {
    return Angle::kPi / 2.0;  // no glide, no bound
  }
  const double sheared = radius * sine * kappa_ * kGravity.si() / (ahead * (ahead - strongest_));
  const double nose = turned * (1.0 + strongest_ / ahead + sheared);
  return std::atan(std::sqrt(std::expm1(nose * airspeed_ * rate_ / kGravity.si())));
}

RollCost::Ends RollCost::wholeRolls(double tangent) const {
  const double cost = costOf(std::atan(tangent), tangent);
  return {cost, cost};
}

/// Nothing where the whole bank costs less, or the arc is no short one.
std::optional<RollCost::Ends> RollCost::shortRolls(const flight::Piece& arc) const {
  if (arc.turn == flight::Turn::Straight || !(arc.length <= kMostOfShort * arc.radius)) {
    return {};
  }
  const double bank = bankWithin(arc.length / arc.radius, arc.radius);
  const double once = costOf(bank, std::tan(bank));
  const Ends rolls{(1.0 + kLate) * once, once};
  return rolls.in < wholeRolls(glideBank_ / arc.radius).in ? std::optional(rolls) : std::nullopt;
}

/// Short arcs are rolled into from level and out of to level; beside a turn to the same side none counts as short.
std::vector<double> RollCost::along(const std::optional<flight::Piece>& tour, const std::vector<flight::Piece>& pieces) const {
  const std::vector<Curve> curves = curvesOf(pieces);
  const flight::Piece level;
  const auto pieceAt = [&](std::size_t k) -> const flight::Piece& { return k < curves.size() ? curves[k].piece : level; };
  const auto pieceBefore = [&](std::size_t k) -> const flight::Piece& { return k > 0 ? curves[k - 1].piece : tour ? *tour : level; };
  std::vector<std::optional<Ends>> rolls(curves.size() + 1);
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const bool isAlone = !isSameSide(pieceBefore(k), pieceAt(k)) && !isSameSide(pieceAt(k), pieceAt(k + 1));
    rolls[k] = isAlone ? shortRolls(pieceAt(k)) : std::nullopt;
  }
  const auto wholeOf = [&](const flight::Piece& piece, double bank) {
    return piece.turn == flight::Turn::Straight ? Ends() : wholeRolls(bank / piece.radius);
  };
  const auto changeInto = [&](std::size_t k) {
    const flight::Piece& before = pieceBefore(k);
    const std::optional<Ends> outOf = k > 0 ? rolls[k - 1] : std::nullopt;
    if (!outOf && !rolls[k]) {
      return k > 0 ? between(before, pieceAt(k)) : afterTour(before, pieceAt(k));
    }
    return outOf.value_or(wholeOf(before, k > 0 ? glideBank_ : tourBank_)).out + rolls[k].value_or(wholeOf(pieceAt(k), glideBank_)).in;
  };
  std::vector<double> costs(pieces.size(), 0.0);
  double sum = 0.0;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    sum += changeInto(k);
    std::fill(costs.begin() + static_cast<std::ptrdiff_t>(curves[k].first), costs.end(), sum);
  }
  if (!curves.empty()) {
    std::fill(costs.begin() + static_cast<std::ptrdiff_t>(curves.back().last), costs.end(), sum + changeInto(curves.size()));
  }
  return costs;
}

}  // namespace vp::safety
