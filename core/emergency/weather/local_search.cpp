#include "core/emergency/weather/local_search.h"

#include "core/base/quantity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vp::emergency {
namespace {

constexpr double kSpacing = 3704.0;         // m, [4] section 2.2: waypoints are added "every two nautical miles"
constexpr double kWorthwhile = 0.01;        // of the cost: "as long as the path improves by more than a certain percentage (1%)"
constexpr std::size_t kMostPoints = 60;     // of a divided way, so that short and long ones take as long
constexpr std::size_t kMostWaypoints = 16;  // of a way that courses are chosen for
constexpr double kOff = 0.35;               // rad: courses beside the middle one
constexpr int kRounds = 4;

double courseTo(geo::Point from, geo::Point to) {
  return std::atan2(to.y - from.y, to.x - from.x);
}

/// Start, gate and points of a way in their order; edges lead forwards.
WeatherRoadmap forwardRoadmap(const RoadmapTask& task, std::size_t goal) {
  WeatherRoadmap roadmap = bareRoadmap(task);
  roadmap.edges.resize(roadmap.vertices.size());
  roadmap.edges[0].push_back(static_cast<int>(1 + goal));
  return roadmap;
}

/// The straight ways over some of the points that are the best. @param legs  which leg of the undivided way each point lies on
std::vector<std::size_t> bestOf(const RoadmapTask& task, const std::vector<geo::Point>& points, const std::vector<std::size_t>& legs,
                                std::size_t goal, double& cost, RoadmapCount& count) {
  WeatherRoadmap roadmap = forwardRoadmap(task, goal);
  const std::size_t first = roadmap.vertices.size();
  for (const geo::Point& point : points) {
    roadmap.vertices.push_back({{point.x, point.y, 0.0}, 0.0, -1});
  }
  roadmap.edges.resize(roadmap.vertices.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    roadmap.edges[0].push_back(static_cast<int>(first + i));
    roadmap.edges[first + i].push_back(static_cast<int>(1 + goal));
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      // points in line beyond the next are had by leaving out the next
      if (legs[i] != legs[j] || j == i + 1) {
        roadmap.edges[first + i].push_back(static_cast<int>(first + j));
      }
    }
  }
  RoadmapSearch search(task, roadmap, count);
  const std::optional<RoadmapWay> way = search.next();
  std::vector<std::size_t> kept;
  cost = way ? way->cost : -1.0;
  if (way) {
    for (const int vertex : way->vertices) {
      kept.push_back(static_cast<std::size_t>(vertex) - first);
    }
  }
  return kept;
}

}  // namespace

std::vector<geo::Pose> posesAt(const geo::Pose& start, const std::vector<geo::Point>& points, const geo::Pose& gate) {
  std::vector<geo::Pose> poses;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double in = courseTo(i == 0 ? start.point() : points[i - 1], points[i]);
    const double out = courseTo(points[i], i + 1 == points.size() ? gate.point() : points[i + 1]);
    poses.push_back({points[i].x, points[i].y, in + 0.5 * wrapPi(out - in)});
  }
  return poses;
}

std::vector<geo::Point> euclideanSearch(const RoadmapTask& task, std::vector<geo::Point> points, std::size_t goal, RoadmapCount& count) {
  const geo::Point start = task.request.pose.point();
  const geo::Point gate = task.goals.inRange()[goal].approach.gate.point();
  double best = -1.0;
  for (int round = 0; round < kRounds && !task.countdown.isOver(); ++round) {
    std::vector<geo::Point> divided;
    std::vector<std::size_t> legs;
    double length = 0.0;
    geo::Point from = start;
    for (std::size_t i = 0; i <= points.size(); ++i) {
      length += geo::distance(from, i == points.size() ? gate : points[i]);
      from = i == points.size() ? gate : points[i];
    }
    const double spacing = std::max(std::min(kSpacing, length / 20.0), length / static_cast<double>(kMostPoints));
    from = start;
    for (std::size_t i = 0; i <= points.size(); ++i) {
      const geo::Point to = i == points.size() ? gate : points[i];
      const int parts = round == 0 ? 1 : std::max(1, static_cast<int>(geo::distance(from, to) / spacing));
      for (int k = 1; k <= parts; ++k) {
        if (k < parts || i < points.size()) {
          const double part = static_cast<double>(k) / parts;
          divided.push_back({from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)});
          legs.push_back(i);
        }
      }
      from = to;
    }
    double cost = 0.0;
    const std::vector<std::size_t> kept = bestOf(task, divided, legs, goal, cost, count);
    if (cost < 0.0) {
      break;
    }
    points.clear();
    for (const std::size_t at : kept) {
      points.push_back(divided[at]);
    }
    if (round > 0 && cost > (1.0 - kWorthwhile) * best) {
      break;
    }
    best = cost;
  }
  return points;
}

std::vector<std::vector<geo::Pose>> dynamicsSearch(const RoadmapTask& task, const std::vector<geo::Point>& points, std::size_t goal,
                                                   RoadmapCount& count) {
  constexpr std::size_t kCourses = 5;
  constexpr int kWays = 3;  // that may be offered, as the altitudes are chosen afterwards
  std::vector<geo::Point> places = points;
  while (places.size() > kMostWaypoints) {  // a way of more is a sampled line: every second tells as much
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      places.erase(places.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  WeatherRoadmap roadmap = forwardRoadmap(task, goal);
  roadmap.hasDynamics = true;
  const std::size_t first = roadmap.vertices.size();
  const geo::Pose& gate = task.goals.inRange()[goal].approach.gate;
  const std::vector<geo::Pose> middle = posesAt(task.request.pose, places, gate);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double in = courseTo(i == 0 ? task.request.pose.point() : places[i - 1], places[i]);
    const double out = courseTo(places[i], i + 1 == places.size() ? gate.point() : places[i + 1]);
    const double course = middle[i].heading;
    for (const double heading : std::array<double, kCourses>{course, in, out, course - kOff, course + kOff}) {
      roadmap.vertices.push_back({{places[i].x, places[i].y, heading}, 0.0, -1});
    }
  }
  roadmap.edges.resize(roadmap.vertices.size());
  for (std::size_t i = first; i < roadmap.vertices.size(); ++i) {
    roadmap.edges[0].push_back(static_cast<int>(i));
    roadmap.edges[i].push_back(static_cast<int>(1 + goal));
    for (std::size_t j = first + kCourses * ((i - first) / kCourses + 1); j < roadmap.vertices.size(); ++j) {
      roadmap.edges[i].push_back(static_cast<int>(j));
    }
  }
  RoadmapSearch search(task, roadmap, count);
  std::vector<std::vector<geo::Pose>> ways;
  for (int i = 0; i < kWays; ++i) {
    const std::optional<RoadmapWay> way = search.next();
    if (!way) {
      break;
    }
    std::vector<geo::Pose> poses;
    for (const int vertex : way->vertices) {
      poses.push_back(roadmap.vertices[static_cast<std::size_t>(vertex)].pose);
    }
    ways.push_back(std::move(poses));
  }
  return ways;
}

}  // namespace vp::emergency
