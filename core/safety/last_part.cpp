#include "core/safety/last_part.h"

#include "core/safety/limits.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::safety {
namespace {

void dropEmptyEnds(std::vector<flight::Piece>& pieces) {
  while (!pieces.empty() && pieces.back().length == 0.0) {
    pieces.pop_back();
  }
}

/// Moves the last metres of straights into `last`. @return false if there are too few of them
bool splitStraight(SplitGlide& glide, double length) {
  double missing = length;
  while (missing > kGapTolerance) {
    dropEmptyEnds(glide.before);
    if (glide.before.empty() || glide.before.back().turn != flight::Turn::Straight) {
      return false;
    }
    flight::Piece& end = glide.before.back();
    const double taken = std::min(missing, end.length);
    end.length -= taken;
    missing -= taken;
  }
  glide.last = {flight::Turn::Straight, 0.0, length - missing};
  return true;
}

bool splitCircle(SplitGlide& glide) {
  dropEmptyEnds(glide.before);
  if (glide.before.empty() || glide.before.back().turn == flight::Turn::Straight) {
    return false;
  }
  glide.last = glide.before.back();
  glide.before.pop_back();
  return std::abs(glide.last.length - 2.0 * Angle::kPi * glide.last.radius) <= kGapTolerance;
}

}  // namespace

double LastPart::clearanceAt(double toGo, double whole) const {
  return surfaceSlope ? std::min(whole, *surfaceSlope * std::max(0.0, toGo - surfaceStart)) : whole;
}

std::optional<SplitGlide> splitAtGate(const std::vector<flight::Piece>& pieces, const mission::ApproachSettings& approach) {
  SplitGlide glide{pieces, {}, {}};
  if (approach.kind == mission::ApproachKind::Threshold) {
    return glide;
  }
  const bool isStraight = approach.kind == mission::ApproachKind::Straight;
  if (!(isStraight ? splitStraight(glide, approach.finalLength.si()) : splitCircle(glide))) {
    return {};
  }
  glide.part.surfaceSlope = approach.surfaceSlope;
  glide.part.surfaceStart = approach.surfaceStart.si();
  if (isStraight && approach.slope) {
    glide.part.slope = tan(*approach.slope);
  }
  if (!isStraight && approach.keyHeight) {
    glide.part.keyHeight = approach.keyHeight->si();
  }
  return glide;
}

geo::Pose gateOf(const geo::Pose& touchdown, const mission::ApproachSettings& approach) {
  const double back = approach.kind == mission::ApproachKind::Straight ? approach.finalLength.si() : 0.0;
  return {touchdown.x - back * std::cos(touchdown.heading), touchdown.y - back * std::sin(touchdown.heading), touchdown.heading};
}

}  // namespace vp::safety
