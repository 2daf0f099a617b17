#include "core/emergency/weather/roadmap_search.h"

#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vp::emergency {
namespace {

constexpr double kSameCost = 1e-12;
constexpr double kSameAltitude = 1e-6;       // m
constexpr std::size_t kStatesAtVertex = 24;  // at most, the cheapest of them
constexpr std::size_t kGatesTried = 4;       // from each vertex of a sampled roadmap, the nearest
constexpr double kShortest = 1.0;            // m: edges shorter than this lead nowhere

}  // namespace

RoadmapSearch::RoadmapSearch(const RoadmapTask& task, const WeatherRoadmap& roadmap, RoadmapCount& count)
    : task_(task), roadmap_(roadmap), count_(count), atVertex_(roadmap.vertices.size()) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const aircraft::GlideModel& glide = task.flight.world().glide;
  for (const RoadmapVertex& vertex : roadmap.vertices) {
    double toGo = kInfinite;
    double needed = kInfinite;
    for (const LandingGoal& goal : task.goals.inRange()) {
      const geo::Pose& gate = goal.approach.gate;
      toGo = std::min(toGo, geo::distance(vertex.pose.point(), gate.point()));
      const double loss =
          roadmap.hasDynamics ? task.goals.leastLoss(vertex.pose, gate) : glide.leastLossOver(gate.x - vertex.pose.x, gate.y - vertex.pose.y);
      needed = std::min(needed, goal.approach.altitude + loss);
    }
    toGo_.push_back(toGo);
    needed_.push_back(needed);
  }
  for (std::size_t goal = 0; goal < roadmap.goals; ++goal) {
    needed_[1 + goal] = task.goals.inRange()[goal].approach.altitude;
  }
  count_.vertices += static_cast<std::int64_t>(roadmap.vertices.size());
  push({0, task.request.altitude, task.request.altitude, 0.0, -1, false});
}

bool RoadmapSearch::isLater(const Open& a, const Open& b) {
  if (a.estimate != b.estimate) {
    return a.estimate > b.estimate;
  }
  return a.altitude != b.altitude ? a.altitude < b.altitude : a.state > b.state;
}

std::size_t RoadmapSearch::layerOf(double altitude) const {
  const std::vector<double>& levels = task_.flight.weather().levels();
  return static_cast<std::size_t>(std::upper_bound(levels.begin(), levels.end(), altitude) - levels.begin());
}

/// Whether a state at the same vertex makes another needless.
bool RoadmapSearch::dominates(const State& one, const State& other) const {
  if (one.cost > other.cost + kSameCost || one.high < other.high - kSameAltitude) {
    return false;
  }
  return one.low <= other.low + kSameAltitude || (one.low == one.high && layerOf(one.high) == layerOf(other.high));
}

/// Whether a state is needless. At a gate none is: each is a way of its own that may turn out to be the one that can be flown.
bool RoadmapSearch::isDominated(const State& state) const {
  const std::vector<int>& others = atVertex_[static_cast<std::size_t>(state.vertex)];
  const auto isCheaper = [&](int id) { return states_[static_cast<std::size_t>(id)].cost <= state.cost; };
  return !roadmap_.isGoal(static_cast<std::size_t>(state.vertex)) &&
         ((others.size() >= kStatesAtVertex && std::all_of(others.begin(), others.end(), isCheaper)) ||
          std::any_of(others.begin(), others.end(), [&](int id) { return dominates(states_[static_cast<std::size_t>(id)], state); }));
}

void RoadmapSearch::push(State state) {
  const auto vertex = static_cast<std::size_t>(state.vertex);
  if (!(state.high >= needed_[vertex]) || isDominated(state)) {
    return;
  }
  std::vector<int>& others = atVertex_[vertex];
  if (!roadmap_.isGoal(vertex)) {
    std::erase_if(others, [&](int id) {
      State& other = states_[static_cast<std::size_t>(id)];
      other.isDominated = dominates(state, other);
      return other.isDominated;
    });
    if (others.size() >= kStatesAtVertex) {  // the dearest makes room
      const auto dearest = std::max_element(others.begin(), others.end(), [this](int a, int b) {
        return states_[static_cast<std::size_t>(a)].cost < states_[static_cast<std::size_t>(b)].cost;
      });
      states_[static_cast<std::size_t>(*dearest)].isDominated = true;
      others.erase(dearest);
    }
  }
  const double estimate = state.cost + kClearAir * toGo_[vertex];
  const double altitude = state.high;
  states_.push_back(state);
  const int id = static_cast<int>(states_.size()) - 1;
  others.push_back(id);
  open_.push_back({estimate, altitude, id});
  std::push_heap(open_.begin(), open_.end(), isLater);
}

void RoadmapSearch::neighboursOf(int vertex, std::vector<int>& out) const {
  out.clear();
  const auto from = static_cast<std::size_t>(vertex);
  if (from < roadmap_.edges.size()) {
    out = roadmap_.edges[from];
  }
  if (roadmap_.nearest == 0) {
    return;
  }
  const geo::Pose& at = roadmap_.vertices[from].pose;
  const std::vector<double>& radii = task_.flight.world().glide.glideRadii();
  const double radius = radii.empty() ? 0.0 : radii.back();
  // with dynamics the nearest are those that take few turns: else a dense roadmap joins poses that are a whole circle apart
  const auto distanceTo = [&](const geo::Pose& to) {
    const double distance = geo::distance(at.point(), to.point());
    if (!roadmap_.hasDynamics) {
      return distance;
    }
    const double bearing = std::atan2(to.y - at.y, to.x - at.x);
    return distance + radius * (std::abs(wrapPi(bearing - at.heading)) + std::abs(wrapPi(to.heading - bearing)));
  };
  std::vector<std::pair<double, int>> byDistance;
  const auto gather = [&](std::size_t begin, std::size_t end, std::size_t most) {
    byDistance.clear();
    for (std::size_t i = begin; i < end; ++i) {
      if (i != from) {
        byDistance.emplace_back(distanceTo(roadmap_.vertices[i].pose), static_cast<int>(i));
      }
    }
    const std::size_t count = std::min(most, byDistance.size());
    std::partial_sort(byDistance.begin(), byDistance.begin() + static_cast<std::ptrdiff_t>(count), byDistance.end());
    for (std::size_t i = 0; i < count; ++i) {
      out.push_back(byDistance[i].second);
    }
  };
  gather(1, 1 + roadmap_.goals, kGatesTried);
  gather(1 + roadmap_.goals, roadmap_.vertices.size(), roadmap_.nearest);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
}

/// A Dubins glide between two poses; with a choice of slopes also by the share of the vertex that it leads to.
void RoadmapSearch::alongCurve(const State& from, int to) {
  const RoadmapVertex& start = roadmap_.vertices[static_cast<std::size_t>(from.vertex)];
  const RoadmapVertex& end = roadmap_.vertices[static_cast<std::size_t>(to)];
  std::vector<flight::Piece> pieces;
  const flight::DubinsPath path = task_.flight.curve(start.pose, end.pose, from.high);
  flight::appendPieces(path, pieces);
  const bool hasChoice = end.share > 0.0 && task_.flight.hasRoom() && !task_.flight.weather().levels().empty();
  for (const double share : {0.0, end.share}) {
    if (share > 0.0 && !hasChoice) {
      break;
    }
    thread_local std::vector<mission::LandingLeg> legs;
    legs.clear();
    geo::Pose pose = start.pose;
    const double altitude = task_.flight.descents().fly(pose, from.high, pieces, share, &legs);
    if (!(altitude >= needed_[static_cast<std::size_t>(to)])) {
      return;
    }
    if (!task_.flight.descents().isClear(start.pose, from.high, legs)) {
      continue;
    }
    const double cost = from.cost + kClearAir * path.length() + task_.flight.weatherAlong(start.pose, from.high, legs);
    reached_.push_back({altitude, altitude, cost});
  }
}

void RoadmapSearch::lineEnd(const State& from, const geo::Pose& pose, const flight::Piece& piece, double end) {
  if (task_.flight.descents().isClear(pose, piece, from.high, end)) {
    reached_.push_back({end, end, from.cost + kClearAir * piece.length + task_.flight.weatherAlong(pose, piece, from.high, end)});
  }
}

/// A straight line between two places.
void RoadmapSearch::alongLine(const State& from, int to) {
  const RoadmapVertex& start = roadmap_.vertices[static_cast<std::size_t>(from.vertex)];
  const RoadmapVertex& end = roadmap_.vertices[static_cast<std::size_t>(to)];
  const geo::Pose pose{start.pose.x, start.pose.y, std::atan2(end.pose.y - start.pose.y, end.pose.x - start.pose.x)};
  const flight::Piece piece{flight::Turn::Straight, 0.0, geo::distance(start.pose.point(), end.pose.point())};
  const DescentRange range = task_.flight.descents().rangeOf(pose.heading, piece, from.high);
  if (roadmap_.altitude == EdgeAltitude::Intervals) {
    std::vector<AltitudeSlice> slices;
    task_.flight.slicesOf(pose, piece, range, slices, nullptr);
    std::vector<AltitudeInterval> intervals{{from.low, from.high, from.cost, -1, 0.0, 0.0}};
    for (const AltitudeSlice& slice : slices) {
      intervals = throughSlice(intervals, slice);
    }
    for (const AltitudeInterval& interval : intervals) {
      reached_.push_back({interval.low, interval.high, interval.cost + kClearAir * piece.length});
    }
    return;
  }
  const double highest = from.high - range.least * piece.length;
  const double lowest = from.high - range.most * piece.length;
  lineEnd(from, pose, piece, highest);
  if (!task_.flight.hasRoom()) {
    return;
  }
  if (end.share > 0.0 && !task_.flight.weather().levels().empty()) {
    lineEnd(from, pose, piece, from.high - range.at(end.share) * piece.length);
  }
  if (roadmap_.altitude == EdgeAltitude::Layers) {
    constexpr double kBeside = 1.0;  // m: just outside, as floor and top belong to the weather
    for (const double level : task_.flight.weather().levels()) {
      for (const double beside : {level - kBeside, level + kBeside}) {
        if (beside > lowest && beside < highest) {
          lineEnd(from, pose, piece, beside);
        }
      }
    }
  }
}

void RoadmapSearch::expand(int id) {
  const State from = states_[static_cast<std::size_t>(id)];
  const geo::Point at = roadmap_.vertices[static_cast<std::size_t>(from.vertex)].pose.point();
  const aircraft::GlideModel& glide = task_.flight.world().glide;
  neighboursOf(from.vertex, near_);
  constexpr std::size_t kChecked = 16;  // edges between two looks at the clock
  for (std::size_t i = 0; i < near_.size() && (i % kChecked != 0 || !task_.countdown.isOver()); ++i) {
    const int to = near_[i];
    const auto vertex = static_cast<std::size_t>(to);
    const geo::Point place = roadmap_.vertices[vertex].pose.point();
    const double distance = geo::distance(at, place);
    if (distance < kShortest) {
      continue;
    }
    const double highest = from.high - glide.leastLossOver(place.x - at.x, place.y - at.y);
    if (!(highest >= needed_[vertex]) || isDominated({to, highest, highest, from.cost + kClearAir * distance, id, false})) {
      continue;
    }
    reached_.clear();
    ++count_.edges;
    if (roadmap_.hasDynamics) {
      alongCurve(from, to);
    } else {
      alongLine(from, to);
    }
    for (const Reached& reached : reached_) {
      push({to, reached.low, reached.high, reached.cost, id, false});
    }
  }
}

std::optional<RoadmapWay> RoadmapSearch::next() {
  while (!open_.empty() && !task_.countdown.isOver()) {
    std::pop_heap(open_.begin(), open_.end(), isLater);
    const int id = open_.back().state;
    open_.pop_back();
    if (states_[static_cast<std::size_t>(id)].isDominated) {
      continue;
    }
    ++count_.expanded;
    const State& state = states_[static_cast<std::size_t>(id)];
    if (!roadmap_.isGoal(static_cast<std::size_t>(state.vertex))) {
      expand(id);
      continue;
    }
    RoadmapWay way;
    way.goal = static_cast<std::size_t>(state.vertex) - 1;
    way.cost = state.cost;
    for (int at = state.parent; states_[static_cast<std::size_t>(at)].parent >= 0; at = states_[static_cast<std::size_t>(at)].parent) {
      way.vertices.push_back(states_[static_cast<std::size_t>(at)].vertex);
    }
    std::reverse(way.vertices.begin(), way.vertices.end());
    return way;
  }
  return std::nullopt;
}

}  // namespace vp::emergency
