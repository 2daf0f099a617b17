// Between an engine failure and the pilot's first action nothing changes: WHY.md section 10.

#include "core/safety/check_context.h"
#include "core/safety/limits.h"
#include "core/safety/rules.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace vp::safety {
namespace {

bool isSameCurve(const flight::Piece& a, const flight::Piece& b) {
  return a.turn == b.turn && (a.turn == flight::Turn::Straight || std::abs(a.radius - b.radius) <= kRadiusTolerance * a.radius);
}

/** Goes on along a track from one of its points. */
class TrackFollower {
public:
  TrackFollower(const CheckContext& context, std::size_t point) : context_(context), point_(point) {}

  /// Metres that a piece keeps to the track from here, at most `length`; goes on by so many. 0: it leaves the track here.
  double follow(const flight::Piece& piece, double length) {
    const std::size_t count = context_.track.points.size();
    for (std::size_t passed = 0; passed <= count; ++passed) {
      if (!context_.track.isClosed && point_ + 1 == count) {
        return 0.0;  // nothing comes after the last point
      }
      const flight::Piece& onward = context_.track.points[point_].onward;
      if (const double left = onward.length - flown_; left > kSpacingTolerance) {
        const double together = isSameCurve(piece, onward) ? std::min(left, length) : 0.0;
        flown_ += together;
        return together;
      }
      point_ = context_.next(point_);
      flown_ = 0.0;
    }
    return 0.0;
  }

private:
  const CheckContext& context_;
  std::size_t point_ = 0;
  double flown_ = 0.0;  // of the point's onward piece
};

/// Where the glide of a point first turns by itself [m]; `enough` if it does not before that.
double firstOwnTurn(const CheckContext& context, std::size_t index, double enough) {
  TrackFollower tour(context, index);
  bool follows = true;
  double flown = 0.0;
  for (const flight::Piece& piece : context.track.points[index].witness.pieces) {
    double left = piece.length;
    while (left > kSpacingTolerance && flown < enough) {
      const double together = follows ? tour.follow(piece, left) : 0.0;
      follows = together > 0.0;
      if (!follows && piece.turn != flight::Turn::Straight) {
        return flown;
      }
      const double gone = follows ? together : left;
      flown += gone;
      left -= gone;
    }
  }
  return enough;
}

}  // namespace

double reactionLength(const CheckContext& context) {
  return context.plan.mission.safety.reactionTime.si() * context.rates.fastestOverGround();
}

bool checkReaction(CheckContext& context, std::size_t index) {
  const double enough = reactionLength(context);
  if (!(enough > 0.0)) {
    return true;
  }
  const double turns = firstOwnTurn(context, index, enough);
  if (turns >= enough - kGapTolerance) {
    return true;
  }
  context.findings.violated(
      rule::kGlideReaction,
      fmt::format("{}: its glide begins to turn {:.1f} m on, but until the pilot reacts after {:.1f} s the aircraft may have gone on "
                  "for {:.1f} m",
                  context.nameOf(index), turns, context.plan.mission.safety.reactionTime.si(), enough),
      context.at(index), turns - enough);
  return false;
}

}  // namespace vp::safety
