#include "core/landing/roadmap.h"

#include "core/landing/required_height.h"

#include <cmath>

namespace vp::landing {
namespace {

/// Whether a glide may begin as soon as the engine has stopped, and loses nothing before it.
bool isAtOnce(const World& world) {
  return world.reactionLength <= 0.0 && world.reactionLoss <= 0.0;
}

}  // namespace

geo::Pose afterReaction(const World& world, const geo::Pose& from) {
  if (world.reactionLength <= 0.0) {
    return from;
  }
  return {from.x + world.reactionLength * std::cos(from.heading), from.y + world.reactionLength * std::sin(from.heading), from.heading};
}

double beforeReaction(const World& world, const geo::Pose& from, double altitude) {
  if (world.reactionLength <= 0.0) {
    return altitude + world.reactionLoss;
  }
  return requiredOverStraight(world, from, world.reactionLength, altitude) + world.reactionLoss;
}

Roadmap::Roadmap(const std::vector<Approach>& approaches) {
  for (const Approach& approach : approaches) {
    const auto site = static_cast<std::size_t>(approach.site);
    if (site >= approaches_.size()) {
      approaches_.resize(site + 1);
    }
    approaches_[site] = approach.pieces;
  }
}

std::optional<SafeAltitude> Roadmap::query(const World& world, const geo::Pose& from, QueryScratch& scratch, int hint) const {
  std::optional<SafeAltitude> answer = queryTurning(world, afterReaction(world, from), scratch, hint);
  if (!answer || isAtOnce(world)) {
    return answer;
  }
  answer->altitude = beforeReaction(world, from, answer->altitude);
  answer->straight = world.reactionLength;
  return std::isfinite(answer->altitude) ? answer : std::nullopt;
}

std::vector<flight::Piece> Roadmap::witnessPieces(const SafeAltitude& answer) const {
  std::vector<flight::Piece> pieces;
  if (answer.straight > 0.0) {
    pieces.push_back({flight::Turn::Straight, 0.0, answer.straight});
  }
  const std::size_t before = pieces.size();
  appendGlide(answer, pieces);
  if (before > 0 && pieces.size() > before && pieces[before].turn == flight::Turn::Straight) {
    pieces[before].length += pieces[0].length;
    pieces.erase(pieces.begin());
  }
  if (const auto site = static_cast<std::size_t>(answer.site); site < approaches_.size()) {
    pieces.insert(pieces.end(), approaches_[site].begin(), approaches_[site].end());
  }
  return pieces;
}

}  // namespace vp::landing
