#include "core/landing/glide_needs.h"

#include "core/aircraft/glide_bands.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"
#include "core/landing/required_height.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::landing {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kSameRadius = 1e-9;  // relative
constexpr double kNoLength = 1e-6;    // m: no part of a glide

double lengthOf(const std::vector<flight::Piece>& pieces) {
  double length = 0.0;
  for (const flight::Piece& piece : pieces) {
    length += piece.length;
  }
  return length;
}

/// Moves pieces of this length in all from the front of a glide; a piece over its end is cut. @return false if it is shorter
bool takeFront(double length, std::vector<flight::Piece>& glide, std::vector<flight::Piece>& front) {
  std::size_t whole = 0;
  while (whole < glide.size() && glide[whole].length <= length + kNoLength) {
    length -= glide[whole].length;
    ++whole;
  }
  front.assign(glide.begin(), glide.begin() + static_cast<std::ptrdiff_t>(whole));
  glide.erase(glide.begin(), glide.begin() + static_cast<std::ptrdiff_t>(whole));
  if (length > kNoLength) {
    if (glide.empty()) {
      return false;
    }
    front.push_back(glide.front());
    front.back().length = length;
    glide.front().length -= length;
  }
  return true;
}

/// The same from its back, thrown away.
bool dropBack(double length, std::vector<flight::Piece>& glide) {
  while (!glide.empty() && glide.back().length <= length + kNoLength) {
    length -= glide.back().length;
    glide.pop_back();
  }
  if (length > kNoLength) {
    if (glide.empty()) {
      return false;
    }
    glide.back().length -= length;
  }
  return true;
}

}  // namespace

GlideNeeds::GlideNeeds(const World& world, std::optional<int> onlySite) : world_(world), rolling_(world), radii_(world.glide.glideRadii()) {
  radii_.push_back(world.glide.tourRadius());
  for (std::size_t site = 0; site < world.sites.size(); ++site) {
    approaches_.emplace_back();
    if (onlySite && *onlySite != static_cast<int>(site)) {
      continue;
    }
    if (Result<Approach> approach = approachTo(world, site)) {
      approaches_.back() = std::move(*approach);
    }
  }
}

std::optional<GlideParts> GlideNeeds::partsOf(const std::vector<flight::Piece>& glide, int site) const {
  if (site < 0 || site >= static_cast<int>(approaches_.size()) || !approaches_[static_cast<std::size_t>(site)]) {
    return std::nullopt;
  }
  GlideParts parts;
  parts.approach = *approaches_[static_cast<std::size_t>(site)];
  parts.way = glide;
  if (!dropBack(lengthOf(parts.approach.pieces), parts.way) || !takeFront(world_.reactionLength, parts.way, parts.reaction)) {
    return std::nullopt;
  }
  return parts;
}

std::optional<std::size_t> GlideNeeds::indexOf(const flight::Piece& piece) const {
  if (piece.turn == flight::Turn::Straight) {
    return 0;
  }
  const auto known =
      std::find_if(radii_.begin(), radii_.end(), [&](double radius) { return std::abs(radius - piece.radius) <= kSameRadius * radius; });
  return known == radii_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(known - radii_.begin()));
}

double GlideNeeds::before(const geo::Pose& from, const flight::Piece& piece, double clearance, double end) const {
  const std::optional<std::size_t> index = indexOf(piece);
  if (!index || !std::isfinite(end)) {
    return kInfinite;
  }
  const auto needed = [&](const aircraft::GlideModel& cover, double low, double giveUpAbove) {
    const flight::PieceLoss loss(piece, from.heading, flight::turnLossAt(cover, *index));
    return std::isfinite(loss.upTo(piece.length)) ? requiredStartHeight(world_.terrain, from, piece, loss, clearance, low, giveUpAbove) : kInfinite;
  };
  return aircraft::leastStart(world_.glide, end, needed);
}

std::vector<double> GlideNeeds::heightsAlong(const geo::Pose& from, const std::vector<flight::Piece>& pieces, double end) const {
  std::vector<geo::Pose> poses{from};
  for (const flight::Piece& piece : pieces) {
    poses.push_back(flight::endOf(poses.back(), piece));
  }
  std::vector<double> heights(pieces.size() + 1, end);
  for (std::size_t i = pieces.size(); i-- > 0;) {
    heights[i] = before(poses[i], pieces[i], world_.clearance, heights[i + 1]);
  }
  return heights;
}

GlideNeed GlideNeeds::of(const geo::Pose& from, const GlideParts& glide, const flight::Piece& tour) const {
  std::vector<flight::Piece> pieces = glide.reaction;
  pieces.insert(pieces.end(), glide.way.begin(), glide.way.end());
  GlideNeed need;
  need.altitude = heightsAlong(from, pieces, glide.approach.altitude).front() + world_.reactionLoss;
  need.withRolling = -kInfinite;
  if (!world_.rollRate_dps || !std::isfinite(need.altitude)) {
    return need;
  }
  std::vector<flight::Piece> whole = pieces;
  whole.insert(whole.end(), glide.approach.pieces.begin(), glide.approach.pieces.end());
  const std::vector<double> rolling = rolling_.along(tour, whole);
  if (rolling.empty() || rolling.back() <= world_.clearance) {
    need.withRolling = need.altitude - world_.clearance + (rolling.empty() ? 0.0 : rolling.back());  // no place asks for more
    return need;
  }
  std::vector<geo::Pose> poses{from};
  for (const flight::Piece& piece : pieces) {
    poses.push_back(flight::endOf(poses.back(), piece));
  }
  // at the gate: the approach keeps the clearance above the ground from Approach::altitude, so it keeps rolling.back() from so much more
  double height = glide.approach.altitude - world_.clearance + rolling.back();
  for (std::size_t i = pieces.size(); i-- > 0;) {
    height = before(poses[i], pieces[i], rolling[i], height);
  }
  need.withRolling = height + world_.reactionLoss;
  return need;
}

}  // namespace vp::landing
