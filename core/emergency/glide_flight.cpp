#include "core/emergency/glide_flight.h"

#include "core/aircraft/glide_bands.h"
#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"
#include "core/landing/required_height.h"

#include <algorithm>
#include <cmath>

namespace vp::emergency {
namespace {

/// Course over which one leg of a turn in wind is flown at the rate of its dearest metre [rad]: ten cells of aircraft::CourseLoss.
constexpr double kCoursePart = 5.0 / 180.0 * Angle::kPi;
/// Parts shorter than this are rounding [m].
constexpr double kShortest = 1e-6;
/// Taken off an end that is only to be kept, so that rounding does not make the height at the start too low for its own glide [m].
constexpr double kRounding = 1e-6;

/// Length of a turn, flown from a course, up to where it next comes to a whole number of course parts.
double partOfTurn(double course, const flight::Piece& turn, double left) {
  const double side = static_cast<double>(static_cast<int>(turn.turn));
  const double parts = side * course / kCoursePart;
  const double toNext = (std::floor(parts + 1e-9) + 1.0 - parts) * kCoursePart * turn.radius;
  // a rest that is too short to be flown is flown with the part before it
  return left - toNext < 1e-3 ? left : toNext;
}

}  // namespace

/** Flies a piece in parts that each lose the same per metre; `use` is told of each and answers whether to go on. */
template <typename Use>
double GlideFlight::descend(geo::Pose& pose, double altitude, const flight::Piece& piece, Use use) const {
  const aircraft::GlideBands* const bands = world_->glide.bands();
  double left = piece.length;
  while (left > 0.0) {
    const std::size_t band = bands == nullptr ? 0 : bands->below(altitude);
    const aircraft::GlideModel& losses = bands == nullptr ? world_->glide : bands->between(band, band);
    const bool isTurn = piece.turn != flight::Turn::Straight;
    flight::Piece part{piece.turn, piece.radius, left};
    if (isTurn && !losses.isCalm()) {
      part.length = std::min(left, partOfTurn(pose.heading, piece, left));
    }
    const flight::TurnLoss loss =
        isTurn ? flight::turnLossOf(losses, piece.radius) : flight::TurnLoss{losses.straightLoss(), 0.0, losses.courseLossOf(0)};
    const double rate = flight::PieceLoss(part, pose.heading, loss).mostPerMetre(part.length);
    if (!(rate < std::numeric_limits<double>::infinity())) {
      return kTouches;  // the wind holds the aircraft up, or no glide at all in such a turn
    }
    double end = altitude - rate * part.length;
    if (bands != nullptr && band > 0 && end < bands->bottom(band)) {
      part.length = (altitude - bands->bottom(band)) / rate;
      end = bands->bottom(band);
      if (part.length < kShortest) {
        altitude = end;
        continue;
      }
    }
    if (!use(pose, part, altitude, end)) {
      return kTouches;
    }
    pose = flight::endOf(pose, part);
    altitude = end;
    left = left - part.length < kShortest ? 0.0 : left - part.length;
  }
  return altitude;
}

bool GlideFlight::isClear(const geo::Pose& from, const flight::Piece& part, double altitude, double end) const {
  const double rate = (altitude - end) / part.length;
  return landing::requiredStartHeight(world_->terrain, from, part, rate, world_->clearance, end - kRounding, altitude) <= altitude;
}

double GlideFlight::endOf(const flight::DubinsPath& path, std::size_t radius, double altitude) const {
  if (world_->glide.isCalm() && world_->glide.bands() == nullptr) {
    const flight::TurnLoss loss = flight::turnLossAt(world_->glide, radius);
    const double end = altitude - flight::lossOf(path, loss);
    const double needed = landing::requiredStartHeight(*world_, path, flight::Direction(path.start.heading), loss, end - kRounding, altitude);
    return needed <= altitude ? end : kTouches;
  }
  geo::Pose pose = path.start;
  const auto clear = [this](const geo::Pose& from, const flight::Piece& part, double start, double end) { return isClear(from, part, start, end); };
  for (std::size_t i = 0; i < 3 && altitude > kTouches; ++i) {
    altitude = descend(pose, altitude, path.piece(i), clear);
  }
  return altitude;
}

double GlideFlight::fly(geo::Pose& pose, double altitude, const std::vector<flight::Piece>& pieces, std::vector<mission::LandingLeg>* legs) const {
  const auto use = [&](const geo::Pose& from, const flight::Piece& part, double start, double end) {
    if (!isClear(from, part, start, end)) {
      return false;
    }
    if (legs != nullptr) {
      legs->push_back({part, end});
    }
    return true;
  };
  for (const flight::Piece& piece : pieces) {
    altitude = descend(pose, altitude, piece, use);
    if (altitude <= kTouches) {
      return kTouches;
    }
  }
  return altitude;
}

double GlideFlight::flyApproach(const landing::Approach& approach, double altitude, std::vector<mission::LandingLeg>& legs) const {
  geo::Pose pose = approach.gate;
  for (const flight::Piece& piece : approach.pieces) {
    if (world_->approach.slope && piece.turn == flight::Turn::Straight) {
      altitude -= tan(*world_->approach.slope) * piece.length;
      legs.push_back({piece, altitude});
      pose = flight::endOf(pose, piece);
      continue;
    }
    altitude = descend(pose, altitude, piece, [&legs](const geo::Pose&, const flight::Piece& part, double, double end) {
      legs.push_back({part, end});
      return true;
    });
  }
  return altitude;
}

namespace {

/// What an approach loses in legs beyond what its curve does [m].
double lostInLegs(const landing::World& world, const landing::Approach& approach) {
  if (world.glide.isCalm() && world.glide.bands() == nullptr) {
    return 0.0;
  }
  std::vector<mission::LandingLeg> legs;
  const double flown = GlideFlight(world).flyApproach(approach, approach.altitude, legs);
  geo::Pose pose = approach.gate;
  double altitude = approach.altitude;
  for (const flight::Piece& piece : approach.pieces) {
    altitude = world.approach.slope && piece.turn == flight::Turn::Straight ? altitude - tan(*world.approach.slope) * piece.length
                                                                            : flight::heightAlong(world.glide, pose, piece, altitude, piece.length);
    pose = flight::endOf(pose, piece);
  }
  return std::max(0.0, altitude - flown);
}

}  // namespace

Result<landing::Approach> approachInLegs(const landing::World& world, std::size_t site) {
  Result<landing::Approach> approach = landing::approachTo(world, site);
  if (approach) {
    approach->altitude += lostInLegs(world, *approach);
  }
  return approach;
}

}  // namespace vp::emergency
