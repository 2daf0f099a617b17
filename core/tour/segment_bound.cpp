#include "core/tour/segment_bound.h"

#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::tour {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The sums of a bound and of the segment that it bounds are made in different order [relative].
constexpr double kRounding = 1.0 - 1e-12;
/// A bound this little above the ceiling [m] may be one of a segment that just fits.
constexpr double kCeilingSlack = 1e-6;

}  // namespace

SegmentBound::SegmentBound(const landing::World& world, const landing::AltitudeFloor& floor, const Detours& detours, const SegmentSettings& settings)
    : world_(world),
      altitudeFloor_(floor),
      detours_(detours),
      settings_(settings),
      losses_(flight::bandLossesOf(world.glide, world.glide.glideRadii().size())),
      originX_(world.terrain.grid().originX()),
      originY_(world.terrain.grid().originY()),
      perCell_(1.0 / world.terrain.grid().cellSize()) {
  leastTurn_ = kInfinite;
  for (const flight::TurnLoss& losses : losses_) {
    leastTurn_ = std::min(leastTurn_, losses.turn * bandRounding());
  }
}

double SegmentBound::endFloor(const VisitPose& visit) const {
  return std::max(visit.altitude, visit.safe ? visit.safe->altitude : altitudeFloor_.at(visit.pose.point()));
}

double SegmentBound::penalty(const VisitPose& from, const VisitPose& to, double first, double last) const {
  return 0.5 * settings_.beta * (first - from.altitude + last - to.altitude);
}

double SegmentBound::plain(const VisitPose& from, const VisitPose& to) const {
  const double first = endFloor(from);
  const double last = endFloor(to);
  if (!(std::max(first, last) <= settings_.ceiling + kCeilingSlack)) {
    return kInfinite;
  }
  const double dx = to.pose.x - from.pose.x;
  const double dy = to.pose.y - from.pose.y;
  return (std::sqrt(dx * dx + dy * dy + (last - first) * (last - first)) + penalty(from, to, first, last)) * kRounding;
}

/// The next decision point, `loss` metres of glide after the one before. @return false over ground that no tour crosses
bool SegmentBound::addPoint(double x, double y, double distance, double loss) {
  const auto& grid = world_.terrain.grid();
  const double column = (x - originX_) * perCell_;
  const double row = (y - originY_) * perCell_;
  if (!(column >= 0.0 && row >= 0.0 && column < grid.columns() && row < grid.rows())) {
    return false;
  }
  const double clear = static_cast<double>(grid.upperInCell(static_cast<int>(column), static_cast<int>(row))) + world_.clearance;
  const double safe = altitudeFloor_.at({x, y});
  const double here = std::max(clear, safe);
  if (!floor_.empty()) {
    // the interval before clears what is known of its ground, and a glide along it arrives above this point's floor
    const double over = std::max(clear, lastGround_) + world_.reactionLoss;
    floor_.back() = std::max({floor_.back(), over, std::max(safe, over) + loss});
    floor_.push_back(std::max(over, here));
  } else {
    floor_.push_back(here);
  }
  distance_.push_back(distance);
  lastGround_ = clear;
  lastLoss_ = loss;
  return floor_.back() <= settings_.ceiling + kCeilingSlack;
}

/// Decision points of pieces_, each part turned from the last by multiplication: within 1e-9 m of SegmentBuilder's.
bool SegmentBound::sample(const VisitPose& from) {
  distance_.clear();
  floor_.clear();
  double x = from.pose.x;
  double y = from.pose.y;
  double east = std::cos(from.pose.heading);
  double north = std::sin(from.pose.heading);
  double heading = from.pose.heading;
  double distance = 0.0;
  if (!addPoint(x, y, 0.0, 0.0)) {
    return false;
  }
  for (const flight::Piece& piece : pieces_) {
    const int count = static_cast<int>(std::ceil(piece.length / settings_.step));
    const double part = piece.length / count;
    if (piece.turn == flight::Turn::Straight) {
      double loss = kInfinite;
      for (const flight::TurnLoss& losses : losses_) {
        loss = std::min(loss, flight::PieceLoss(piece, heading, losses).upTo(part));
      }
      loss *= bandRounding();
      for (int i = 1; i <= count; ++i) {
        distance += part;
        if (!addPoint(x + east * part * i, y + north * part * i, distance, loss)) {
          return false;
        }
      }
      x += east * piece.length;
      y += north * piece.length;
      continue;
    }
    const double side = static_cast<double>(static_cast<int>(piece.turn));
    const flight::PieceLoss lost(piece, heading, losses_.front());
    heading += side * piece.length / piece.radius;
    const double c = std::cos(part / piece.radius);
    const double s = side * std::sin(part / piece.radius);
    const double centreX = x - side * piece.radius * north;
    const double centreY = y + side * piece.radius * east;
    for (int i = 1; i <= count; ++i) {
      const double e = east * c - north * s;
      north = north * c + east * s;
      east = e;
      distance += part;
      x = centreX + side * piece.radius * north;
      y = centreY - side * piece.radius * east;
      const double loss = losses_.size() > 1                    ? leastTurn_ * part
                          : losses_.front().byCourse == nullptr ? lost.upTo(part)
                                                                : lost.upTo(part * i) - lost.upTo(part * (i - 1));
      if (!addPoint(x, y, distance, loss)) {
        return false;
      }
    }
  }
  return distance_.size() > 1;
}

SegmentCost SegmentBound::leg(const VisitPose& from, const VisitPose& to) {
  const double first = endFloor(from);
  const double last = endFloor(to);
  if (!(std::max(first, last) <= settings_.ceiling + kCeilingSlack)) {
    return {kInfinite, kInfinite};
  }
  const double radius = world_.glide.tourRadius();
  pieces_.clear();
  if (from.target == to.target) {
    pieces_.push_back({flight::Turn::Left, radius, 2.0 * Angle::kPi * radius});
  } else {
    const flight::DubinsPath path = flight::shortestDubins(from.pose, to.pose, radius);
    if (detours_.hasAny(from.target, to.target)) {
      // whichever way it flies, it is no shorter
      return {(std::hypot(path.length(), last - first) + penalty(from, to, first, last)) * kRounding, std::max(first, last)};
    }
    flight::appendPieces(path, pieces_);
  }
  if (!sample(from)) {
    return {kInfinite, kInfinite};
  }
  floor_.front() = std::max(floor_.front(), first);
  floor_.back() = std::max(floor_.back(), last);
  if (to.safe) {
    floor_[floor_.size() - 2] = std::max(floor_[floor_.size() - 2], to.safe->altitude + lastLoss_);
  }
  raiseEndsForPitch(distance_, floor_, settings_.pitch);
  concaveHull(distance_, floor_, hull_);
  double length = 0.0;
  double peak = floor_.front();
  for (std::size_t h = 1; h < hull_.size(); ++h) {
    const double dx = distance_[hull_[h]] - distance_[hull_[h - 1]];
    const double dz = floor_[hull_[h]] - floor_[hull_[h - 1]];
    length += std::sqrt(dx * dx + dz * dz);
    peak = std::max(peak, floor_[hull_[h]]);
  }
  const bool isTooHigh = peak > settings_.ceiling + kCeilingSlack;
  return {isTooHigh ? kInfinite : (length + penalty(from, to, floor_.front(), floor_.back())) * kRounding, peak};
}

Result<std::shared_ptr<const landing::AltitudeFloor>> buildFloor(const landing::World& world, const std::vector<VisitPose>& visits, const Job& job) {
  landing::AltitudeFloorOptions options;
  options.finest = 0.5 * world.glide.tourRadius();
  for (const VisitPose& visit : visits) {
    options.detail = options.detail.value_or(geo::Box{});
    options.detail->add(visit.pose.point());
  }
  Result<landing::AltitudeFloor> built = landing::AltitudeFloor::build(world, options, job);
  if (!built) {
    return forward(built);
  }
  return std::make_shared<const landing::AltitudeFloor>(std::move(*built));
}

}  // namespace vp::tour
