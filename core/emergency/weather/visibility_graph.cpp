#include "core/emergency/weather/visibility_graph.h"

#include "core/base/quantity.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::emergency {
namespace {

constexpr double kOutside = 10.0;   // m
constexpr double kSameSide = 1e-9;  // of the product of lengths: sides along the line are on both of its sides
constexpr double kInfinite = std::numeric_limits<double>::infinity();

double cross(geo::Point origin, geo::Point a, geo::Point b) {
  return (a.x - origin.x) * (b.y - origin.y) - (a.y - origin.y) * (b.x - origin.x);
}

double signedArea(const risk::Ring& ring) {
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    twice += cross(ring[0], ring[i], ring[i + 1]);
  }
  return 0.5 * twice;
}

/// Whether a glide over a place still reaches a gate, by the least that it loses.
bool isUseful(const RoadmapTask& task, geo::Point place) {
  const aircraft::GlideModel& glide = task.flight.world().glide;
  const geo::Pose& start = task.request.pose;
  const double altitude = task.request.altitude - glide.leastLossOver(place.x - start.x, place.y - start.y);
  return std::any_of(task.goals.inRange().begin(), task.goals.inRange().end(), [&](const LandingGoal& goal) {
    const geo::Pose& gate = goal.approach.gate;
    return altitude - glide.leastLossOver(gate.x - place.x, gate.y - place.y) >= goal.approach.altitude;
  });
}

}  // namespace

std::vector<WeatherCorner> cornersOf(const RoadmapTask& task) {
  const risk::Weather& weather = task.flight.weather();
  const geo::Box extent = task.flight.world().terrain.grid().extent();
  std::vector<WeatherCorner> corners;
  for (std::size_t cell = 0; cell < weather.size(); ++cell) {
    const risk::Ring& ring = weather.cell(cell).ring;
    const double turn = signedArea(ring) > 0.0 ? 1.0 : -1.0;
    for (std::size_t i = 0; i < ring.size() && weather.cell(cell).rate > 0.0; ++i) {
      WeatherCorner corner{{}, ring[i], ring[(i + ring.size() - 1) % ring.size()], ring[(i + 1) % ring.size()], 0.0, cell};
      if (turn * cross(corner.before, corner.corner, corner.after) <= 0.0) {
        continue;
      }
      const double in = geo::distance(corner.before, corner.corner);
      const double out = geo::distance(corner.corner, corner.after);
      const double east = (corner.corner.x - corner.before.x) / in + (corner.corner.x - corner.after.x) / out;
      const double north = (corner.corner.y - corner.before.y) / in + (corner.corner.y - corner.after.y) / out;
      corner.outward = std::atan2(north, east);
      corner.place = {corner.corner.x + kOutside * std::cos(corner.outward), corner.corner.y + kOutside * std::sin(corner.outward)};
      if (extent.contains(corner.place) && isUseful(task, corner.place)) {
        corners.push_back(corner);
      }
    }
  }
  return corners;
}

bool isLocallyTangent(const WeatherCorner& corner, double course) {
  const auto side = [&](geo::Point other) {
    const double length = geo::distance(corner.corner, other);
    return (std::cos(course) * (other.y - corner.corner.y) - std::sin(course) * (other.x - corner.corner.x)) / length;
  };
  const double before = side(corner.before);
  const double after = side(corner.after);
  // the place is ten metres beside the corner, which turns the line along a side by a little
  const double slack = kSameSide + kOutside / std::min(geo::distance(corner.corner, corner.before), geo::distance(corner.corner, corner.after));
  return before * after >= 0.0 || std::min(std::abs(before), std::abs(after)) <= slack;
}

Sight::Sight(const RoadmapTask& task) : task_(task), isIgnored_(task.flight.weather().size(), false) {
  const risk::Weather& weather = task.flight.weather();
  for (std::size_t cell = 0; cell < weather.size(); ++cell) {
    bool holds = weather.shareAt(cell, task.request.pose.point()) > 0.0;
    for (const LandingGoal& goal : task.goals.inRange()) {
      holds = holds || weather.shareAt(cell, goal.approach.gate.point()) > 0.0;
    }
    isIgnored_[cell] = holds;
  }
}

bool Sight::isFree(geo::Point from, geo::Point to) {
  const flight::Piece line{flight::Turn::Straight, 0.0, geo::distance(from, to)};
  task_.flight.weather().along({from.x, from.y, std::atan2(to.y - from.y, to.x - from.x)}, line, -kInfinite, kInfinite, stretches_);
  return std::all_of(stretches_.begin(), stretches_.end(), [this](const risk::WeatherStretch& stretch) { return isIgnored_[stretch.cell]; });
}

bool Sight::crosses(geo::Point from, geo::Point to, std::size_t one, std::size_t other) {
  const flight::Piece line{flight::Turn::Straight, 0.0, geo::distance(from, to)};
  task_.flight.weather().along({from.x, from.y, std::atan2(to.y - from.y, to.x - from.x)}, line, -kInfinite, kInfinite, stretches_);
  return std::any_of(stretches_.begin(), stretches_.end(), [&](const risk::WeatherStretch& stretch) {
    return (stretch.cell == one || stretch.cell == other) && !isIgnored_[stretch.cell];
  });
}

std::vector<std::vector<int>> visibleEdges(const RoadmapTask& task, const std::vector<WeatherCorner>& corners, bool tangentOnly) {
  Sight sight(task);
  const std::size_t goals = task.goals.inRange().size();
  const std::size_t first = 1 + goals;
  std::vector<std::vector<int>> edges(first + corners.size());
  const auto isAllowed = [&](const WeatherCorner& corner, geo::Point from, geo::Point to) {
    return !tangentOnly || isLocallyTangent(corner, std::atan2(to.y - from.y, to.x - from.x));
  };
  const geo::Point start = task.request.pose.point();
  for (std::size_t i = 0; i < goals; ++i) {
    if (sight.isFree(start, task.goals.inRange()[i].approach.gate.point())) {
      edges[0].push_back(static_cast<int>(1 + i));
    }
  }
  for (std::size_t i = 0; i < corners.size() && !task.countdown.isOver(); ++i) {
    const geo::Point place = corners[i].place;
    if (isAllowed(corners[i], start, place) && sight.isFree(start, place)) {
      edges[0].push_back(static_cast<int>(first + i));
    }
    for (std::size_t goal = 0; goal < goals; ++goal) {
      const geo::Point gate = task.goals.inRange()[goal].approach.gate.point();
      if (isAllowed(corners[i], place, gate) && sight.isFree(place, gate)) {
        edges[first + i].push_back(static_cast<int>(1 + goal));
      }
    }
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      const geo::Point other = corners[j].place;
      if (isAllowed(corners[i], place, other) && isAllowed(corners[j], place, other) && sight.isFree(place, other)) {
        edges[first + i].push_back(static_cast<int>(first + j));
        edges[first + j].push_back(static_cast<int>(first + i));
      }
    }
  }
  return edges;
}

std::vector<RoadmapVertex> tangentPoses(const std::vector<WeatherCorner>& corners) {
  std::vector<RoadmapVertex> poses;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (const double side : {0.5, -0.5}) {
      poses.push_back({{corners[i].place.x, corners[i].place.y, corners[i].outward + side * Angle::kPi}, 0.0, static_cast<int>(i)});
    }
  }
  return poses;
}

std::vector<std::vector<int>> edgesWithHeadings(const std::vector<std::vector<int>>& edges, std::size_t goals,
                                                const std::vector<RoadmapVertex>& poses) {
  const std::size_t first = 1 + goals;
  std::vector<std::vector<int>> all(first + poses.size());
  const auto posesOf = [&](int vertex, std::vector<int>& out) {
    out.clear();
    const auto at = static_cast<std::size_t>(vertex);
    if (at < first) {
      out.push_back(vertex);
      return;
    }
    for (std::size_t side = 0; side < 2; ++side) {
      out.push_back(static_cast<int>(first + 2 * (at - first) + side));
    }
  };
  std::vector<int> froms;
  std::vector<int> tos;
  for (std::size_t vertex = 0; vertex < edges.size(); ++vertex) {
    posesOf(static_cast<int>(vertex), froms);
    for (const int to : edges[vertex]) {
      posesOf(to, tos);
      for (const int a : froms) {
        for (const int b : tos) {
          const bool areCorners = static_cast<std::size_t>(a) >= first && static_cast<std::size_t>(b) >= first;
          const auto headingOf = [&](int one) { return poses[static_cast<std::size_t>(one) - first].pose.heading; };
          if (!areCorners || std::abs(wrapPi(headingOf(a) - headingOf(b))) < 0.5 * Angle::kPi) {
            all[static_cast<std::size_t>(a)].push_back(b);
          }
        }
      }
    }
  }
  return all;
}

WeatherRoadmap bareRoadmap(const RoadmapTask& task) {
  WeatherRoadmap roadmap;
  roadmap.goals = task.goals.inRange().size();
  roadmap.vertices.push_back({task.request.pose, 0.0, -1});
  for (const LandingGoal& goal : task.goals.inRange()) {
    roadmap.vertices.push_back({goal.approach.gate, 0.0, -1});
  }
  return roadmap;
}

WeatherRoadmap visibilityRoadmap(const RoadmapTask& task, bool tangentOnly) {
  WeatherRoadmap roadmap = bareRoadmap(task);
  const std::vector<WeatherCorner> corners = cornersOf(task);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    roadmap.vertices.push_back({{corners[i].place.x, corners[i].place.y, 0.0}, 0.0, static_cast<int>(i)});
  }
  roadmap.edges = visibleEdges(task, corners, tangentOnly);
  return roadmap;
}

}  // namespace vp::emergency
