#include "core/tour/segment.h"

#include "core/base/expect.h"
#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"
#include "core/landing/required_height.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace vp::tour {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// Sums of the same losses in another order may come out this much lower [relative].
constexpr double kRounding = 1.0 - 1e-12;

}  // namespace

SegmentBuilder::SegmentBuilder(const landing::World& world, const landing::Roadmap& roadmap, const Detours& detours, SegmentSettings settings,
                               std::stop_token stop, const landing::AltitudeFloor* floor)
    : world_(world),
      roadmap_(roadmap),
      detours_(detours),
      settings_(settings),
      stop_(std::move(stop)),
      altitudeFloor_(floor),
      losses_(flight::bandLossesOf(world.glide, world.glide.glideRadii().size())) {}

/// Appends the path that the visit asks for. @return false if there is none of its word
bool SegmentBuilder::appendDirect(const VisitPose& from, const VisitPose& to) {
  const double radius = world_.glide.tourRadius();
  if (from.target == to.target) {
    // a tour of one target: a circle brings it back
    pieces_.push_back({from.onward == flight::Word::RSR ? flight::Turn::Right : flight::Turn::Left, radius, 2.0 * Angle::kPi * radius});
    return true;
  }
  const auto path = from.onward ? flight::dubinsWord(from.pose, to.pose, radius, *from.onward) : flight::shortestDubins(from.pose, to.pose, radius);
  if (path) {
    flight::appendPieces(*path, pieces_);
  }
  return path.has_value();
}

bool SegmentBuilder::layOut(const VisitPose& from, const VisitPose& to, Way way) {
  pieces_.clear();
  gates_.clear();
  if (way == Way::Direct) {
    return appendDirect(from, to) && cutIntoIntervals(from.pose);
  }
  const std::vector<geo::Pose>& detour =
      way == Way::Detour ? detours_.between(from.target, to.target) : detours_.aroundAirspace(from.target, to.target);
  if (detour.empty()) {
    return false;
  }
  const double radius = world_.glide.tourRadius();
  geo::Pose last = from.pose;
  for (const geo::Pose& pose : detour) {
    flight::appendPieces(flight::shortestDubins(last, pose, radius), pieces_);
    last = pose;
  }
  flight::appendPieces(flight::shortestDubins(last, to.pose, radius), pieces_);
  return cutIntoIntervals(from.pose);
}

/// The first way that can be laid out; if forbidden airspace makes it climb, or any is on it and `triesAll`, the cheapest of all.
/// @param findFloor  fills floor_, false if the leg cannot be flown
template <typename FindFloor>
bool SegmentBuilder::layOutBest(const VisitPose& from, const VisitPose& to, bool triesAll, FindFloor findFloor) {
  constexpr std::array kWays{Way::Direct, Way::Detour, Way::AroundAirspace};
  double least = kInfinite;
  std::optional<Way> best;
  bool isFirst = true;
  for (const Way way : kWays) {
    if (!layOut(from, to, way)) {
      continue;
    }
    const bool isFound = findFloor();
    if (isFirst && gates_.empty()) {
      return isFound;
    }
    bool isRaised = false;
    const bool isPassed = isFound && passGates(isRaised);
    if (isFirst && isPassed && !isRaised && !triesAll) {
      return true;
    }
    isFirst = false;
    const double cost = isPassed ? costOf(profile_, from, to) : kInfinite;
    if (cost < least) {
      least = cost;
      best = way;
    }
  }
  bool isRaised = false;
  return best && layOut(from, to, *best) && findFloor() && passGates(isRaised);
}

/// Cuts pieces_ into intervals. @return false if ground or forbidden airspace is in the way that no tour under the ceiling can cross
bool SegmentBuilder::cutIntoIntervals(const geo::Pose& start) {
  intervals_.clear();
  distance_.assign(1, 0.0);
  geo::Pose pose = start;
  for (const flight::Piece& piece : pieces_) {
    const int count = static_cast<int>(std::ceil(piece.length / settings_.step));
    const flight::Piece single{piece.turn, piece.radius, piece.length / count};
    for (int i = 0; i < count; ++i) {
      const geo::Pose from = flight::poseAfter(pose, piece, single.length * i);
      const double ground = landing::maxTerrainAlong(world_.terrain, from, single);
      if (!(ground + world_.clearance + world_.reactionLoss <= settings_.ceiling)) {
        return false;
      }
      intervals_.push_back({from, single, ground, leastLossOn(from, single)});
      distance_.push_back(distance_.back() + single.length);
      if (settings_.forbidden != nullptr && !addGates(intervals_.size() - 1)) {
        return false;
      }
    }
    pose = flight::endOf(pose, piece);
  }
  return !intervals_.empty();
}

/// @param above  m above the ground
void SegmentBuilder::terrainFloor(const VisitPose& from, const VisitPose& to, double above) {
  const std::size_t points = intervals_.size() + 1;
  floor_.assign(points, -kInfinite);
  for (std::size_t i = 0; i < intervals_.size(); ++i) {
    const double clear = intervals_[i].ground + above;
    floor_[i] = std::max(floor_[i], clear);
    floor_[i + 1] = std::max(floor_[i + 1], clear);
  }
  floor_.front() = std::max(floor_.front(), from.altitude);
  floor_.back() = std::max(floor_.back(), to.altitude);
}

/// With the dearest metre for all, so that gliding on from between the ends needs no more than from the ends.
double SegmentBuilder::leastLossOn(const geo::Pose& start, const flight::Piece& piece) const {
  double least = kInfinite;
  for (const flight::TurnLoss& losses : losses_) {
    least = std::min(least, flight::PieceLoss(piece, start.heading, losses).mostPerMetre(piece.length) * piece.length);
  }
  return losses_.size() > 1 ? least * kRounding : least;
}

/// Height at the start of an interval from which a glide along it ends at `end` or higher; both before `lostAtOnce` is lost.
double SegmentBuilder::heightBefore(std::size_t interval, double end, double lostAtOnce) const {
  const Interval& i = intervals_[interval];
  return losses_.size() == 1 ? end + i.loss : flight::mostHeightBefore(world_.glide, i.start, i.piece, end, lostAtOnce);
}

/// S at the start of an interval for the glide on along it. @param next  A at its end
double SegmentBuilder::glideFloor(std::size_t interval, double next) const {
  return heightBefore(interval, std::max(next, intervals_[interval].ground + world_.clearance + world_.reactionLoss), world_.reactionLoss);
}

void SegmentBuilder::ask(VisitPose& visit) {
  if (!visit.safe) {
    visit.safe = roadmap_.query(world_, visit.pose, scratch_).value_or(landing::SafeAltitude{kInfinite, -1, -1, {}});
  }
}

/// What is known of the safe segment's S_j without a query: ground, altitude floor, and A at both ends.
void SegmentBuilder::knownFloor(const VisitPose& from, const VisitPose& to) {
  terrainFloor(from, to, world_.clearance + world_.reactionLoss);  // which an engine failure at the end of an interval costs over its ground
  floor_.front() = std::max(floor_.front(), from.safe->altitude);
  floor_.back() = std::max(floor_.back(), to.safe->altitude);
  if (altitudeFloor_ == nullptr) {
    return;
  }
  double next = to.safe->altitude;
  for (std::size_t j = intervals_.size(); j-- > 0;) {
    const Interval& interval = intervals_[j];
    floor_[j] = std::max(floor_[j], std::max(next, interval.ground + world_.clearance + world_.reactionLoss) + interval.loss);
    next = altitudeFloor_->at(interval.start.point());
    floor_[j] = std::max(floor_[j], next);
  }
}

void SegmentBuilder::updateProfile() {
  profile_ = floor_;
  raiseEndsForPitch(distance_, profile_, settings_.pitch);
  concaveMajorant(distance_, profile_, hull_);
}

/// Takes A of a point into S of it and of the point before.
void SegmentBuilder::raiseFloor(std::size_t point) {
  floor_[point] = std::max(floor_[point], safeAltitude_[point]);
  bool isRaised = floor_[point] > profile_[point];
  if (point > 0) {
    floor_[point - 1] = std::max(floor_[point - 1], glideFloor(point - 1, safeAltitude_[point]));
    isRaised = isRaised || floor_[point - 1] > profile_[point - 1];
  }
  if (isRaised) {
    updateProfile();
  }
}

/// A of all points from the end, as far as they matter, or of `all`. floor_ is complete then.
/// @return false if stopped, or as soon as a point lies above the ceiling
bool SegmentBuilder::findSafeAltitudes(const VisitPose& to, bool all) {
  const std::size_t points = intervals_.size() + 1;
  safeAltitude_.assign(points, kInfinite);
  answers_.assign(points, std::nullopt);
  answers_.back() = Answer{*to.safe};
  safeAltitude_.back() = to.safe->altitude;
  int hint = to.safe->node;
  updateProfile();
  raiseFloor(points - 1);
  for (std::size_t j = intervals_.size(); j-- > 0;) {
    // a point may also glide on along the leg to the next point and fly its glide
    const double onward = glideFloor(j, safeAltitude_[j + 1]);
    safeAltitude_[j] = onward;
    const bool isFirst = j == 0;  // which needs the onward glide anyway, and A of the visit
    const bool fits = isFirst || (onward <= profile_[j] && heightBefore(j - 1, onward, world_.reactionLoss) <= profile_[j - 1]);
    if (!fits || all) {
      if (stop_.stop_requested()) {
        return false;
      }
      answerAt(j, hint);
    }
    raiseFloor(j);
    if (floor_[j] > settings_.ceiling && !all) {
      return false;
    }
  }
  return true;
}

SegmentCost SegmentBuilder::profileCost(const VisitPose& from, const VisitPose& to) {
  raiseEndsForPitch(distance_, floor_, settings_.pitch);
  concaveMajorant(distance_, floor_, hull_);
  return {costOf(floor_, from, to), *std::max_element(floor_.begin(), floor_.end())};
}

double SegmentBuilder::costOf(const std::vector<double>& profile, const VisitPose& from, const VisitPose& to) const {
  return *std::max_element(profile.begin(), profile.end()) > settings_.ceiling
             ? kInfinite
             : lengthInSpace(distance_, profile) + 0.5 * settings_.beta * (profile.front() - from.altitude + profile.back() - to.altitude);
}

/// Lays out, and finds the profile of the terrain segment. @return its cost
SegmentCost SegmentBuilder::terrainSegment(const VisitPose& from, const VisitPose& to) {
  const auto findFloor = [&] {
    terrainFloor(from, to, world_.clearance);
    return true;
  };
  return layOutBest(from, to, true, findFloor) ? profileCost(from, to) : SegmentCost{kInfinite, kInfinite};
}

/// Lays out and finds all S_j. @return false if there is no safe segment, or stopped
bool SegmentBuilder::layOutSafe(const VisitPose& from, const VisitPose& to) {
  if (from.safe->site < 0 || to.safe->site < 0) {
    return false;
  }
  return layOutBest(from, to, false, [&] {
    knownFloor(from, to);
    return findSafeAltitudes(to, false);
  });
}

SegmentCost SegmentBuilder::safeSegment(const VisitPose& from, const VisitPose& to) {
  VisitPose first = from;
  VisitPose last = to;
  ask(first);
  ask(last);
  return layOutSafe(first, last) ? profileCost(first, last) : SegmentCost{kInfinite, kInfinite};
}

std::optional<SegmentBuilder::Floor> SegmentBuilder::boundFloorOf(const VisitPose& from, const VisitPose& to) {
  VisitPose first = from;
  VisitPose last = to;
  ask(first);
  ask(last);
  if (first.safe->site < 0 || last.safe->site < 0) {
    return std::nullopt;
  }
  bool isLaidOut = layOut(first, last, Way::Direct);
  if (settings_.forbidden != nullptr && (!isLaidOut || !gates_.empty())) {
    return safeFloorOf(first, last);  // which way it takes is not known yet
  }
  isLaidOut = isLaidOut || layOut(first, last, Way::Detour);
  if (!isLaidOut) {
    return std::nullopt;
  }
  knownFloor(first, last);
  return Floor{distance_, floor_, gates_};
}

std::optional<SegmentBuilder::Floor> SegmentBuilder::safeFloorOf(const VisitPose& from, const VisitPose& to) {
  VisitPose first = from;
  VisitPose last = to;
  ask(first);
  ask(last);
  return layOutSafe(first, last) ? std::optional(Floor{distance_, floor_, gates_}) : std::nullopt;
}

std::vector<SegmentPoint> SegmentBuilder::safePoints(const VisitPose& from, const VisitPose& to) {
  VisitPose first = from;
  VisitPose last = to;
  ask(first);
  ask(last);
  const bool isLaidOut = layOutSafe(first, last);
  if (stop_.stop_requested()) {
    return {};
  }
  VP_EXPECT(isLaidOut);
  if (!findBestGlides(first, last)) {
    return {};
  }
  std::vector<SegmentPoint> points(floor_.size());
  for (std::size_t j = points.size(); j-- > 0;) {
    SegmentPoint& point = points[j];
    point.pose = j < intervals_.size() ? intervals_[j].start : to.pose;
    point.distance = distance_[j];
    point.lowest = floor_[j];
    point.safeAltitude = safeAltitude_[j];
    if (j < intervals_.size()) {
      point.onward = intervals_[j].piece;
    }
    if (answers_[j]) {
      point.witness = glideOf(j);
      point.site = answers_[j]->safe.site;
    } else {
      point.witness = landing::joinedGlide(world_, {point.onward}, points[j + 1].witness);
      point.site = points[j + 1].site;
    }
  }
  return points;
}

}  // namespace vp::tour
