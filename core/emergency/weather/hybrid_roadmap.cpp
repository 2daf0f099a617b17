#include "core/emergency/weather/visibility_graph.h"

#include <cmath>

namespace vp::emergency {

WeatherRoadmap hybridRoadmap(const RoadmapTask& task) {
  WeatherRoadmap roadmap = bareRoadmap(task);
  roadmap.altitude = EdgeAltitude::Intervals;
  const std::vector<WeatherCorner> corners = cornersOf(task);
  const std::size_t first = roadmap.vertices.size();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    roadmap.vertices.push_back({{corners[i].place.x, corners[i].place.y, 0.0}, 0.0, static_cast<int>(i)});
  }
  roadmap.edges.resize(roadmap.vertices.size());
  Sight sight(task);
  const auto isTangent = [](const WeatherCorner& corner, geo::Point from, geo::Point to) {
    return isLocallyTangent(corner, std::atan2(to.y - from.y, to.x - from.x));
  };
  const geo::Point start = task.request.pose.point();
  for (std::size_t goal = 0; goal < roadmap.goals; ++goal) {
    roadmap.edges[0].push_back(static_cast<int>(1 + goal));
  }
  for (std::size_t i = 0; i < corners.size() && !task.countdown.isOver(); ++i) {
    const WeatherCorner& one = corners[i];
    if (isTangent(one, start, one.place) && !sight.crosses(start, one.place, one.cell, one.cell)) {
      roadmap.edges[0].push_back(static_cast<int>(first + i));
    }
    for (std::size_t goal = 0; goal < roadmap.goals; ++goal) {
      const geo::Point gate = roadmap.vertices[1 + goal].pose.point();
      if (isTangent(one, one.place, gate) && !sight.crosses(one.place, gate, one.cell, one.cell)) {
        roadmap.edges[first + i].push_back(static_cast<int>(1 + goal));
      }
    }
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      const WeatherCorner& other = corners[j];
      if (isTangent(one, one.place, other.place) && isTangent(other, one.place, other.place) &&
          !sight.crosses(one.place, other.place, one.cell, other.cell)) {
        roadmap.edges[first + i].push_back(static_cast<int>(first + j));
        roadmap.edges[first + j].push_back(static_cast<int>(first + i));
      }
    }
  }
  return roadmap;
}

}  // namespace vp::emergency
