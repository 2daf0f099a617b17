#include "core/audit/sample_flight.h"

#include <algorithm>
#include <cmath>

namespace vp::audit {
namespace {

double curvatureOf(const Bend& bend) {
  return bend.side == 0 ? 0.0 : bend.side / bend.radius;
}

/// Whether neither the bend before nor the one after turns to its side.
bool isAlone(const std::vector<Bend>& bends, std::size_t index, const Bend& tour) {
  const int side = bends[index].side;
  const int before = index > 0 ? bends[index - 1].side : tour.side;
  const int after = index + 1 < bends.size() ? bends[index + 1].side : 0;
  return side != 0 && before != side && after != side;
}

}  // namespace

SampleFlight::SampleFlight(const mission::Mission& mission, const GlideMotion& motion) : mission_(mission), motion_(motion) {}

double SampleFlight::steepestBank() const {
  return std::atan(steepest_);
}

void SampleFlight::note(MarginKind kind, double left) {
  LeastPlace& least = least_[static_cast<std::size_t>(kind)];
  if (left < least.left) {
    least = now_;
    least.left = left;
  }
}

bool SampleFlight::isOver(double ground) {
  if (ground < kUnknownGround) {
    return true;
  }
  fault_ = "it is over ground of unknown height";
  return false;
}

void SampleFlight::stop(const GroundTrack& rest, double altitude) {
  now_ = {0.0, rest.start.point(), altitude, 0.0};
  if (!isOver(rest.ground.front())) {
    return;
  }
  const double asked = mission_.safety.clearance.si();
  note(MarginKind::TourClearance, altitude - rest.ground.front() - asked);
  now_.altitude -= mission_.safety.reactionLoss.si();
  note(MarginKind::GlideClearance, now_.altitude - rest.ground.front() - asked);
}

void SampleFlight::follow(const GroundTrack& rest) {
  if (fault_.empty()) {
    fly(rest, nullptr, nullptr, Bend());
  }
}

void SampleFlight::glide(const PromisedGlide& glide, const Bend& tourBend) {
  if (!fault_.empty()) {
    return;
  }
  const GroundTrack& track = glide.track;
  if (!isOver(track.ground.front())) {
    return;
  }
  std::optional<RollAccount> rolls;
  if (mission_.aircraft.rollRate_dps) {
    rolls.emplace(motion_, Angle::degrees(*mission_.aircraft.rollRate_dps).radians());
    const double airspeed = std::max(motion_.airspeed(now_.altitude), motion_.tourAirspeed(now_.altitude));
    rolls->begin(tourBend.side == 0 ? 0.0 : motion_.bankOf(track.startAlong, curvatureOf(tourBend), airspeed, now_.altitude));
  }
  const double key = mission_.approach.keyHeight ? mission_.approach.keyHeight->si() : 0.0;
  const bool asksForKey = mission_.approach.kind == mission::ApproachKind::Overhead && mission_.approach.keyHeight;
  note(MarginKind::GlideClearance, now_.altitude - track.ground.front() - track.asked.front());
  if (asksForKey && glide.gate == std::optional<std::size_t>(0)) {
    note(MarginKind::Key, now_.altitude - glide.elevation - key);
  }
  fly(track, &glide, rolls ? &*rolls : nullptr, tourBend);
  if (!fault_.empty()) {
    return;
  }
  if (rolls) {
    rolls->rollLevel(now_.altitude);
    if (track.isWhole.back() != 0) {
      note(MarginKind::Rolling, now_.altitude - rolls->lost() - track.ground.back());
    }
  }
  note(MarginKind::Arrival, now_.altitude - glide.elevation - mission_.safety.arrivalMargin.si());
}

/// @param glide  null on the tour   @param rolls  null where nothing is charged   @param tourBend  flown before
void SampleFlight::fly(const GroundTrack& track, const PromisedGlide* glide, RollAccount* rolls, const Bend& tourBend) {
  const double whole = mission_.safety.clearance.si();
  const bool hasSlope = mission_.approach.kind == mission::ApproachKind::Straight && mission_.approach.slope;
  const double slope = hasSlope && glide != nullptr ? tan(*mission_.approach.slope) : 0.0;
  const bool hasKey = glide != nullptr && mission_.approach.kind == mission::ApproachKind::Overhead && mission_.approach.keyHeight;
  const std::size_t gate = glide != nullptr ? glide->gate.value_or(track.steps.size()) : track.steps.size();
  Along before = track.startAlong;
  std::size_t bend = track.bends.size();              // none yet
  double lastBank = 0.0;                              // tangent
  const bool isSame = motion_.isSameAtEveryHeight();  // then all metres of a straight are one
  std::size_t flown = track.bends.size();
  double length = 0.0;
  MetreFlown metre;
  for (std::size_t i = 0; i < track.steps.size(); ++i) {
    const TrackStep& step = track.steps[i];
    const bool isAsBefore = step.bend == flown && step.length == length && track.bends[flown].side == 0 && isSame;
    if (!isAsBefore) {
      metre = motion_.fly(before, step.middle, step.end, step.length, now_.altitude);
      flown = step.bend;
      length = step.length;
    }
    if (!metre.isPossible) {
      fault_ = "no glide keeps its track in this wind";
      return;
    }
    if (rolls != nullptr && step.bend != bend) {
      if (bend < track.bends.size()) {
        rolls->leaveWith(track.bends[bend].side == 0 ? 0.0 : std::atan(lastBank));
      }
      bend = step.bend;
      const double bank = track.bends[bend].side == 0 ? 0.0 : std::atan(metre.bankTangent);
      rolls->rollInto(track.bends[bend], isAlone(track.bends, bend, tourBend), bank, step.length / metre.took, now_.altitude);
    }
    lastBank = metre.bankTangent;
    if (track.bends[step.bend].side != 0) {
      steepest_ = std::max(steepest_, std::abs(metre.bankTangent));
    }
    now_.altitude -= i >= gate ? std::max(metre.lost, slope * step.length) : metre.lost;
    now_.seconds += metre.took;
    now_.where = step.place;
    const double ground = track.ground[i + 1];
    if (!isOver(ground)) {
      return;
    }
    note(MarginKind::GlideClearance, now_.altitude - ground - (glide != nullptr ? track.asked[i + 1] : whole));
    if (rolls != nullptr && track.isWhole[i + 1] != 0) {
      note(MarginKind::Rolling, now_.altitude - rolls->lost() - ground);
    }
    if (hasKey && i + 1 == gate) {
      note(MarginKind::Key, now_.altitude - glide->elevation - mission_.approach.keyHeight->si());
    }
    before = step.end;
  }
  metres_ += track.length;
  if (rolls != nullptr && !track.bends.empty()) {
    rolls->leaveWith(track.bends.back().side == 0 ? 0.0 : std::atan(lastBank));
  }
}

}  // namespace vp::audit
