#include "core/tour/loop_cost.h"

#include <algorithm>
#include <cmath>

namespace vp::tour {
namespace {

/// Adds a corner to an upper hull and drops those that it covers.
void addCorner(std::vector<LegShape::Corner>& hull, LegShape::Corner next) {
  while (hull.size() >= 2) {
    const LegShape::Corner& a = hull[hull.size() - 2];
    const LegShape::Corner& b = hull.back();
    if ((b.distance - a.distance) * (next.altitude - a.altitude) - (b.altitude - a.altitude) * (next.distance - a.distance) < 0.0) {
      break;  // b lies above the chord from a to the next
    }
    hull.pop_back();
  }
  hull.push_back(next);
}

}  // namespace

LegShape shapeOf(std::span<const double> distance, std::span<const double> lowest, PitchLimits limits) {
  LegShape shape;
  shape.length = distance.back();
  shape.startNeed = lowest.front();
  shape.endNeed = lowest.back();
  shape.peak = std::max(lowest.front(), lowest.back());
  for (std::size_t j = 0; j < lowest.size(); ++j) {
    shape.startNeed = std::max(shape.startNeed, lowest[j] - limits.climb * distance[j]);
    shape.endNeed = std::max(shape.endNeed, lowest[j] - limits.descent * (shape.length - distance[j]));
    shape.peak = std::max(shape.peak, lowest[j]);
    if (j > 0 && j + 1 < lowest.size()) {
      addCorner(shape.hull, {distance[j], lowest[j]});
    }
  }
  shape.hull.shrink_to_fit();
  return shape;
}

SpiralTurns spiralTurns(const SpiralGround& ground, double top, PitchLimits limits) {
  const double depth = top - ground.bottom;
  if (!(depth >= 1.0)) {
    return {};
  }
  return {static_cast<int>(std::ceil(depth / (ground.circle * limits.descent))), static_cast<int>(std::ceil(depth / (ground.circle * limits.climb)))};
}

double spiralLength(const SpiralGround& ground, double top, SpiralTurns turns) {
  const double depth = top - ground.bottom;
  return std::hypot(turns.down * ground.circle, depth) + std::hypot(turns.up * ground.circle, depth);
}

double LoopCost::operator()(std::span<const LegShape* const> legs, std::span<const LoopVisit> visits) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const LegShape* leg : legs) {
    if (!(leg->peak <= ceiling_) || !std::isfinite(leg->length)) {
      return kInfinite;
    }
  }
  findAltitudes(legs, visits);
  double cost = 0.0;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (altitude_[i] > ceiling_) {
      return kInfinite;
    }
    cost += lengthOf(*legs[i], altitude_[i], altitude_[(i + 1) % legs.size()]) + costOf(visits[i], altitude_[i]);
  }
  return cost;
}

void LoopCost::findAltitudes(std::span<const LegShape* const> legs, std::span<const LoopVisit> visits) {
  const std::size_t count = legs.size();
  altitude_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    altitude_[i] = std::max({visits[i].altitude, legs[i]->startNeed, legs[(i + count - 1) % count]->endNeed});
  }
  // two rounds each way, as raiseForPitchAround
  for (std::size_t k = 0; k < 2 * count; ++k) {
    const std::size_t i = k % count;
    const std::size_t next = (i + 1) % count;
    altitude_[next] = std::max(altitude_[next], altitude_[i] - limits_.descent * legs[i]->length);
  }
  for (std::size_t k = 2 * count; k-- > 0;) {
    const std::size_t i = k % count;
    const std::size_t next = (i + 1) % count;
    altitude_[i] = std::max(altitude_[i], altitude_[next] - limits_.climb * legs[i]->length);
  }
}

double LoopCost::lengthOf(const LegShape& leg, double start, double end) {
  chain_.clear();
  chain_.push_back({0.0, start});
  for (const LegShape::Corner& corner : leg.hull) {
    addCorner(chain_, corner);
  }
  addCorner(chain_, {leg.length, end});
  double length = 0.0;
  for (std::size_t i = 1; i < chain_.size(); ++i) {
    const double along = chain_[i].distance - chain_[i - 1].distance;
    const double rise = chain_[i].altitude - chain_[i - 1].altitude;
    length += std::sqrt(along * along + rise * rise);
  }
  return length;
}

double LoopCost::costOf(const LoopVisit& visit, double altitude) const {
  const SpiralTurns turns = spiralTurns(visit.spiral, altitude, limits_);
  if (turns.down == 0) {
    return beta_ * (altitude - visit.altitude);
  }
  return spiralLength(visit.spiral, altitude, turns) + beta_ * (visit.spiral.bottom - visit.altitude);
}

}  // namespace vp::tour
