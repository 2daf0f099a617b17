#include "core/landing/tree_roadmap.h"

#include "core/aircraft/glide_bands.h"
#include "core/base/expect.h"
#include "core/base/quantity.h"
#include "core/flight/piece_loss.h"
#include "core/flight/pose_pair.h"
#include "core/landing/required_height.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace vp::landing {
namespace {

/// Least height at the start of a path.
double requiredOf(const World& world, const flight::DubinsPath& path, std::size_t radius, double end,
                  double giveUpAbove = std::numeric_limits<double>::infinity()) {
  return requiredStartHeight(world, path, flight::Direction(path.start.heading), radius, end, giveUpAbove);
}

/// The cover of what a glide between two poses surely comes through; null where losses do not differ by altitude.
const aircraft::GlideModel* coverOf(const aircraft::GlideModel& glide, const flight::PosePair& pair, double end) {
  const aircraft::GlideBands* const bands = glide.bands();
  return bands == nullptr ? nullptr
                          : &bands->between(bands->above(end), std::max(bands->above(end), bands->below(end + glide.leastLoss() * pair.distance())));
}

}  // namespace

TreeRoadmap::TreeRoadmap(const World& world, const std::vector<Approach>& approaches, double bucket)
    : Roadmap(approaches), index_(world.terrain.grid().extent(), bucket), reach_(2.0 * bucket), glide_(world.glide) {
  leastLossPerRadian_ = std::numeric_limits<double>::infinity();
  for (const double radius : world.glide.glideRadii()) {
    losses_.push_back({radius, flight::turnLossOf(glide_, radius)});
  }
  for (std::size_t i = 0; i < losses_.size(); ++i) {
    for (const flight::TurnLoss& loss : flight::bandLossesOf(glide_, i)) {
      leastLossPerRadian_ = std::min(leastLossPerRadian_, loss.turn * losses_[i].radius);
    }
  }
  for (const Approach& approach : approaches) {
    RoadmapNode node;
    node.pose = approach.gate;
    node.altitude = approach.altitude;
    node.site = approach.site;
    node.toParent.start = approach.gate;
    const int id = static_cast<int>(nodes_.size());
    nodes_.push_back(node);
    children_.emplace_back();
    roots_.push_back(id);
    index_.insert(approach.gate.point(), id);
  }
}

std::size_t TreeRoadmap::indexOf(double radius) const {
  const auto known = std::find_if(losses_.begin(), losses_.end(), [radius](const RadiusLoss& one) { return one.radius == radius; });
  VP_EXPECT(known != losses_.end());
  return static_cast<std::size_t>(known - losses_.begin());
}

double TreeRoadmap::boundTo(const geo::Pose& from, int node) const {
  const RoadmapNode& to = nodes_[static_cast<std::size_t>(node)];
  const double dx = to.pose.x - from.x;
  const double dy = to.pose.y - from.y;
  const double turn = std::abs(wrapPi(to.pose.heading - from.heading));
  return to.altitude + std::max(glide_.leastLossOver(dx, dy), leastLossPerRadian_ * turn);
}

void TreeRoadmap::optionsTo(const geo::Pose& from, int node, double below, std::vector<GlideOption>& options) const {
  const RoadmapNode& to = nodes_[static_cast<std::size_t>(node)];
  const flight::PosePair pair(from, to.pose);
  const aircraft::GlideModel* const cover = coverOf(glide_, pair, to.altitude);
  for (std::size_t i = 0; i < losses_.size(); ++i) {
    const flight::TurnLoss loss = cover == nullptr ? losses_[i].loss : flight::turnLossAt(*cover, i);
    const flight::DubinsPath path = pair.leastLoss(losses_[i].radius, loss);
    const double altitude = to.altitude + flight::lossOf(path, loss);
    if (altitude < below) {
      options.push_back({path, altitude, i, node});
    }
  }
}

std::optional<GlideLeg> TreeRoadmap::legTo(const World& world, const geo::Pose& from, int node, double below,
                                           std::vector<GlideOption>& options) const {
  options.clear();
  optionsTo(from, node, below, options);
  std::sort(options.begin(), options.end(), [](const GlideOption& a, const GlideOption& b) { return a.altitude < b.altitude; });
  std::optional<GlideLeg> best;
  for (const GlideOption& option : options) {
    if (option.altitude >= below) {
      break;  // where the ground does not ask for more, the first option ends the loop
    }
    const double altitude = requiredOf(world, option.path, option.radius, nodes_[static_cast<std::size_t>(node)].altitude, below);
    if (altitude < below) {
      below = altitude;
      best = GlideLeg{option.path, altitude};
    }
  }
  return best;
}

int TreeRoadmap::add(const geo::Pose& pose, int parent, const GlideLeg& leg) {
  const int id = static_cast<int>(nodes_.size());
  nodes_.push_back({pose, leg.altitude, parent, nodes_[static_cast<std::size_t>(parent)].site, leg.path});
  children_.emplace_back();
  children_[static_cast<std::size_t>(parent)].push_back(id);
  index_.insert(pose.point(), id);
  return id;
}

void TreeRoadmap::reconnect(const World& world, int node, int parent, const GlideLeg& leg) {
  RoadmapNode& moved = nodes_[static_cast<std::size_t>(node)];
  VP_EXPECT(moved.parent >= 0 && leg.altitude <= moved.altitude);
  std::erase(children_[static_cast<std::size_t>(moved.parent)], node);
  moved.parent = parent;
  moved.toParent = leg.path;
  moved.altitude = leg.altitude;
  moved.site = nodes_[static_cast<std::size_t>(parent)].site;
  children_[static_cast<std::size_t>(parent)].push_back(node);

  std::vector<int> open{node};
  while (!open.empty()) {
    const int current = open.back();
    open.pop_back();
    const RoadmapNode& lower = nodes_[static_cast<std::size_t>(current)];
    for (const int child : children_[static_cast<std::size_t>(current)]) {
      RoadmapNode& upper = nodes_[static_cast<std::size_t>(child)];
      upper.site = lower.site;
      upper.altitude = std::min(upper.altitude, requiredOf(world, upper.toParent, indexOf(upper.toParent.radius), lower.altitude));
      open.push_back(child);
    }
  }
}

void TreeRoadmap::improveByAncestors(const World& world, const geo::Pose& from, SafeAltitude& best, std::vector<GlideOption>& options) const {
  // A direct glide past intermediate nodes saves their headings; ancestors with a bound above the answer cannot help.
  constexpr int kPatience = 3;
  int ancestor = nodes_[static_cast<std::size_t>(best.node)].parent;
  for (int failures = 0; ancestor >= 0 && failures < kPatience; ancestor = nodes_[static_cast<std::size_t>(ancestor)].parent) {
    std::optional<GlideLeg> leg;
    if (boundTo(from, ancestor) < best.altitude) {
      leg = legTo(world, from, ancestor, best.altitude, options);
    }
    if (leg) {
      best = {leg->altitude, ancestor, nodes_[static_cast<std::size_t>(ancestor)].site, leg->path};
      failures = 0;
    } else {
      ++failures;
    }
  }
}

std::optional<SafeAltitude> TreeRoadmap::queryTurning(const World& world, const geo::Pose& from, QueryScratch& scratch, int hint) const {
  ++scratch.queries;
  SafeAltitude best;
  best.altitude = std::numeric_limits<double>::infinity();
  if (hint >= 0) {
    if (const std::optional<GlideLeg> leg = legTo(world, from, hint, best.altitude, scratch.options)) {
      best = {leg->altitude, hint, nodes_[static_cast<std::size_t>(hint)].site, leg->path};
    }
  }
  auto& heap = scratch.candidates;
  heap.clear();
  scratch.options.clear();
  const auto consider = [&](int node) {
    if (const double bound = boundTo(from, node); bound < best.altitude && node != hint) {
      heap.push_back({bound, node, -1});
    }
  };
  std::for_each(roots_.begin(), roots_.end(), consider);
  scratch.near.clear();
  index_.within(from.point(), reach_, scratch.near);
  for (const int node : scratch.near) {
    if (nodes_[static_cast<std::size_t>(node)].parent >= 0) {
      consider(node);
    }
  }
  std::make_heap(heap.begin(), heap.end(), std::greater<>());
  while (!heap.empty() && heap.front().bound < best.altitude) {
    const QueryScratch::Candidate top = heap.front();
    std::pop_heap(heap.begin(), heap.end(), std::greater<>());
    heap.pop_back();
    if (top.option < 0) {
      const std::size_t first = scratch.options.size();
      optionsTo(from, top.node, best.altitude, scratch.options);
      for (std::size_t i = first; i < scratch.options.size(); ++i) {
        heap.push_back({scratch.options[i].altitude, top.node, static_cast<int>(i)});
        std::push_heap(heap.begin(), heap.end(), std::greater<>());
      }
      continue;
    }
    const GlideOption& option = scratch.options[static_cast<std::size_t>(top.option)];
    const double altitude = requiredOf(world, option.path, option.radius, nodes_[static_cast<std::size_t>(top.node)].altitude, best.altitude);
    if (altitude < best.altitude) {
      best = {altitude, top.node, nodes_[static_cast<std::size_t>(top.node)].site, option.path};
    }
  }
  if (best.node < 0) {
    return std::nullopt;
  }
  improveByAncestors(world, from, best, scratch.options);
  return best;
}

void TreeRoadmap::appendGlide(const SafeAltitude& answer, std::vector<flight::Piece>& pieces) const {
  flight::appendPieces(answer.first, pieces);
  for (int node = answer.node; nodes_[static_cast<std::size_t>(node)].parent >= 0; node = nodes_[static_cast<std::size_t>(node)].parent) {
    flight::appendPieces(nodes_[static_cast<std::size_t>(node)].toParent, pieces);
  }
}

void TreeRoadmap::draw(std::size_t most, const DrawGlide& draw) const {
  const std::size_t stride = nodes_.size() / std::max<std::size_t>(most, 1) + 1;
  for (std::size_t i = 0; i < nodes_.size(); i += stride) {
    if (nodes_[i].parent >= 0) {
      draw(nodes_[i].pose.point(), nodes_[static_cast<std::size_t>(nodes_[i].parent)].pose.point(), nodes_[i].altitude);
    }
  }
}

}  // namespace vp::landing
