#include "core/landing/glide_straightener.h"

#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"
#include "core/flight/pose_pair.h"
#include "core/landing/required_height.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vp::landing {
namespace {

constexpr double kRounding = 1e-6;  // m
/// A way that saves less rolling than this is left as it is [m].
constexpr double kWorthwhile = 0.5;
/// Straightening what was straightened finds a little more; a third time next to nothing.
constexpr int kRounds = 2;

std::vector<flight::Piece> allOf(const GlideParts& glide) {
  std::vector<flight::Piece> pieces = glide.reaction;
  pieces.insert(pieces.end(), glide.way.begin(), glide.way.end());
  pieces.insert(pieces.end(), glide.approach.pieces.begin(), glide.approach.pieces.end());
  return pieces;
}

/// Adds a piece, as part of the one before where both are one turn.
void append(const flight::Piece& piece, std::vector<flight::Piece>& way) {
  if (!way.empty() && way.back().turn == piece.turn && (piece.turn == flight::Turn::Straight || way.back().radius == piece.radius)) {
    way.back().length += piece.length;
  } else {
    way.push_back(piece);
  }
}

}  // namespace

/// The way with the poses between its pieces, the heights needed there, and what rolling costs up to each.
struct GlideStraightener::Joints {
  std::vector<flight::Piece> pieces;
  std::vector<geo::Pose> poses;         ///< one more than pieces
  std::vector<flight::Direction> directions;
  std::vector<double> heights;          ///< as poses
  std::vector<double> rolled;           ///< by piece: between pieces up to its beginning
  flight::Piece after;                  ///< flown behind the way
};

GlideStraightener::Proof GlideStraightener::improved(const geo::Pose& from, const flight::Piece& tour, Proof proof, int site, double atHand) const {
  std::optional<GlideParts> glide = needs_.partsOf(proof.pieces, site);
  if (!glide) {
    return proof;
  }
  const auto needOf = [&](const GlideParts& one) {
    GlideNeed need = needs_.of(from, one, tour);
    need.altitude = std::max(need.altitude, proof.safeAltitude);
    return need;
  };
  GlideParts simpler = straightened(from, tour, proof.safeAltitude, *glide);
  GlideNeed need = needOf(simpler);
  need.altitude = proof.safeAltitude;  // bounds depend a little on where a glide is cut; the roadmap's holds
  const bool rollsMuch = world_.rollRate_dps && rollingOf(simpler, tour) > world_.clearance;
  if (need.withRolling > proof.safeAltitude || rollsMuch) {
    GlideNeed asGiven = needOf(*glide);
    asGiven.altitude = proof.safeAltitude;
    const double limit = std::max(atHand, std::min(need.lowest(), asGiven.lowest()));
    if (need.lowest() > limit) {
      simpler = *glide;
      need = asGiven;
    }
    GlideParts higher = straightened(from, tour, limit, simpler);
    if (const GlideNeed other = needOf(higher); other.lowest() <= limit) {
      simpler = std::move(higher);
      need = other;
    }
  }
  glide = std::move(simpler);
  proof.pieces = joinedGlide(world_, std::move(glide->reaction), glide->way);
  proof.pieces.insert(proof.pieces.end(), glide->approach.pieces.begin(), glide->approach.pieces.end());
  proof.safeAltitude = std::max(proof.safeAltitude, need.lowest());
  return proof;
}

GlideParts GlideStraightener::straightened(const geo::Pose& from, const flight::Piece& tour, double height, const GlideParts& glide) const {
  GlideParts best = glide;
  double least = rollingOf(glide, tour);
  for (int round = 0; round < kRounds; ++round) {
    geo::Pose pose = from;
    for (const flight::Piece& piece : best.reaction) {
      pose = flight::endOf(pose, piece);
    }
    std::vector<flight::Piece> whole = best.reaction;
    whole.insert(whole.end(), best.way.begin(), best.way.end());
    const std::vector<double> heights = needs_.heightsAlong(from, whole, best.approach.altitude);
    if (!std::isfinite(heights.front())) {
      return best;
    }
    const double spare = std::max(0.0, height - world_.reactionLoss - heights.front());
    Joints joints;
    joints.pieces = best.way;
    joints.heights.assign(heights.begin() + static_cast<std::ptrdiff_t>(best.reaction.size()), heights.end());
    joints.poses.push_back(pose);
    for (const flight::Piece& piece : best.way) {
      joints.poses.push_back(flight::endOf(joints.poses.back(), piece));
    }
    for (const geo::Pose& joint : joints.poses) {
      joints.directions.emplace_back(joint.heading);
    }
    joints.rolled.assign(best.way.size() + 1, 0.0);
    for (std::size_t i = 1; i < best.way.size(); ++i) {
      joints.rolled[i] = joints.rolled[i - 1] + needs_.rolling(best.way[i - 1], best.way[i]);
    }
    joints.after = best.approach.pieces.empty() ? flight::Piece() : best.approach.pieces.front();
    double before = 0.0;  // height at the first joint
    if (best.reaction.empty() || world_.glide.bands() != nullptr) {
      before = joints.heights.front() + spare;
    } else {
      before = height - world_.reactionLoss;
      geo::Pose along = from;
      for (const flight::Piece& piece : best.reaction) {
        before -= flight::lossUpTo(world_.glide, along, piece, piece.length);
        along = flight::endOf(along, piece);
      }
    }
    GlideParts next = best;
    next.way = pulled(joints, best.reaction.empty() ? tour : best.reaction.back(), before);
    const double rolling = rollingOf(next, tour);
    if (rolling > least - kWorthwhile || needs_.of(from, next, tour).altitude > height + kRounding) {
      return best;
    }
    least = rolling;
    best = std::move(next);
  }
  return best;
}

/// What rolling costs in all [m].
double GlideStraightener::rollingOf(const GlideParts& glide, const flight::Piece& tour) const {
  const std::vector<double> rolling = needs_.rollingAlong(tour, allOf(glide));
  return rolling.empty() ? 0.0 : rolling.back();
}

/// @param height  at the first joint
std::vector<flight::Piece> GlideStraightener::pulled(const Joints& joints, flight::Piece before, double height) const {
  std::vector<flight::Piece> way;
  std::size_t at = 0;
  while (at < joints.pieces.size()) {
    const flight::Piece last = way.empty() ? before : way.back();
    std::size_t reached = at;
    if (pull(joints, at, last, height, way, reached)) {
      at = reached;
      continue;
    }
    const flight::Piece& piece = joints.pieces[at];
    append(piece, way);
    height = world_.glide.bands() == nullptr ? height - flight::lossUpTo(world_.glide, joints.poses[at], piece, piece.length)
                                             : joints.heights[at + 1] + std::max(0.0, height - joints.heights[at]);
    ++at;
  }
  return way;
}

/// One glide from a joint to the farthest one that it can reach with less rolling.
bool GlideStraightener::pull(const Joints& joints, std::size_t from, const flight::Piece& before, double& height, std::vector<flight::Piece>& way,
                             std::size_t& reached) const {
  const std::size_t count = joints.pieces.size();
  const std::vector<double>& radii = world_.glide.glideRadii();
  const geo::Pose& start = joints.poses[from];
  std::vector<std::pair<double, std::pair<std::size_t, flight::DubinsPath>>> ways;
  for (std::size_t to = count; to > from + 1; --to) {
    const geo::Pose& end = joints.poses[to];
    const double low = joints.heights[to];
    if (low + world_.glide.leastLossOver(end.x - start.x, end.y - start.y) > height) {
      continue;
    }
    const flight::Piece& after = to < count ? joints.pieces[to] : joints.after;
    const double now = needs_.rolling(before, joints.pieces[from]) + joints.rolled[to - 1] - joints.rolled[from] +
                       needs_.rolling(joints.pieces[to - 1], after);
    const flight::PosePair pair(start, joints.directions[from], end, joints.directions[to]);
    ways.clear();
    for (std::size_t i = 0; i < radii.size(); ++i) {
      const flight::TurnLoss loss = flight::turnLossAt(world_.glide, i);
      if (!std::isfinite(loss.turn)) {
        continue;
      }
      const flight::DubinsPath path = pair.leastLoss(radii[i], loss);
      double rolls = 0.0;
      flight::Piece last = before;
      for (std::size_t part = 0; part < 3; ++part) {
        if (const flight::Piece piece = path.piece(part); piece.length > kRounding) {
          rolls += needs_.rolling(last, piece);
          last = piece;
        }
      }
      rolls += needs_.rolling(last, after);
      if (rolls < now - kWorthwhile) {
        ways.push_back({rolls, {i, path}});
      }
    }
    std::sort(ways.begin(), ways.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [rolls, option] : ways) {
      const auto& [radius, path] = option;
      const double needed = requiredStartHeight(world_, path, joints.directions[from], radius, low, height);
      if (!(needed <= height)) {
        continue;
      }
      height = world_.glide.bands() == nullptr ? height - flight::lossOf(path, flight::turnLossAt(world_.glide, radius)) : low + height - needed;
      for (std::size_t part = 0; part < 3; ++part) {
        if (const flight::Piece piece = path.piece(part); piece.length > kRounding) {
          append(piece, way);
        }
      }
      reached = to;
      return true;
    }
  }
  return false;
}

}  // namespace vp::landing
