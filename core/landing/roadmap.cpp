#include "core/landing/roadmap.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/expect.h"
#include "core/base/quantity.h"
#include "core/landing/required_height.h"

namespace vp::landing {

Roadmap::Roadmap(const World& world, double bucket)
    : index_(world.terrain.grid().extent(), bucket), reach_(2.0 * bucket), straightLoss_(world.glide.straightLoss()) {
  leastLossPerRadian_ = std::numeric_limits<double>::infinity();
  for (const double radius : world.glide.glideRadii()) {
    losses_.push_back({world.glide.straightLoss(), world.glide.lossAt(radius)});
    leastLossPerRadian_ = std::min(leastLossPerRadian_, losses_.back().turn * radius);
  }
  for (std::size_t s = 0; s < world.sites.size(); ++s) {
    const mission::SiteInFrame& site = world.sites[s];
    const double ground = world.terrain.grid().upperAt(site.pose.point());
    if (!std::isfinite(ground)) {
      continue;  // unknown ground: never safe
    }
    RoadmapNode node;
    node.pose = site.pose;
    // DESIGN section 2: A(site) is elevation + margin, and the site itself is a point of the glide that needs clearance.
    node.altitude = std::max(site.site.elevation.metres() + world.arrivalMargin, ground + world.clearance);
    node.site = static_cast<int>(s);
    node.toParent.start = site.pose;
    const int id = static_cast<int>(nodes_.size());
    nodes_.push_back(node);
    children_.emplace_back();
    roots_.push_back(id);
    index_.insert(site.pose.point(), id);
  }
}

double Roadmap::boundTo(const geo::Pose& from, int node) const {
  const RoadmapNode& to = nodes_[static_cast<std::size_t>(node)];
  const double dx = to.pose.x - from.x;
  const double dy = to.pose.y - from.y;
  const double turn = std::abs(wrapPi(to.pose.heading - from.heading));
  return to.altitude + std::max(straightLoss_ * std::sqrt(dx * dx + dy * dy), leastLossPerRadian_ * turn);
}

std::optional<GlideLeg> Roadmap::legTo(const World& world, const geo::Pose& from, int node, double below) const {
  const RoadmapNode& to = nodes_[static_cast<std::size_t>(node)];
  std::optional<GlideLeg> best;
  const std::vector<double>& radii = world.glide.glideRadii();
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const flight::DubinsPath path = flight::leastLossDubins(from, to.pose, radii[i], losses_[i]);
    if (to.altitude + flight::lossOf(path, losses_[i]) >= below) {
      continue;
    }
    const double altitude = requiredStartHeight(world, path, to.altitude, below);
    if (altitude < below) {
      below = altitude;
      best = GlideLeg{path, altitude};
    }
  }
  return best;
}

int Roadmap::add(const geo::Pose& pose, int parent, const GlideLeg& leg) {
  const int id = static_cast<int>(nodes_.size());
  nodes_.push_back({pose, leg.altitude, parent, nodes_[static_cast<std::size_t>(parent)].site, leg.path});
  children_.emplace_back();
  children_[static_cast<std::size_t>(parent)].push_back(id);
  index_.insert(pose.point(), id);
  return id;
}

void Roadmap::reconnect(const World& world, int node, int parent, const GlideLeg& leg) {
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
      upper.altitude = std::min(upper.altitude, requiredStartHeight(world, upper.toParent, lower.altitude));
      open.push_back(child);
    }
  }
}

void Roadmap::improveByAncestors(const World& world, const geo::Pose& from, SafeAltitude& best) const {
  // A direct glide past intermediate nodes saves their headings; ancestors with a bound above the answer cannot help.
  int ancestor = nodes_[static_cast<std::size_t>(best.node)].parent;
  int failures = 0;
  while (ancestor >= 0 && failures < 3) {
    std::optional<GlideLeg> leg;
    if (boundTo(from, ancestor) < best.altitude) {
      leg = legTo(world, from, ancestor, best.altitude);
    }
    if (leg) {
      best = {leg->altitude, ancestor, leg->path};
      failures = 0;
    } else {
      ++failures;
    }
    ancestor = nodes_[static_cast<std::size_t>(ancestor)].parent;
  }
}

std::optional<SafeAltitude> Roadmap::query(const World& world, const geo::Pose& from, QueryScratch& scratch, int hint) const {
  ++scratch.queries;
  SafeAltitude best;
  best.altitude = std::numeric_limits<double>::infinity();
  const auto attempt = [&](int node) {
    if (const std::optional<GlideLeg> leg = legTo(world, from, node, best.altitude)) {
      best = {leg->altitude, node, leg->path};
    }
  };
  if (hint >= 0) {
    attempt(hint);
  }
  auto& candidates = scratch.candidates;
  candidates.clear();
  for (const int root : roots_) {
    if (const double bound = boundTo(from, root); bound < best.altitude) {
      candidates.emplace_back(bound, root);
    }
  }
  std::sort(candidates.begin(), candidates.end());
  for (const auto& [bound, root] : candidates) {
    if (bound >= best.altitude) {
      break;
    }
    attempt(root);
  }

  candidates.clear();
  scratch.near.clear();
  index_.within(from.point(), reach_, scratch.near);
  for (const int node : scratch.near) {
    if (const double bound = boundTo(from, node); bound < best.altitude) {
      candidates.emplace_back(bound, node);
    }
  }
  // cheapest bound first; a heap because usually only a few are looked at
  std::make_heap(candidates.begin(), candidates.end(), std::greater<>());
  while (!candidates.empty() && candidates.front().first < best.altitude) {
    const int node = candidates.front().second;
    std::pop_heap(candidates.begin(), candidates.end(), std::greater<>());
    candidates.pop_back();
    if (node != hint) {
      attempt(node);
    }
  }
  if (best.node < 0) {
    return std::nullopt;
  }
  improveByAncestors(world, from, best);
  return best;
}

std::vector<flight::Piece> Roadmap::witnessPieces(const SafeAltitude& answer) const {
  std::vector<flight::Piece> pieces;
  flight::appendPieces(answer.first, pieces);
  for (int node = answer.node; nodes_[static_cast<std::size_t>(node)].parent >= 0; node = nodes_[static_cast<std::size_t>(node)].parent) {
    flight::appendPieces(nodes_[static_cast<std::size_t>(node)].toParent, pieces);
  }
  return pieces;
}

}  // namespace vp::landing
