#include "core/safety/failures.h"

#include <algorithm>

namespace vp::safety {
namespace {

/// An altitude is passed once the tour is this far beyond it, and every step goes this far: more than rounding, and no glide gets lower by more.
constexpr double kPassed = 1e-9;  // m

}  // namespace

Failures::Failures(double startAltitude, double endAltitude, double length, Descent& descent, double reactionLoss)
    : start_(startAltitude),
      rise_(endAltitude - startAltitude),
      length_(length),
      descent_(descent),
      reactionLoss_(reactionLoss),
      least_(descent.isLayered() ? startAltitude - reactionLoss : startAltitude),
      next_(descent.nextBreak(0.0)) {}

double Failures::lowestAt(double distance) {
  return descent_.isLayered() ? lowestByAltitude(distance) : lowestOfAll(distance);
}

/// What is lost is the same from every altitude, so the least of altitude + loss decides for all that follows.
double Failures::lowestOfAll(double distance) {
  const LossAlong& loss = descent_.everywhere();
  while (next_ < distance) {
    least_ = std::min(least_, altitudeAt(next_) + loss.upTo(next_));
    next_ = loss.nextBreak(next_);
  }
  return least_ - loss.upTo(distance);
}

/// Between two places a failure begins in one band on a slope of the tour that is steeper than the glide there, or not: the last of them or the
/// first is the lowest, whatever band it falls to afterwards.
double Failures::lowestByAltitude(double distance) {
  double place = nextPlace();
  while (place < distance) {
    least_ = std::min(descent_.down(at_, least_, place), altitudeAt(place) - reactionLoss_);
    at_ = place;
    next_ = next_ > at_ ? next_ : descent_.nextBreak(at_);
    place = nextPlace();
  }
  return descent_.down(at_, least_, distance) + reactionLoss_;
}

/// The next break of the loss, or where a glide would begin at an altitude at which the loss changes.
double Failures::nextPlace() const {
  const std::vector<double>& edges = descent_.edges();
  const double height = altitudeAt(at_) - reactionLoss_;
  const auto placeOf = [&](double edge) { return std::min(next_, std::max(at_ + kPassed, at_ + (edge - height) * (length_ / rise_))); };
  if (rise_ > 0.0) {
    const auto above = std::upper_bound(edges.begin(), edges.end(), height + kPassed);
    return above != edges.end() ? placeOf(*above) : next_;
  }
  const auto below = std::lower_bound(edges.begin(), edges.end(), height - kPassed);
  return rise_ < 0.0 && below != edges.begin() ? placeOf(*(below - 1)) : next_;
}

}  // namespace vp::safety
