#include "core/emergency/weather/visibility_graph.h"

#include <algorithm>
#include <utility>

namespace vp::emergency {
namespace {

constexpr std::size_t kNearest = 100;  // [4] section 2.1: "start and end vertices are connected to their 100 nearest neighbors"

/// The corners nearest to a place.
std::vector<int> nearestOf(geo::Point place, const std::vector<WeatherCorner>& corners) {
  std::vector<std::pair<double, int>> byDistance;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    byDistance.emplace_back(geo::distance(place, corners[i].place), static_cast<int>(i));
  }
  std::sort(byDistance.begin(), byDistance.end());
  byDistance.resize(std::min(byDistance.size(), kNearest));
  std::vector<int> nearest;
  nearest.reserve(byDistance.size());
  for (const auto& [distance, corner] : byDistance) {
    nearest.push_back(corner);
  }
  return nearest;
}

void addOnce(std::vector<int>& edges, int to) {
  if (std::find(edges.begin(), edges.end(), to) == edges.end()) {
    edges.push_back(to);
  }
}

}  // namespace

WeatherRoadmap layeredRoadmap(const RoadmapTask& task, bool hasDynamics) {
  WeatherRoadmap roadmap = bareRoadmap(task);
  const std::vector<WeatherCorner> corners = cornersOf(task);
  const std::size_t first = roadmap.vertices.size();
  roadmap.edges = visibleEdges(task, corners, false);
  for (const int corner : nearestOf(task.request.pose.point(), corners)) {
    addOnce(roadmap.edges[0], static_cast<int>(first) + corner);
  }
  for (std::size_t goal = 0; goal < roadmap.goals; ++goal) {
    const auto gate = static_cast<int>(1 + goal);
    addOnce(roadmap.edges[0], gate);
    for (const int corner : nearestOf(roadmap.vertices[1 + goal].pose.point(), corners)) {
      addOnce(roadmap.edges[first + static_cast<std::size_t>(corner)], gate);
    }
  }
  roadmap.altitude = EdgeAltitude::Layers;
  roadmap.hasDynamics = hasDynamics;
  if (hasDynamics) {
    const std::vector<RoadmapVertex> poses = tangentPoses(corners);
    roadmap.edges = edgesWithHeadings(roadmap.edges, roadmap.goals, poses);
    roadmap.vertices.insert(roadmap.vertices.end(), poses.begin(), poses.end());
    return roadmap;
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    roadmap.vertices.push_back({{corners[i].place.x, corners[i].place.y, 0.0}, 0.0, static_cast<int>(i)});
  }
  return roadmap;
}

}  // namespace vp::emergency
