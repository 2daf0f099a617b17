#include "core/audit/ground_track.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace vp::audit {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kLongest = 1e6;          // m, of one path; no glide is as long
constexpr double kNoLength = 1e-7;        // m
constexpr double kSmallestRadius = 1.0;   // m
constexpr double kPlaceTolerance = 0.01;  // m along a path, for where its last part begins

Along alongOf(double heading) {
  return {std::cos(heading), std::sin(heading)};
}

int sideOf(flight::Turn turn) {
  return turn == flight::Turn::Left ? 1 : turn == flight::Turn::Right ? -1 : 0;
}

void addToBends(std::vector<Bend>& bends, const flight::Piece& piece) {
  const int side = sideOf(piece.turn);
  const bool isSame = !bends.empty() && bends.back().side == side && (side == 0 || bends.back().radius == piece.radius);
  if (!isSame) {
    bends.push_back({side, side == 0 ? 0.0 : piece.radius, 0.0, 0.0});
  }
  bends.back().length += piece.length;
  bends.back().turned += side == 0 ? 0.0 : piece.length / piece.radius;
}

/// Length of the last part of a glide [m].
double lengthOfLastPart(const GroundTrack& glide, const mission::ApproachSettings& approach) {
  switch (approach.kind) {
    case mission::ApproachKind::Straight:
      return approach.finalLength.si();
    case mission::ApproachKind::Overhead:
      return glide.bends.empty() ? 0.0 : 2.0 * kPi * glide.bends.back().radius;
    case mission::ApproachKind::Threshold:
      break;
  }
  return 0.0;
}

}  // namespace

geo::Pose GroundTrack::end() const {
  return steps.empty() ? start : geo::Pose{steps.back().place.x, steps.back().place.y, steps.back().heading};
}

std::optional<GroundTrack> cutIntoMetres(const geo::Pose& start, const std::vector<flight::Piece>& pieces) {
  GroundTrack track;
  track.start = start;
  track.startAlong = alongOf(start.heading);
  TrackStep step{track.startAlong, track.startAlong, start.point(), start.heading, 0.0, 0.0, 0};
  for (const flight::Piece& piece : pieces) {
    const int side = sideOf(piece.turn);
    if (!(piece.length >= 0.0 && track.length + piece.length <= kLongest) || (side != 0 && !(piece.radius >= kSmallestRadius))) {
      return std::nullopt;
    }
    if (piece.length <= kNoLength) {
      continue;  // in the rounding of its ends every bank would fit
    }
    addToBends(track.bends, piece);
    step.bend = track.bends.size() - 1;
    const double count = std::ceil(piece.length / kStep);
    const double begins = step.heading;
    step.length = piece.length / count;
    const double turn = side == 0 ? 0.0 : side * step.length / piece.radius;
    for (double k = 0.0; k < count; k += 1.0) {
      const Along before = step.end;
      if (side != 0) {
        step.heading = begins + (k + 1.0) * turn;
        step.middle = alongOf(begins + (k + 0.5) * turn);
        step.end = alongOf(step.heading);
      } else {
        step.middle = before;
      }
      step.place.x += step.length * (before.east + 4.0 * step.middle.east + step.end.east) / 6.0;
      step.place.y += step.length * (before.north + 4.0 * step.middle.north + step.end.north) / 6.0;
      step.flown = track.length + (k + 1.0) * step.length;
      track.steps.push_back(step);
    }
    track.length += piece.length;
  }
  return track;
}

void putGroundUnder(GroundTrack& track, const GroundLookup& lookup) {
  std::vector<geo::Point> places;
  places.reserve(track.steps.size() + 1);
  places.push_back(track.start.point());
  for (const TrackStep& step : track.steps) {
    places.push_back(step.place);
  }
  lookup(places, track.ground);
}

std::optional<std::size_t> askForClearance(GroundTrack& glide, const mission::Mission& mission) {
  const mission::ApproachSettings& approach = mission.approach;
  const double whole = mission.safety.clearance.si();
  const double last = lengthOfLastPart(glide, approach);
  glide.asked.assign(glide.steps.size() + 1, whole);
  glide.isWhole.assign(glide.steps.size() + 1, 1);
  if (!(last > 0.0)) {
    return std::nullopt;
  }
  std::size_t gate = glide.steps.size();
  for (std::size_t i = 0; i <= glide.steps.size(); ++i) {
    const double toGo = glide.length - (i > 0 ? glide.steps[i - 1].flown : 0.0);
    if (toGo > last + kPlaceTolerance) {
      continue;
    }
    gate = std::min(gate, i);
    if (approach.surfaceSlope) {
      const double surface = *approach.surfaceSlope * std::max(0.0, toGo - approach.surfaceStart.si());
      glide.asked[i] = std::min(whole, surface);
      glide.isWhole[i] = surface >= whole ? 1 : 0;
    }
  }
  return gate;
}

std::string faultOfLastPart(const GroundTrack& glide, const mission::ApproachSettings& approach) {
  const double last = lengthOfLastPart(glide, approach);
  const bool isOverhead = approach.kind == mission::ApproachKind::Overhead;
  if (approach.kind == mission::ApproachKind::Threshold) {
    return "";
  }
  if (glide.bends.empty() || (glide.bends.back().side != 0) != isOverhead || glide.bends.back().length < last - kPlaceTolerance) {
    return isOverhead ? "its glide does not end in one full circle from above the touchdown point"
                      : fmt::format("its glide does not end in a straight of {:.0f} m", last);
  }
  return "";
}

}  // namespace vp::audit
