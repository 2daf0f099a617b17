#include "core/safety/descent.h"

#include <algorithm>
#include <limits>

namespace vp::safety {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

const std::vector<double>& Descent::edges() const {
  static const std::vector<double> kNone;
  return rates_ == nullptr ? kNone : rates_->edges();
}

const LossAlong& Descent::lossIn(std::size_t band) {
  if (!losses_[band]) {
    losses_[band] = rates_->alongIn(band, course_, piece_);
  }
  return *losses_[band];
}

double Descent::down(double from, double height, double to) {
  if (!(to > from)) {
    return height;
  }
  const std::vector<double>& all = edges();
  auto band = static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), height) - all.begin());  // of two at an edge, the lower
  for (double at = from;; --band) {
    const LossAlong& loss = lossIn(band);
    if (!loss.isFinite()) {
      return -kInfinity;
    }
    const double lost = loss.upTo(at);
    const double end = height - (loss.upTo(to) - lost);
    if (band == 0 || !(end < all[band - 1])) {
      return end;
    }
    at = std::clamp(loss.distanceOf(lost + (height - all[band - 1])), at, to);
    height = all[band - 1];
  }
}

double Descent::up(double to, double height, double from) {
  if (!(to > from)) {
    return height;
  }
  const std::vector<double>& all = edges();
  auto band = static_cast<std::size_t>(std::upper_bound(all.begin(), all.end(), height) - all.begin());  // of two at an edge, the upper
  for (double at = to;; ++band) {
    const LossAlong& loss = lossIn(band);
    if (!loss.isFinite()) {
      return kInfinity;
    }
    const double lost = loss.upTo(at);
    const double start = height + (lost - loss.upTo(from));
    if (band == all.size() || !(start > all[band])) {
      return start;
    }
    at = std::clamp(loss.distanceOf(lost - (all[band] - height)), from, at);
    height = all[band];
  }
}

double Descent::nextBreak(double distance) {
  if (!isLayered()) {
    return everywhere().nextBreak(distance);
  }
  if (rates_->isCalm() || piece_.turn == flight::Turn::Straight) {
    return kInfinity;
  }
  return nextCourseBreak(wrapTwoPi(course_), piece_.turn == flight::Turn::Left ? 1.0 : -1.0, piece_.radius, distance);
}

}  // namespace vp::safety
