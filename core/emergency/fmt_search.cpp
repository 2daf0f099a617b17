#include "core/emergency/fmt_search.h"

#include "core/base/quantity.h"
#include "core/emergency/deadline_job.h"
#include "core/emergency/glide_space.h"
#include "core/emergency/landing_outcome.h"
#include "core/emergency/octree_ground.h"
#include "core/flight/curve_sampling.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::emergency {
namespace {

/// Gates that one tree's ways are made flyable to, the cheapest first.
constexpr int kMostGates = 4;
/// How far from the best glide the second sampling reaches, in radii of connection of the first: where that one could have had another sample.
constexpr double kReach = 0.5;
/// Samples near the best glide are joined over that many times their distance from it: long legs keep ways from staggering.
constexpr double kLong = 4.0;
/// Cells of an octree that is made for one request, along east, north and up: some ten milliseconds.
constexpr std::array<int, 3> kCells{512, 512, 256};
/// Poses that lead the glide on to a gate's course, or away from the aircraft [glide radii].
constexpr std::array<double, 2> kLead{3.0, 6.0};

}  // namespace

FmtSearch::FmtSearch(const LandingRequest& request, const LandingGoals& goals, const FmtOptions& options, const Countdown& countdown)
    : request_(request),
      world_(*request.world),
      goals_(goals),
      options_(options),
      countdown_(countdown),
      flight_(world_),
      smoothing_(world_, goals_, flight_),
      samples_(world_, goals, request.pose, request.altitude, request.seed) {}

bool FmtSearch::isFinished() const {
  return samples_.isEmpty() || (bestPath_ && request_.altitude - goals_.inRange().front().least - inHand_ < kWorthwhile);
}

void FmtSearch::tryDirect() {
  for (std::size_t goal = 0; goal < goals_.inRange().size() && !countdown_.isOver(); ++goal) {
    if (request_.altitude - goals_.inRange()[goal].least <= wanted()) {
      return;
    }
    consider(goal, {});
  }
}

void FmtSearch::run(int round) {
  const std::shared_ptr<const LinearOctree> octree = options_.usesOctree ? makeOctree(round % 2 == 0) : nullptr;
  if (countdown_.isOver() || (options_.usesOctree && octree == nullptr)) {
    return;
  }
  const std::size_t count = options_.first << static_cast<unsigned>(round);
  double measure = 0.0;
  const std::vector<geo::Point> samples = firstSamples(count, measure);
  const double radius = fmtRadius(2, measure, samples.size());
  grow(samples, radius, octree.get());
  if (bestPath_ && options_.usesOctree) {
    double reach = kReach * radius;
    for (int i = 0; i < options_.further && !countdown_.isOver() && !isFinished(); ++i, reach *= 0.5) {
      refine(reach, octree.get());
    }
  }
  if (bestPath_ && !isFinished()) {
    SmoothGlide polished = best_;
    smoothing_.polish(request_.pose, request_.altitude, goals_.inRange()[bestGoal_].approach.gate, polished, kReach * radius, options_.tries,
                      request_.seed, [this] { return countdown_.isOver(); });
    if (polished.altitude > best_.altitude) {
      accept(bestGoal_, polished);
    }
  }
}

/// Over all that glides may reach; null: there was not the time for it.
std::shared_ptr<const LinearOctree> FmtSearch::makeOctree(bool enlarged) {
  if (options_.octree != nullptr && enlarged) {
    return options_.octree;
  }
  const terrain::ElevationGrid& grid = world_.terrain.grid();
  const geo::Box extent = grid.extent();
  const double reach = (request_.altitude - goals_.lowestGate()) / world_.glide.leastLoss();
  OctreeGround ground;
  ground.area = {std::max(extent.minX, request_.pose.x - reach), std::max(extent.minY, request_.pose.y - reach),
                 std::min(extent.maxX, request_.pose.x + reach), std::min(extent.maxY, request_.pose.y + reach)};
  // nothing on the way is below the lowest gate, nothing above where the glide begins
  ground.lowest = goals_.lowestGate();
  ground.highest = request_.altitude;
  ground.mostCells = kCells;
  ground.leastCell = grid.cellSize();
  ground.clearance = world_.clearance;
  ground.enlarge = enlarged ? world_.glide.glideRadii().back() : 0.0;
  if (!(ground.highest - ground.lowest > 1e-3) || !(ground.area.maxX - ground.area.minX > 1e-3) || !(ground.area.maxY - ground.area.minY > 1e-3)) {
    return nullptr;
  }
  const DeadlineJob timed(request_, countdown_);
  Result<LinearOctree> octree = octreeOver(grid, ground, timed.job());
  if (!octree) {
    return nullptr;
  }
  counts_.leaves += static_cast<std::int64_t>(octree->leaves());
  return std::make_shared<const LinearOctree>(std::move(*octree));
}

/// Over known ground that the aircraft can be high enough above; and where courses of start and gates want the way to turn.
std::vector<geo::Point> FmtSearch::firstSamples(std::size_t count, double& measure) {
  std::vector<geo::Point> points;
  const terrain::ElevationGrid& grid = world_.terrain.grid();
  const auto add = [&](geo::Point p) {
    const double most = request_.altitude - world_.glide.leastLossOver(p.x - request_.pose.x, p.y - request_.pose.y);
    if (most >= grid.upperAt(p) + world_.clearance) {
      points.push_back(p);
    }
  };
  const double radius = world_.glide.glideRadii().front();
  const auto addAlong = [&](const geo::Pose& pose, double length) {
    add({pose.x + length * std::cos(pose.heading), pose.y + length * std::sin(pose.heading)});
  };
  for (const double lead : kLead) {
    addAlong(request_.pose, lead * radius);
    for (const LandingGoal& goal : goals_.inRange()) {
      addAlong(goal.approach.gate, -lead * radius);
    }
  }
  // where most is too high or unknown ground, fewer samples are enough for what is left
  constexpr std::size_t kPolled = 512;
  std::size_t drawn = 0;
  for (; drawn < 4 * count && points.size() < count && !(drawn % kPolled == 0 && countdown_.isOver()); ++drawn) {
    add(samples_.next().point());
  }
  counts_.samples += static_cast<std::int64_t>(points.size());
  // the radius is for the space that samples lie in, not for all of what was drawn from: else each would be near all others
  measure = samples_.area() * static_cast<double>(points.size() + 1) / static_cast<double>(std::max(drawn, points.size()) + 1);
  return points;
}

std::vector<geo::Point> FmtSearch::samplesNearBest(double reach, std::size_t count) {
  std::vector<geo::Point> points;
  for (const geo::Pose& pose : best_.poses) {
    points.push_back(pose.point());
  }
  const double length = lengthOf(*bestPath_);
  for (std::size_t i = 0; i < count; ++i) {
    double along = length * samples_.unit();
    geo::Pose pose = bestPath_->start;
    for (const mission::LandingLeg& leg : bestPath_->legs) {
      pose = flight::poseAfter(pose, leg.piece, std::min(along, leg.piece.length));
      along -= leg.piece.length;
      if (along <= 0.0) {
        break;
      }
    }
    points.push_back(samples_.near(pose, reach).point());
  }
  counts_.samples += static_cast<std::int64_t>(count);
  return points;
}

void FmtSearch::refine(double reach, const LinearOctree* octree) {
  const double measure = 2.0 * reach * lengthOf(*bestPath_) + Angle::kPi * reach * reach;
  const double radius = std::max(kLong * reach, fmtRadius(2, measure, options_.second));
  grow(samplesNearBest(reach, options_.second), radius, octree);
}

/// One tree over samples; its ways to the cheapest gates are made flyable.
void FmtSearch::grow(const std::vector<geo::Point>& samples, double radius, const LinearOctree* octree) {
  const GlideSpace space(request_, goals_, samples, radius, octree, wanted());
  FmtStar tree(space, [this] { return countdown_.isOver(); });
  for (int gates = 0; gates < kMostGates; ++gates) {
    const int gate = tree.next(request_.altitude - goals_.lowestGate() - wanted());
    if (gate < 0) {
      break;
    }
    std::vector<geo::Point> points;
    for (const int node : tree.wayTo(gate)) {
      if (node != 0 && node != gate) {
        points.push_back(space.at(node));
      }
    }
    consider(GlideSpace::goalOf(gate), points);
  }
  counts_.visited += tree.counts().visited;
  counts_.tested += tree.counts().tested;
}

void FmtSearch::consider(std::size_t goal, const std::vector<geo::Point>& points) {
  const landing::Approach& approach = goals_.inRange()[goal].approach;
  ++counts_.smoothed;
  const std::optional<SmoothGlide> glide =
      smoothing_.smooth(request_.pose, request_.altitude, points, approach.gate, approach.altitude + wanted() - (bestPath_ ? 0.0 : 1e-9));
  if (glide) {
    accept(goal, *glide);
  }
}

bool FmtSearch::accept(std::size_t goal, const SmoothGlide& glide) {
  const landing::Approach& approach = goals_.inRange()[goal].approach;
  std::vector<mission::LandingLeg> legs;
  geo::Pose pose = request_.pose;
  const double altitude = flight_.fly(pose, request_.altitude, landing::joinedGlide(world_, {}, glide.pieces), &legs);
  if (altitude <= GlideFlight::kTouches || (bestPath_ && altitude - approach.altitude <= inHand_)) {
    return false;
  }
  std::optional<mission::LandingPath> path = withApproach(request_, approach, std::move(legs), altitude);
  if (!path) {
    return false;
  }
  bestPath_ = std::move(path);
  best_ = glide;
  bestGoal_ = goal;
  inHand_ = altitude - approach.altitude;
  samples_.narrow(inHand_);
  ++counts_.improved;
  return true;
}

}  // namespace vp::emergency
