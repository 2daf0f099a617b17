#include "core/landing/glide_straightener.h"

#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"
#include "core/flight/pose_pair.h"
#include "core/landing/required_height.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::landing {
namespace {

constexpr double kRounding = 1e-6;  // m
/// A way that saves less rolling than this is left as it is [m].
constexpr double kWorthwhile = 0.5;
/// Heights between the one needed and the one at hand that glides are straightened within.
constexpr int kBudgets = 4;
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
    if (asGiven.lowest() < need.lowest() && need.lowest() > atHand) {
      simpler = *glide;
      need = asGiven;
    }
    // with all the height at hand, or with less: what is saved by rolling less may be lost by flying otherwise
    const double limit = std::max(atHand, need.lowest());
    for (int part = kBudgets; part > 0; --part) {
      GlideParts other = straightened(from, tour, proof.safeAltitude + (limit - proof.safeAltitude) * part / kBudgets, simpler);
      const GlideNeed needed = needOf(other);
      const bool isLess =
          needed.lowest() <= atHand ? rollingOf(other, tour) < rollingOf(simpler, tour) || need.lowest() > atHand : needed.lowest() < need.lowest();
      if (isLess) {
        simpler = std::move(other);
        need = needed;
      }
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
    const std::optional<Joints> joints = jointsOf(from, height, best);
    if (!joints) {
      return best;
    }
    GlideParts next = best;
    next.way = pulled(*joints, best.reaction.empty() ? tour : best.reaction.back());
    const double rolling = rollingOf(next, tour);
    if (rolling > least - kWorthwhile || needs_.of(from, next, tour).altitude > height + kRounding) {
      return best;
    }
    least = rolling;
    best = std::move(next);
  }
  return best;
}

/// @param height  m MSL at the beginning of the glide, E included   @return nothing over unknown ground
std::optional<GlideStraightener::Joints> GlideStraightener::jointsOf(const geo::Pose& from, double height, const GlideParts& glide) const {
  std::vector<flight::Piece> upToGate = glide.reaction;
  upToGate.insert(upToGate.end(), glide.way.begin(), glide.way.end());
  const std::vector<double> heights = needs_.heightsAlong(from, upToGate, glide.approach.altitude);
  if (!std::isfinite(heights.front())) {
    return std::nullopt;
  }
  const Rolling& rolling = needs_.rolling();
  Joints joints;
  joints.pieces = glide.way;
  joints.heights.assign(heights.begin() + static_cast<std::ptrdiff_t>(glide.reaction.size()), heights.end());
  geo::Pose pose = from;
  joints.atHand = height - world_.reactionLoss;
  for (const flight::Piece& piece : glide.reaction) {
    joints.atHand -= flight::lossUpTo(world_.glide, pose, piece, piece.length);
    pose = flight::endOf(pose, piece);
  }
  if (!glide.reaction.empty() && world_.glide.bands() != nullptr) {  // losses differ by altitude: what is beyond the need is surely at hand
    joints.atHand = joints.heights.front() + std::max(0.0, height - world_.reactionLoss - heights.front());
  }
  joints.poses.push_back(pose);
  joints.rolled.assign(glide.way.size() + 1, 0.0);
  for (std::size_t i = 0; i < glide.way.size(); ++i) {
    joints.poses.push_back(flight::endOf(joints.poses.back(), glide.way[i]));
    joints.rolled[i] = i > 0 ? joints.rolled[i - 1] + rolling.between(glide.way[i - 1], glide.way[i]) : 0.0;
  }
  for (const geo::Pose& joint : joints.poses) {
    joints.directions.emplace_back(joint.heading);
  }
  joints.after = glide.approach.pieces.empty() ? flight::Piece() : glide.approach.pieces.front();
  return joints;
}

/// What rolling costs in all [m].
double GlideStraightener::rollingOf(const GlideParts& glide, const flight::Piece& tour) const {
  return needs_.rolling().of(tour, allOf(glide));
}

/// @param before  the piece that is flown before the way
std::vector<flight::Piece> GlideStraightener::pulled(const Joints& joints, const flight::Piece& before) const {
  std::vector<flight::Piece> way;
  double height = joints.atHand;
  for (std::size_t at = 0; at < joints.pieces.size();) {
    if (const std::optional<Pull> pull = farthest(joints, at, way.empty() ? before : way.back(), height)) {
      height = pull->height;
      at = pull->to;
      for (std::size_t part = 0; part < 3; ++part) {
        if (const flight::Piece piece = pull->path.piece(part); piece.length > kRounding) {
          append(piece, way);
        }
      }
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

/// One glide from a joint to the farthest one that it reaches from this height with less rolling.
std::optional<GlideStraightener::Pull> GlideStraightener::farthest(const Joints& joints, std::size_t from, const flight::Piece& before,
                                                                   double height) const {
  const Rolling& rolling = needs_.rolling();
  const std::size_t count = joints.pieces.size();
  const geo::Pose& start = joints.poses[from];
  for (std::size_t to = count; to > from + 1; --to) {
    const geo::Pose& end = joints.poses[to];
    const double low = joints.heights[to];
    if (low + world_.glide.leastLossOver(end.x - start.x, end.y - start.y) > height) {
      continue;
    }
    const flight::Piece& after = to < count ? joints.pieces[to] : joints.after;
    const double now =
        rolling.between(before, joints.pieces[from]) + joints.rolled[to - 1] - joints.rolled[from] + rolling.between(joints.pieces[to - 1], after);
    for (const Option& option : optionsBetween(joints, from, to, before, after, now - kWorthwhile)) {
      const double needed = requiredStartHeight(world_, option.path, joints.directions[from], option.radius, low, height);
      if (needed <= height) {
        const double saved = height - needed;
        const bool isOneLoss = world_.glide.bands() == nullptr;
        return Pull{to, option.path, isOneLoss ? height - flight::lossOf(option.path, flight::turnLossAt(world_.glide, option.radius)) : low + saved};
      }
    }
  }
  return std::nullopt;
}

/// Dubins glides over all radii that roll less than a limit, the one that rolls least first.
std::vector<GlideStraightener::Option> GlideStraightener::optionsBetween(const Joints& joints, std::size_t from, std::size_t to,
                                                                         const flight::Piece& before, const flight::Piece& after,
                                                                         double limit) const {
  const Rolling& rolling = needs_.rolling();
  std::vector<Option> options;
  const flight::PosePair pair(joints.poses[from], joints.directions[from], joints.poses[to], joints.directions[to]);
  const std::vector<double>& radii = world_.glide.glideRadii();
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const flight::TurnLoss loss = flight::turnLossAt(world_.glide, i);
    if (!std::isfinite(loss.turn)) {
      continue;
    }
    Option option{pair.leastLoss(radii[i], loss), i, 0.0};
    flight::Piece last = before;
    for (std::size_t part = 0; part < 3; ++part) {
      if (const flight::Piece piece = option.path.piece(part); piece.length > kRounding) {
        option.rolling += rolling.between(last, piece);
        last = piece;
      }
    }
    option.rolling += rolling.between(last, after);
    if (option.rolling < limit) {
      options.push_back(option);
    }
  }
  std::sort(options.begin(), options.end(), [](const Option& a, const Option& b) { return a.rolling < b.rolling; });
  return options;
}

}  // namespace vp::landing
