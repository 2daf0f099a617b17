#include "core/emergency/weather/best_landing.h"

#include "core/emergency/dubins_ways.h"
#include "core/emergency/glide_flight.h"
#include "core/emergency/landing_outcome.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace vp::emergency {
namespace {

double endOf(const std::vector<mission::LandingLeg>& legs, double start) {
  return legs.empty() ? start : legs.back().endAltitude;
}

}  // namespace

double BestLanding::weatherOnApproach(const landing::Approach& approach, double altitude) const {
  std::vector<mission::LandingLeg> legs;
  GlideFlight(flight_.world()).flyApproach(approach, altitude, legs);
  return flight_.weatherAlong(approach.gate, altitude, legs);
}

bool BestLanding::take(std::vector<mission::LandingLeg> legs, double weather, std::size_t goal, const std::vector<geo::Pose>& poses) {
  const landing::Approach& approach = goals_.inRange()[goal].approach;
  const double altitude = endOf(legs, request_.altitude);
  if (altitude < approach.altitude || weather > weather_ + kSame) {
    return false;
  }
  const mission::LandingPath way{request_.pose, request_.altitude, legs, approach.site};
  const double inHand = altitude - approach.altitude - kPerManoeuvre * manoeuvresOf(way);
  if (weather > weather_ - kSame && inHand <= inHand_) {
    return false;
  }
  if (!flight_.descents().isClear(request_.pose, request_.altitude, legs)) {
    return false;
  }
  std::optional<mission::LandingPath> path = withApproach(request_, approach, std::move(legs), altitude);
  if (!path) {
    return false;
  }
  path_ = std::move(path);
  weather_ = weather;
  inHand_ = inHand;
  goal_ = goal;
  poses_ = poses;
  ++improved_;
  return true;
}

bool BestLanding::offerPieces(const std::vector<flight::Piece>& pieces, std::size_t goal, const std::vector<geo::Pose>& poses) {
  ++offered_;
  const landing::Approach& approach = goals_.inRange()[goal].approach;
  std::vector<mission::LandingLeg> legs;
  geo::Pose pose = request_.pose;
  const double end = flight_.descents().fly(pose, request_.altitude, pieces, 0.0, &legs);
  if (!(end >= approach.altitude)) {
    return false;
  }
  const double weather = flight_.weatherAlong(request_.pose, request_.altitude, legs) + weatherOnApproach(approach, end);
  std::optional<std::vector<mission::LandingLeg>> lower;
  if (weather > kSame) {
    lower = flight_.leastWeather(request_.pose, request_.altitude, legs, approach.altitude);
  }
  bool isTaken = take(std::move(legs), weather, goal, poses);
  if (lower) {
    const double less =
        flight_.weatherAlong(request_.pose, request_.altitude, *lower) + weatherOnApproach(approach, endOf(*lower, request_.altitude));
    isTaken = (less < weather - kSame && take(std::move(*lower), less, goal, poses)) || isTaken;
  }
  return isTaken;
}

bool BestLanding::offer(const std::vector<geo::Pose>& poses, std::size_t goal) {
  std::vector<flight::Piece> pieces;
  geo::Pose from = request_.pose;
  for (const geo::Pose& to : poses) {
    flight::appendPieces(flight_.curve(from, to, request_.altitude), pieces);
    from = to;
  }
  flight::appendPieces(flight_.curve(from, goals_.inRange()[goal].approach.gate, request_.altitude), pieces);
  return offerPieces(pieces, goal, poses);
}

void BestLanding::offerDirect(const Countdown& countdown) {
  for (std::size_t goal = 0; goal < goals_.inRange().size() && (goal == 0 || !countdown.isOver()); ++goal) {
    offer({}, goal);
    for (const double radius : flight_.world().glide.glideRadii()) {
      for (std::size_t type = 0; type < kDubinsTypes; ++type) {
        if (const std::optional<Pieces> way = dubinsWay(request_.pose, goals_.inRange()[goal].approach.gate, radius, type)) {
          offerPieces(*way, goal, {});
        }
      }
    }
  }
}

void BestLanding::polish(int tries, std::uint64_t seed, const Countdown& countdown) {
  if (!path_) {
    return;
  }
  constexpr double kMostReach = 0.1;     // of the distance to the gate, first
  constexpr double kLeastReach = 0.001;  // and last
  constexpr int kChecked = 8;            // tries between two looks at the clock
  std::mt19937_64 engine(seed);
  const auto unit = [&engine] { return static_cast<double>(engine() >> 11) * 0x1.0p-53; };
  for (int i = 0; i < tries && (i % kChecked != 0 || !countdown.isOver()); ++i) {
    std::vector<geo::Pose> poses = poses_;
    if (poses.empty()) {
      return;  // a single curve: there is nothing to move
    }
    const double distance = geo::distance(request_.pose.point(), goals_.inRange()[goal_].approach.gate.point());
    const double share = kMostReach * std::pow(kLeastReach / kMostReach, unit());
    const auto at = static_cast<std::size_t>(unit() * static_cast<double>(poses.size()));
    const double kind = unit();
    if (kind < 0.1) {
      poses.erase(poses.begin() + static_cast<std::ptrdiff_t>(at));
    } else if (kind < 0.2) {
      const geo::Pose before = at == 0 ? request_.pose : poses[at - 1];
      const double part = unit();
      const geo::Pose between{before.x + part * (poses[at].x - before.x), before.y + part * (poses[at].y - before.y),
                              std::atan2(poses[at].y - before.y, poses[at].x - before.x)};
      poses.insert(poses.begin() + static_cast<std::ptrdiff_t>(at), between);
    }
    if (kind >= 0.1) {
      geo::Pose& moved = poses[at];
      const double reach = share * distance;
      moved.x += reach * (2.0 * unit() - 1.0);
      moved.y += reach * (2.0 * unit() - 1.0);
      moved.heading += Angle::kPi * std::min(1.0, 4.0 * share) * (2.0 * unit() - 1.0);
    }
    offer(poses, goal_);
  }
}

}  // namespace vp::emergency
