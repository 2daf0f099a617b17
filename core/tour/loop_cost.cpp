#include "core/tour/loop_cost.h"

#include <algorithm>
#include <cmath>
#include <tuple>

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

LegShape shapeOf(std::span<const double> distance, std::span<const double> lowest, PitchLimits limits, std::span<const LegShape::Gate> gates) {
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
  shape.gates.assign(gates.begin(), gates.end());
  return shape;
}

double SpiralGround::bottomFrom(double top) const {
  double lowest = bottom;
  for (const HeightGate& gate : gates) {
    if (gate.isPassed(top, top)) {
      lowest = top >= gate.ceiling ? std::max(lowest, gate.ceiling) : lowest;
    } else {
      return std::numeric_limits<double>::infinity();
    }
  }
  return lowest;
}

SpiralTurns spiralTurns(const SpiralGround& ground, double top, PitchLimits limits) {
  const double depth = top - ground.bottomFrom(top);
  if (!(depth >= 1.0)) {
    return {};
  }
  return {static_cast<int>(std::ceil(depth / (ground.circle * limits.descent))), static_cast<int>(std::ceil(depth / (ground.circle * limits.climb)))};
}

double spiralLength(const SpiralGround& ground, double top, SpiralTurns turns) {
  const double depth = top - ground.bottomFrom(top);
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
  if (std::any_of(legs.begin(), legs.end(), [](const LegShape* leg) { return !leg->gates.empty(); })) {
    if (!passGates(legs, visits)) {
      return kInfinite;
    }
    legs = legs_;
  }
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

/// Raises legs over forbidden airspace until the loop enters none; the legs are legs_ then. @return false if it would pass above the ceiling
bool LoopCost::passGates(std::span<const LegShape* const> legs, std::span<const LoopVisit> visits) {
  legs_.assign(legs.begin(), legs.end());
  raised_.clear();
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 0; i < legs_.size(); ++i) {
      if (!legs_[i]->gates.empty() && !raiseOverGates(i, altitude_[i], altitude_[(i + 1) % legs_.size()], again)) {
        return false;
      }
    }
    if (again) {
      findAltitudes(legs_, visits);
    }
  }
  return true;
}

/// Altitude of a chain of corners.
double altitudeAt(std::span<const LegShape::Corner> chain, double distance) {
  std::size_t i = 1;
  while (i + 1 < chain.size() && chain[i].distance < distance) {
    ++i;
  }
  const LegShape::Corner& a = chain[i - 1];
  const LegShape::Corner& b = chain[i];
  return a.altitude + (b.altitude - a.altitude) * std::clamp((distance - a.distance) / (b.distance - a.distance), 0.0, 1.0);
}

bool LoopCost::raiseOverGates(std::size_t leg, double start, double end, bool& isRaised) {
  const LegShape& shape = *legs_[leg];
  layChain(shape, start, end);
  std::vector<LegShape::Corner> corners;
  for (const LegShape::Gate& gate : shape.gates) {
    const auto [low, high] = std::minmax({altitudeAt(chain_, gate.from), altitudeAt(chain_, gate.to)});
    if (gate.gate.isPassed(low, high)) {
      continue;
    }
    if (gate.gate.ceiling > ceiling_) {
      return false;
    }
    corners.push_back({gate.from, gate.gate.ceiling});
    corners.push_back({gate.to, gate.gate.ceiling});
  }
  if (corners.empty()) {
    return true;
  }
  isRaised = true;
  LegShape raised = shape;
  for (const LegShape::Corner& corner : corners) {
    raised.startNeed = std::max(raised.startNeed, corner.altitude - limits_.climb * corner.distance);
    raised.endNeed = std::max(raised.endNeed, corner.altitude - limits_.descent * (raised.length - corner.distance));
    raised.peak = std::max(raised.peak, corner.altitude);
  }
  corners.insert(corners.end(), shape.hull.begin(), shape.hull.end());
  std::sort(corners.begin(), corners.end(),
            [](const auto& a, const auto& b) { return std::tie(a.distance, a.altitude) < std::tie(b.distance, b.altitude); });
  raised.hull.clear();
  for (const LegShape::Corner& corner : corners) {
    if (corner.distance > 0.0 && corner.distance < raised.length) {
      addCorner(raised.hull, corner);
    }
  }
  raised_.push_back(std::move(raised));
  legs_[leg] = &raised_.back();
  return true;
}

void LoopCost::layChain(const LegShape& leg, double start, double end) {
  chain_.clear();
  chain_.push_back({0.0, start});
  for (const LegShape::Corner& corner : leg.hull) {
    addCorner(chain_, corner);
  }
  addCorner(chain_, {leg.length, end});
}

double LoopCost::lengthOf(const LegShape& leg, double start, double end) {
  layChain(leg, start, end);
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
  return spiralLength(visit.spiral, altitude, turns) + beta_ * (visit.spiral.bottomFrom(altitude) - visit.altitude);
}

}  // namespace vp::tour
