#include "core/route/fly_by.h"

#include "core/flight/curve_sampling.h"

#include <algorithm>
#include <cmath>

namespace vp::route {
namespace {

constexpr double kLeastTurn = 1e-9;    // rad
constexpr double kSharpEnough = 0.02;  // rad; a flatter turn cannot make up for an offset
constexpr double kMostMakeUp = 30.0;   // m that a turn may begin earlier or later for it
constexpr double kSameOffset = 1e-7;   // m
constexpr double kRoomToReturn = 1.5;  // times the way that two turns back to the leg take
constexpr int kMostLaps = 8;

struct Leg {
  geo::Point from;
  double heading = 0.0;
  double length = 0.0;
  double turn = 0.0;  ///< rad, at its end
  double lead = 0.0;  ///< m before its end that the turn there begins
};

double wrap(double angle) {
  return std::remainder(angle, 2.0 * Angle::kPi);
}

std::vector<Leg> legsOf(const std::vector<Corner>& corners) {
  const std::size_t count = corners.size();
  std::vector<Leg> legs(count);
  for (std::size_t i = 0; i < count; ++i) {
    const geo::Point a = corners[i].point;
    const geo::Point b = corners[(i + 1) % count].point;
    legs[i] = {a, std::atan2(b.y - a.y, b.x - a.x), geo::distance(a, b), 0.0, 0.0};
  }
  for (std::size_t i = 0; i < count; ++i) {
    legs[i].turn = wrap(legs[(i + 1) % count].heading - legs[i].heading);
    legs[i].lead = corners[(i + 1) % count].radius * std::tan(std::min(std::abs(legs[i].turn), 3.0) / 2.0);
  }
  return legs;
}

/// One lap in progress: where the aircraft is, on a line beside the leg.
class Lap {
public:
  Lap(const std::vector<Corner>& corners, const std::vector<Leg>& legs, std::size_t leg, double along, double offset)
      : corners_(corners), legs_(legs), leg_(leg) {
    const Leg& on = legs_[leg];
    pose_ = {on.from.x + along * std::cos(on.heading) - offset * std::sin(on.heading),
             on.from.y + along * std::sin(on.heading) + offset * std::cos(on.heading), on.heading};
    path_.start = pose_;
    path_.passed.assign(corners.size(), 0.0);
    path_.turned.assign(corners.size(), 0.0);
    path_.first = (leg + 1) % corners.size();
  }

  [[nodiscard]] double along() const {
    const Leg& on = legs_[leg_];
    return (pose_.x - on.from.x) * std::cos(on.heading) + (pose_.y - on.from.y) * std::sin(on.heading);
  }
  [[nodiscard]] double offset() const {
    const Leg& on = legs_[leg_];
    return -(pose_.x - on.from.x) * std::sin(on.heading) + (pose_.y - on.from.y) * std::cos(on.heading);
  }

  void flyStraight(double length) {
    if (length > kSameOffset) {
      fly({flight::Turn::Straight, 0.0, length});
    }
  }

  /// Along the leg and around the corner at its end.
  void flyLeg() {
    const Leg& on = legs_[leg_];
    const std::size_t corner = (leg_ + 1) % corners_.size();
    returnToLeg();
    const double makeUp = std::abs(on.turn) > kSharpEnough ? std::clamp(offset() / std::tan(on.turn), -kMostMakeUp, kMostMakeUp) : 0.0;
    flyStraight(on.length + makeUp - on.lead - along());
    const double radius = corners_[corner].radius;
    const double arc = std::abs(on.turn) * radius;
    path_.passed[corner] = path_.length + arc / 2.0;
    path_.turned[corner] = on.turn;
    if (std::abs(on.turn) > kLeastTurn) {
      fly({on.turn > 0.0 ? flight::Turn::Left : flight::Turn::Right, radius, arc});
    }
    leg_ = corner;
    pose_.heading = legs_[leg_].heading;
  }

  [[nodiscard]] const FlownPath& path() const { return path_; }

private:
  /// Back onto the leg by two turns, where it is long enough for them before the next turn begins.
  void returnToLeg() {
    const Leg& on = legs_[leg_];
    const double aside = offset();
    const double radius = corners_[leg_].radius;
    if (std::abs(aside) <= kSameOffset || std::abs(aside) > radius) {
      return;
    }
    const double angle = std::acos(1.0 - std::abs(aside) / (2.0 * radius));
    if (on.length - on.lead - along() < kRoomToReturn * 2.0 * radius * std::sin(angle)) {
      return;
    }
    const flight::Turn towards = aside > 0.0 ? flight::Turn::Right : flight::Turn::Left;
    fly({towards, radius, radius * angle});
    fly({aside > 0.0 ? flight::Turn::Left : flight::Turn::Right, radius, radius * angle});
    pose_.heading = on.heading;
  }

  void fly(const flight::Piece& piece) {
    path_.pieces.push_back(piece);
    path_.length += piece.length;
    pose_ = flight::endOf(pose_, piece);
  }

  const std::vector<Corner>& corners_;
  const std::vector<Leg>& legs_;
  std::size_t leg_ = 0;
  geo::Pose pose_;
  FlownPath path_;
};

}  // namespace

Result<FlownPath> flyAround(const std::vector<Corner>& corners) {
  const std::vector<Leg> legs = legsOf(corners);
  std::size_t longest = 0;
  double best = -1e300;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const double room = legs[i].length - legs[i].lead - legs[(i + legs.size() - 1) % legs.size()].lead;
    if (room > best) {
      best = room;
      longest = i;
    }
  }
  const double along = legs.empty() ? 0.0 : legs[longest].length - legs[longest].lead - std::max(0.0, best) * 0.25;
  double offset = 0.0;
  for (int i = 0; i < kMostLaps && corners.size() > 1; ++i) {
    Lap lap(corners, legs, longest, along, offset);
    for (std::size_t leg = 0; leg < legs.size(); ++leg) {
      lap.flyLeg();
    }
    if (std::abs(lap.offset() - offset) <= kSameOffset && lap.along() <= along + kSameOffset) {
      lap.flyStraight(along - lap.along());
      return lap.path();
    }
    offset = lap.offset();
  }
  return fail(Errc::OutOfRange, "the turns of the tour follow each other too closely to be flown from waypoint to waypoint");
}

FlownPath flyOpen(const geo::Pose& start, const std::vector<Corner>& corners) {
  // A leg of no length on the start's heading first, so that the turn onto the first real leg is a turn like all others.
  std::vector<Corner> all{corners.front(), corners.front()};
  all[0].point = all[1].point = start.point();
  all.insert(all.end(), corners.begin(), corners.end());
  std::vector<Leg> legs = legsOf(all);
  legs[0].heading = start.heading;
  legs[0].turn = wrap(legs[1].heading - start.heading);
  legs[0].lead = all[1].radius * std::tan(std::min(std::abs(legs[0].turn), 3.0) / 2.0);
  legs[all.size() - 2].turn = legs[all.size() - 2].lead = 0.0;
  legs.back().heading = legs[all.size() - 2].heading;
  Lap lap(all, legs, 0, 0.0, 0.0);
  for (std::size_t leg = 0; leg + 1 < all.size(); ++leg) {
    lap.flyLeg();
  }
  FlownPath path = lap.path();
  path.passed.erase(path.passed.begin(), path.passed.begin() + 2);
  path.turned.erase(path.turned.begin(), path.turned.begin() + 2);
  path.first = 0;
  return path;
}

FlownPath flyOn(const geo::Pose& start, const std::vector<Corner>& corners) {
  std::vector<Leg> legs = legsOf(corners);
  const std::size_t last = corners.size() - 2;
  legs[last].turn = legs[last].lead = 0.0;
  legs.back().heading = legs[last].heading;
  const double dx = start.x - corners[0].point.x;
  const double dy = start.y - corners[0].point.y;
  const double cosine = std::cos(legs[0].heading);
  const double sine = std::sin(legs[0].heading);
  Lap lap(corners, legs, 0, dx * cosine + dy * sine, dy * cosine - dx * sine);
  for (std::size_t leg = 0; leg <= last; ++leg) {
    lap.flyLeg();
  }
  FlownPath path = lap.path();
  path.first = 0;
  return path;
}

FlownPath partOf(const FlownPath& path, double from, double to) {
  FlownPath part;
  part.start = poseOn(path, from);
  double begin = 0.0;
  for (const flight::Piece& piece : path.pieces) {
    const double length = std::min(begin + piece.length, to) - std::max(begin, from);
    if (length > 0.0) {
      part.pieces.push_back({piece.turn, piece.radius, length});
      part.length += length;
    }
    begin += piece.length;
  }
  return part;
}

geo::Pose poseOn(const FlownPath& path, double distance) {
  geo::Pose pose = path.start;
  double left = distance;
  for (const flight::Piece& piece : path.pieces) {
    if (left <= piece.length) {
      return flight::poseAfter(pose, piece, left);
    }
    pose = flight::endOf(pose, piece);
    left -= piece.length;
  }
  return pose;
}

}  // namespace vp::route
