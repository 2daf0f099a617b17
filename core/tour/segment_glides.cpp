// The glides of a segment's decision points.
#include "core/tour/segment.h"

#include <algorithm>
#include <limits>

namespace vp::tour {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

}  // namespace

/// A of a point by a query, if that is lower than gliding on along the leg.
void SegmentBuilder::answerAt(std::size_t point, int& hint) {
  const std::optional<landing::SafeAltitude> answer = roadmap_.query(world_, intervals_[point].start, scratch_, hint);
  if (answer && answer->altitude <= safeAltitude_[point]) {
    safeAltitude_[point] = answer->altitude;
    hint = answer->node;
    answers_[point] = Answer{*answer};
  }
  if (world_.reactionLength > 0.0) {
    answerAlong(point, hint);
  }
}

/// The same by a glide that follows the leg while the pilot reacts, and turns where that is over.
void SegmentBuilder::answerAlong(std::size_t point, int hint) {
  const double end = distance_[point] + world_.reactionLength;
  const auto turning = static_cast<std::size_t>(std::lower_bound(distance_.begin(), distance_.end(), end) - distance_.begin());
  if (turning >= intervals_.size()) {
    return;  // the end of the leg has its own answer
  }
  double lost = 0.0;
  double needed = -kInfinite;
  for (std::size_t i = point; i < turning; ++i) {
    lost += intervals_[i].loss;
    needed = std::max(needed, intervals_[i].ground + world_.clearance + lost);
  }
  const geo::Pose& pose = intervals_[turning].start;
  const double least = altitudeFloor_ != nullptr ? altitudeFloor_->at(pose.point()) : -kInfinite;  // holds what reacting costs
  if (std::max(needed + world_.reactionLoss, least + lost) >= safeAltitude_[point]) {
    return;
  }
  std::optional<landing::SafeAltitude> answer = roadmap_.queryTurning(world_, pose, scratch_, hint);
  if (!answer) {
    return;
  }
  if (losses_.size() == 1) {
    answer->altitude = std::max(needed, answer->altitude + lost) + world_.reactionLoss;
  } else {
    for (std::size_t i = turning; i-- > point;) {
      answer->altitude = heightBefore(i, std::max(answer->altitude, intervals_[i].ground + world_.clearance), 0.0);
    }
    answer->altitude += world_.reactionLoss;
  }
  if (answer->altitude < safeAltitude_[point]) {
    safeAltitude_[point] = answer->altitude;
    answers_[point] = Answer{*answer, turning - point};
  }
}

/** The glides that are shown are the best of all points, so none of them needs more height than the search, which asked a
 *  few points only, knew of. The floor stays the one that the search paid for. @return false if stopped */
bool SegmentBuilder::findBestGlides(const VisitPose& from, const VisitPose& to) {
  const std::vector<std::optional<Answer>> searched = answers_;
  const std::vector<double> paid = floor_;
  if (!findSafeAltitudes(to, true)) {
    return false;
  }
  floor_ = paid;
  if (!answers_.front() || from.safe->altitude < answers_.front()->safe.altitude) {
    answers_.front() = Answer{*from.safe};
  }
  for (std::size_t j = intervals_.size(); j-- > 0;) {
    if (searched[j] && (!answers_[j] || searched[j]->safe.altitude < answers_[j]->safe.altitude)) {
      answers_[j] = searched[j];
    }
    const double onward = glideFloor(j, safeAltitude_[j + 1]);
    if (answers_[j] && answers_[j]->safe.altitude <= onward) {
      safeAltitude_[j] = answers_[j]->safe.altitude;
    } else {
      answers_[j].reset();
      safeAltitude_[j] = onward;
    }
  }
  return true;
}

/// The pieces of a point's answer.
std::vector<flight::Piece> SegmentBuilder::glideOf(std::size_t point) const {
  std::vector<flight::Piece> glide = roadmap_.witnessPieces(answers_[point]->safe);
  for (std::size_t i = point + answers_[point]->along; i-- > point;) {
    glide = landing::joinedGlide(world_, {intervals_[i].piece}, glide);
  }
  return glide;
}

}  // namespace vp::tour
