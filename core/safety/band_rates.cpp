#include "core/safety/band_rates.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace vp::safety {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

BandRates::BandRates(const aircraft::GlideModel& model, bool isAsInProfile, std::vector<WindGlide> glides, WindSet winds)
    : model_(model), isAsInProfile_(isAsInProfile), glides_(std::move(glides)), winds_(std::move(winds)) {}

LossAlong BandRates::along(double course, const flight::Piece& piece) {
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
  if (!known->second.isFinite()) {
    return LossAlong(kInfinity);
  }
  known->second.learn(glides_, winds_, coursesOf(wrapTwoPi(course), piece));
  return {known->second, wrapTwoPi(course), piece.turn == flight::Turn::Left ? 1.0 : -1.0, piece.radius};
}

/// In still air the fastest banks the most, and straight on all lose alike.
double BandRates::stillLoss(const flight::Piece& piece) const {
  const bool isStraight = piece.turn == flight::Turn::Straight;
  if (isAsInProfile_) {
    return model_.lossAt(isStraight ? 0.0 : piece.radius);
  }
  const WindGlide& fastest = glides_.back();
  return isStraight ? fastest.lossAt(fastest.straightSine(), 0.0, 0.0) : fastest.lossInTurn(0.0, 0.0, piece.radius);
}

double BandRates::leastAlong(double course, const flight::Piece& piece) const {
  if (isCalm() && isAsInProfile_) {
    return stillLoss(piece);
  }
  double least = kInfinity;
  for (const WindGlide& glide : glides_) {
    least = std::min(least, glide.leastLoss(winds_, coursesOf(course, piece)));
  }
  return least;
}

}  // namespace vp::safety
