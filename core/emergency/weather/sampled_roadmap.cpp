#include "core/emergency/informed_samples.h"
#include "core/emergency/weather/visibility_graph.h"

#include <algorithm>
#include <cmath>

namespace vp::emergency {
namespace {

constexpr std::size_t kMostTries = 30;  // samples drawn for each that is kept
constexpr double kNearBest = 0.5;       // share of samples near the best way, as soon as there is one
constexpr double kNear = 0.15;          // how far from it at most, of the distance from start to gate

/// A pose somewhere on the way from start by poses to a gate.
geo::Pose somewhereOn(const RoadmapTask& task, InformedSamples& samples) {
  std::vector<geo::Pose> way{task.request.pose};
  way.insert(way.end(), task.way->begin(), task.way->end());
  const auto leg = static_cast<std::size_t>(samples.unit() * static_cast<double>(way.size() - 1));
  const double part = samples.unit();
  const geo::Pose& a = way[leg];
  const geo::Pose& b = way[leg + 1];
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y), std::atan2(b.y - a.y, b.x - a.x)};
}

void addSamples(const RoadmapTask& task, WeatherRoadmap& roadmap) {
  const landing::World& world = task.flight.world();
  InformedSamples samples(world, task.goals, task.request.pose, task.request.altitude, task.seed);
  const bool hasWay = task.way != nullptr && !task.way->empty();
  const double reach = hasWay ? kNear * geo::distance(task.request.pose.point(), task.way->back().point()) : 0.0;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < kMostTries * task.samples && kept < task.samples && !samples.isEmpty(); ++i) {
    const bool isNear = hasWay && samples.unit() < kNearBest;
    const geo::Pose pose = isNear ? samples.near(somewhereOn(task, samples), reach * samples.unit()) : samples.next();
    // half of the legs at the best glide, the others as steep as it comes
    const double steep = std::max(0.0, 2.0 * samples.unit() - 1.0);
    const double most = task.request.altitude - task.goals.leastLoss(task.request.pose, pose);
    if (most < world.terrain.grid().upperAt(pose.point()) + world.clearance || most < task.goals.leastFrom(pose)) {
      continue;  // unknown ground too
    }
    roadmap.vertices.push_back({pose, steep, -1});
    ++kept;
  }
}

}  // namespace

WeatherRoadmap sampledRoadmap(const RoadmapTask& task, bool hasDynamics) {
  WeatherRoadmap roadmap = bareRoadmap(task);
  roadmap.hasDynamics = hasDynamics;
  roadmap.nearest = task.nearest;
  addSamples(task, roadmap);
  return roadmap;
}

WeatherRoadmap seededRoadmap(const RoadmapTask& task, bool hasDynamics) {
  WeatherRoadmap roadmap = layeredRoadmap(task, hasDynamics);
  roadmap.nearest = task.nearest;
  addSamples(task, roadmap);
  roadmap.edges.resize(roadmap.vertices.size());
  return roadmap;
}

}  // namespace vp::emergency
