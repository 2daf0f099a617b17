#include "core/landing/lattice_roadmap.h"

#include "core/base/quantity.h"

#include <algorithm>
#include <cmath>

namespace vp::landing {
namespace {

constexpr int kWide = 2;               // lattice steps around the queried pose where the nearest poses do not help
constexpr std::size_t kMostAhead = 8;  // of what lies farther ahead, lowest bound first
constexpr std::size_t kMostWide = 60;  // of the wider surrounding
/// An answer this far above what the poses around it need is not believed: what lies farther ahead is tried as well [m].
constexpr double kTooHigh = 20.0;
/// After this many glides against the ground the lowest one found stands. Behind ridges a query took up to 32, of which the later ones found
/// little: without this limit the mean is 0.15 m lower and the 99th percentile of the time twice as long (mountain).
constexpr std::int64_t kMostGlides = 12;
/// Once there is an answer, glides that cannot be this much lower are left [m]: with 0 a query tries 0.9 more and the mean is 0.1 m lower.
constexpr double kWorthwhile = 0.3;

void addOnce(std::vector<int>& nodes, int node) {
  if (node >= 0 && std::find(nodes.begin(), nodes.end(), node) == nodes.end()) {
    nodes.push_back(node);
  }
}

}  // namespace

double LatticeRoadmap::gatherAround(const geo::Pose& from, QueryScratch& scratch) const {
  const GlidePrimitives& lattice = glides_.primitives;
  const double x = (from.x - glides_.originX) / lattice.step;
  const double y = (from.y - glides_.originY) / lattice.step;
  const int column = std::clamp(static_cast<int>(std::floor(x)), 0, glides_.columns - 2);
  const int row = std::clamp(static_cast<int>(std::floor(y)), 0, glides_.rows - 2);
  const double heading = wrapTwoPi(from.heading);
  const std::size_t below = lattice.headingBelow(heading);
  const std::size_t above = below + 1 < lattice.headings.size() ? below + 1 : 0;
  const double sector = above > 0 ? lattice.headings[above] - lattice.headings[below] : 2.0 * Angle::kPi - lattice.headings[below];
  const double wx = std::clamp(x - column, 0.0, 1.0);
  const double wy = std::clamp(y - row, 0.0, 1.0);
  const double wh = (heading - lattice.headings[below]) / sector;
  double sum = 0.0;
  double weights = 0.0;
  auto& candidates = scratch.candidates;
  for (int corner = 0; corner < 8; ++corner) {
    const bool isEast = (corner & 1) != 0;
    const bool isNorth = (corner & 2) != 0;
    const bool isAbove = (corner & 4) != 0;
    const int state = glides_.stateAt(column + (isEast ? 1 : 0), row + (isNorth ? 1 : 0), static_cast<int>(isAbove ? above : below));
    const int node = glides_.nextOf(state);
    if (node < 0) {
      continue;
    }
    const double altitude = glides_.altitudeOf(state);
    const double weight = (isEast ? wx : 1.0 - wx) * (isNorth ? wy : 1.0 - wy) * (isAbove ? wh : 1.0 - wh);
    sum += weight * altitude;
    weights += weight;
    const auto known = std::find_if(candidates.begin(), candidates.end(), [node](const auto& candidate) { return candidate.node == node; });
    if (known == candidates.end()) {
      candidates.push_back({altitude, node, -1});
    } else {
      known->bound = std::min(known->bound, altitude);
    }
  }
  return weights > 0.0 ? sum / weights : std::numeric_limits<double>::infinity();
}

void LatticeRoadmap::gatherWide(const geo::Pose& from, std::vector<int>& nodes) const {
  const double step = glides_.primitives.step;
  const int column = static_cast<int>(std::floor((from.x - glides_.originX) / step));
  const int row = static_cast<int>(std::floor((from.y - glides_.originY) / step));
  for (int r = std::max(0, row - kWide); r <= std::min(glides_.rows - 1, row + 1 + kWide); ++r) {
    for (int c = std::max(0, column - kWide); c <= std::min(glides_.columns - 1, column + 1 + kWide); ++c) {
      for (int h = 0; h < glides_.headings(); ++h) {
        const int state = glides_.stateAt(c, r, h);
        if (const int node = glides_.nextOf(state); node >= 0) {
          nodes.push_back(state);
          nodes.push_back(node);
        }
      }
    }
  }
  for (std::size_t root = 0; root < glides_.roots.size(); ++root) {
    nodes.push_back(glides_.states() + static_cast<int>(root));
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

void LatticeRoadmap::tryNode(const World& world, const geo::Pose& from, flight::Direction direction, int node, QueryScratch& scratch,
                             SafeAltitude& best) const {
  const double below = best.altitude - kWorthwhile;
  if (const LatticeLeg leg = lowestLeg(world, glides_, from, direction, node, below, scratch.legs); leg.altitude < below) {
    best.altitude = leg.altitude;
    best.node = node;
    best.first = leg.path;
  }
}

void LatticeRoadmap::tryNearest(const World& world, const geo::Pose& from, flight::Direction direction, std::size_t most, std::int64_t mostGlides,
                                QueryScratch& scratch, SafeAltitude& best) const {
  auto& candidates = scratch.candidates;
  candidates.clear();
  for (const int node : scratch.near) {
    const geo::Pose pose = glides_.poseOf(node);
    const double bound = glides_.altitudeOf(node) + world.glide.leastLossOver(pose.x - from.x, pose.y - from.y);
    if (bound < best.altitude) {
      candidates.push_back({bound, node, -1});
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) { return b > a; });
  for (std::size_t i = 0; i < std::min(candidates.size(), most) && candidates[i].bound < best.altitude; ++i) {
    if (best.node >= 0 && scratch.legs >= mostGlides) {
      return;
    }
    tryNode(world, from, direction, candidates[i].node, scratch, best);
  }
}

void LatticeRoadmap::tryPastAnswer(const World& world, const geo::Pose& from, flight::Direction direction, std::int64_t mostGlides,
                                   QueryScratch& scratch, SafeAltitude& best) const {
  for (int node = glides_.nextOf(best.node); node >= 0 && scratch.legs < mostGlides; node = glides_.nextOf(node)) {
    tryNode(world, from, direction, node, scratch, best);
    if (best.node != node) {
      return;
    }
  }
}

std::optional<SafeAltitude> LatticeRoadmap::queryTurning(const World& world, const geo::Pose& from, QueryScratch& scratch, int hint) const {
  ++scratch.queries;
  SafeAltitude best;
  best.altitude = std::numeric_limits<double>::infinity();
  const flight::Direction direction(from.heading);
  const std::int64_t mostGlides = scratch.legs + kMostGlides;
  auto& candidates = scratch.candidates;
  candidates.clear();
  const double expected = gatherAround(from, scratch);
  if (hint >= 0) {
    tryNode(world, from, direction, hint, scratch, best);
  }
  std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) { return b > a; });
  for (const QueryScratch::Candidate& candidate : candidates) {
    if (best.altitude <= expected || (best.node >= 0 && scratch.legs >= mostGlides)) {
      break;  // as low as the poses around it let hope, or enough
    }
    if (candidate.node != hint) {
      tryNode(world, from, direction, candidate.node, scratch, best);
    }
  }
  if (best.altitude > expected + kTooHigh) {
    scratch.near.clear();
    for (const QueryScratch::Candidate& candidate : candidates) {
      const int next = glides_.nextOf(candidate.node);
      addOnce(scratch.near, next);
      addOnce(scratch.near, next >= 0 ? glides_.nextOf(next) : -1);
    }
    tryNearest(world, from, direction, kMostAhead, mostGlides, scratch, best);
  }
  if (best.node < 0) {
    scratch.near.clear();
    gatherWide(from, scratch.near);
    tryNearest(world, from, direction, kMostWide, mostGlides, scratch, best);
  }
  if (best.node < 0) {
    return std::nullopt;
  }
  tryPastAnswer(world, from, direction, mostGlides, scratch, best);
  best.site = glides_.siteOf(best.node);
  return best;
}

void LatticeRoadmap::appendGlide(const SafeAltitude& answer, std::vector<flight::Piece>& pieces) const {
  flight::appendPieces(answer.first, pieces);
  for (int node = answer.node; !glides_.isRoot(node); node = glides_.nextOf(node)) {
    flight::appendPieces(glides_.legOf(node), pieces);
  }
}

std::size_t LatticeRoadmap::size() const {
  return static_cast<std::size_t>(std::count_if(glides_.via.begin(), glides_.via.end(), [](std::int32_t node) { return node >= 0; }));
}

void LatticeRoadmap::draw(std::size_t most, const DrawGlide& draw) const {
  const int stride = static_cast<int>(static_cast<std::size_t>(glides_.states()) / std::max<std::size_t>(most, 1)) + 1;
  for (int state = 0; state < glides_.states(); state += stride) {
    if (const int next = glides_.nextOf(state); next >= 0) {
      draw(glides_.poseOf(state).point(), glides_.poseOf(next).point(), glides_.altitudeOf(state));
    }
  }
}

}  // namespace vp::landing
