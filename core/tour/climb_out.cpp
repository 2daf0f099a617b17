#include "core/tour/climb_out.h"

#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"
#include "core/landing/glide_straightener.h"
#include "core/landing/required_height.h"
#include "core/tour/home_path.h"

#include <algorithm>
#include <cmath>

namespace vp::tour {

std::array<Circle, 2> circlesAt(const landing::World& world, const geo::Pose& pose) {
  std::array<Circle, 2> circles;
  const double radius = world.glide.tourRadius();
  const double length = 2.0 * Angle::kPi * radius;
  for (std::size_t side = 0; side < circles.size(); ++side) {
    const flight::Turn turn = side == 0 ? flight::Turn::Left : flight::Turn::Right;
    circles[side] = {turn, radius, length, landing::maxTerrainAlong(world.terrain, pose, {turn, radius, length})};
  }
  if (circles[1].ground < circles[0].ground) {
    std::swap(circles[0], circles[1]);
  }
  return circles;
}

double ClimbOut::leastAltitude() const {
  return std::max(elevation_, circle_.ground + world_.clearance);
}

double ClimbOut::circlesUpTo(double altitude) const {
  return std::ceil((altitude - elevation_) / (settings_.pitch.climb * circle_.length));
}

void ClimbOut::append(double top, mission::HomePath& path) const {
  const int circles = static_cast<int>(circlesUpTo(top));
  const int parts = std::max(3, static_cast<int>(std::ceil(circle_.length / settings_.step)));
  const flight::Piece part{circle_.turn, circle_.radius, circle_.length / parts};
  for (int i = 0; i < circles * parts; ++i) {
    const geo::Pose pose = flight::poseAfter(end_, {part.turn, part.radius, circle_.length}, part.length * (i % parts));
    mission::DecisionPoint point;
    point.pose = pose;
    point.altitude = std::min(top, elevation_ + settings_.pitch.climb * part.length * i);
    point.onward = part;
    path.points.push_back(std::move(point));
  }
}

void ClimbOut::findGuarantee(const landing::Roadmap& roadmap, mission::HomePath& path) const {
  landing::QueryScratch scratch;
  const landing::GlideStraightener straightener(world_);
  auto first = static_cast<std::size_t>(path.guaranteed);
  while (first > 0) {
    const mission::DecisionPoint& next = path.points[first];
    mission::DecisionPoint& point = path.points[first - 1];
    const auto answer = roadmap.query(world_, point.pose, scratch);
    const double ground = landing::maxTerrainAlong(world_.terrain, point.pose, point.onward) + world_.clearance;
    const double needed = flight::mostHeightBefore(world_.glide, point.pose, point.onward, std::max(next.safeAltitude, ground + world_.reactionLoss),
                                                   world_.reactionLoss);
    const bool isSafe = answer && point.altitude > elevation_ && point.altitude >= std::max({answer->altitude, needed, ground});
    if (!isSafe) {
      break;
    }
    // above the circle flown before, on the runway nothing is flown
    const flight::Piece before = first > 1 ? path.points[first - 2].onward : flight::Piece();
    auto [pieces, safeAltitude] =
        straightener.improved(point.pose, before, {roadmap.witnessPieces(*answer), answer->altitude}, answer->site, point.altitude);
    if (safeAltitude > point.altitude) {
      break;
    }
    point.safeAltitude = safeAltitude;
    point.witness = {answer->site, std::move(pieces)};
    --first;
  }
  path.guaranteed = static_cast<int>(first);
}

bool ClimbOut::isClear(const mission::HomePath& path) const {
  double distance = 0.0;
  for (int i = 0; i < path.guaranteed; ++i) {
    const mission::DecisionPoint& point = path.points[static_cast<std::size_t>(i)];
    const double next = distance + point.onward.length;
    const double ground = landing::maxTerrainAlong(world_.terrain, point.pose, point.onward);
    if (next > kAirfieldEnvironment && !(point.altitude >= ground + std::min(world_.clearance, kDepartureClearancePerMetre * next))) {
      return false;
    }
    distance = next;
  }
  return true;
}

}  // namespace vp::tour
