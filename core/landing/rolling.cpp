#include "core/landing/rolling.h"

#include <cstddef>

namespace vp::landing {
namespace {

constexpr double kNoLength = 1e-6;  // m: no part of a glide

aircraft::Bend bendOf(const flight::Piece& piece) {
  return {piece.radius, static_cast<int>(piece.turn), piece.turn == flight::Turn::Straight ? 0.0 : piece.length / piece.radius};
}

}  // namespace

Rolling::Rolling(const World& world) : loss_(world.glide, world.rollRate_dps.value_or(aircraft::RollLoss::kUsualRate_dps)) {}

double Rolling::between(const flight::Piece& before, const flight::Piece& after) const {
  return loss_.between(bendOf(before), bendOf(after));
}

double Rolling::of(const flight::Piece& tour, const std::vector<flight::Piece>& pieces) const {
  const std::vector<double> costs = along(tour, pieces);
  return costs.empty() ? 0.0 : costs.back();
}

std::vector<double> Rolling::along(const flight::Piece& tour, const std::vector<flight::Piece>& pieces) const {
  std::vector<aircraft::Bend> bends;
  std::vector<std::size_t> bendOfPiece;  // how many there are up to each piece
  for (const flight::Piece& piece : pieces) {
    if (piece.length > kNoLength) {
      const aircraft::Bend bend = bendOf(piece);
      if (!bends.empty() && bends.back().side == bend.side && (bend.side == 0 || bends.back().radius == bend.radius)) {
        bends.back().turned += bend.turned;
      } else {
        bends.push_back(bend);
      }
    }
    bendOfPiece.push_back(bends.size());
  }
  const std::vector<double> costs = loss_.along(bendOf(tour), bends);
  std::vector<double> result;
  result.reserve(bendOfPiece.size());
  for (const std::size_t count : bendOfPiece) {
    result.push_back(count > 0 ? costs[count - 1] : 0.0);
  }
  return result;
}

}  // namespace vp::landing
