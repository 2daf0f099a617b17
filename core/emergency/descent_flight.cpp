#include "core/emergency/descent_flight.h"

#include "core/aircraft/glide_bands.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"
#include "core/landing/required_height.h"
#include "core/mission/glide_conditions.h"

#include <algorithm>
#include <cmath>

namespace vp::emergency {
namespace {

constexpr double kCoursePart = 5.0 / 180.0 * Angle::kPi;  // rad of course in one leg of a turn in wind: ten cells of aircraft::CourseLoss
constexpr double kShortest = 1e-6;                        // m: parts shorter than this are rounding
constexpr double kRounding = 1e-6;                        // m
constexpr double kSameAltitude = 1e-4;                    // m: ends this near are what was asked for
constexpr int kHalvings = 60;

/// Length of a turn, flown from a course, up to where it next comes to a whole number of course parts.
double partOfTurn(double course, const flight::Piece& turn, double left) {
  const double side = static_cast<double>(static_cast<int>(turn.turn));
  const double parts = side * course / kCoursePart;
  const double toNext = (std::floor(parts + 1e-9) + 1.0 - parts) * kCoursePart * turn.radius;
  return left - toNext < 1e-3 ? left : toNext;
}

/// Greatest part of a wind of the sector along any course of [from, from + turned]; below zero where all are headwinds [m/s].
double mostAlong(const air::WindSector& wind, double from, double turned) {
  const double middle = from + 0.5 * turned;
  const double off = std::max(0.0, std::abs(wrapPi(wind.towards() - middle)) - wind.spread() - 0.5 * std::abs(turned));
  const double share = std::cos(off);
  return share * (share > 0.0 ? wind.mostSpeed : wind.leastSpeed);
}

/// Least share of a rate of descent that a change of the wind with height leaves: 1 / (1 + v sigma / g), sigma bounded by both winds' greatest
/// speeds.
double shearShare(const std::vector<air::WindLayer>& layers, double airspeed) {
  double shear = 0.0;
  for (std::size_t i = 0; i + 1 < layers.size(); ++i) {
    const double height = (layers[i + 1].altitude - layers[i].altitude).si();
    const double speeds = layers[i].wind.mostSpeed + layers[i + 1].wind.mostSpeed;
    shear = speeds > 0.0 ? std::max(shear, speeds / std::max(height, 1e-3)) : shear;
  }
  return 1.0 / (1.0 + airspeed * shear / kGravity.si());
}

}  // namespace

DescentFlight::DescentFlight(const landing::World& world, const mission::Mission& mission)
    : world_(&world), mission_(&mission), isCalm_(world.glide.isCalm()) {
  const aircraft::SpeedRange speeds = aircraft::glideSpeeds(mission.aircraft, mission::glideConditionsOf(mission, world.sites).air);
  slowest_ = speeds.least;
  fastest_ = speeds.most;
  steepestInAir_ = world.steepestDescent ? tan(*world.steepestDescent) : 0.0;
  shear_ = isCalm_ ? 1.0 : shearShare(mission.wind, fastest_);
}

const aircraft::GlideModel& DescentFlight::lossesOf(std::size_t band) const {
  const aircraft::GlideBands* const bands = world_->glide.bands();
  return bands == nullptr ? world_->glide : bands->between(band, band);
}

const DescentFlight::Known& DescentFlight::known(double radius, std::size_t band) {
  const auto found = std::find_if(known_.begin(), known_.end(), [&](const Known& one) { return one.radius == radius && one.band == band; });
  if (found != known_.end()) {
    return *found;
  }
  const aircraft::GlideModel& losses = lossesOf(band);
  known_.push_back({radius, band, losses.courseLoss(radius), losses.lossAt(radius)});
  return known_.back();
}

double DescentFlight::steepest(double course, const flight::Piece& part) const {
  if (isCalm_ || steepestInAir_ == 0.0) {
    return steepestInAir_;
  }
  const double turned = part.turn == flight::Turn::Straight ? 0.0 : static_cast<double>(static_cast<int>(part.turn)) * part.length / part.radius;
  double along = -std::numeric_limits<double>::infinity();
  for (const air::WindLayer& layer : mission_->wind) {
    along = std::max(along, mostAlong(layer.wind, course, turned));
  }
  return steepestInAir_ * shear_ * std::min(slowest_ / (slowest_ + along), fastest_ / (fastest_ + along));
}

DescentRange DescentFlight::inBand(double course, const flight::Piece& part, std::size_t band) {
  DescentRange range;
  if (part.turn == flight::Turn::Straight) {
    const aircraft::GlideModel& losses = lossesOf(band);
    range.least = isCalm_ ? losses.straightLoss() : losses.courseLossOf(0)->straightRate(std::cos(course), std::sin(course));
  } else {
    const Known& turn = known(part.radius, band);
    range.least = turn.byCourse == nullptr
                      ? turn.still
                      : turn.byCourse->mostInTurn(course, static_cast<double>(static_cast<int>(part.turn)) * part.length / part.radius);
  }
  range.most = std::max(range.least, steepest(course, part));
  return range;
}

DescentRange DescentFlight::rangeOf(double course, const flight::Piece& part, double altitude) {
  const aircraft::GlideBands* const bands = world_->glide.bands();
  return inBand(course, part, bands == nullptr ? 0 : bands->below(altitude));
}

double DescentFlight::fly(geo::Pose& pose, double altitude, const flight::Piece& piece, double share, std::vector<mission::LandingLeg>* legs) {
  const aircraft::GlideBands* const bands = world_->glide.bands();
  const bool isCut = piece.turn != flight::Turn::Straight && !isCalm_;
  double left = piece.length;
  while (left > 0.0) {
    const std::size_t band = bands == nullptr ? 0 : bands->below(altitude);
    flight::Piece part{piece.turn, piece.radius, isCut ? std::min(left, partOfTurn(pose.heading, piece, left)) : left};
    const double rate = inBand(pose.heading, part, band).at(share);
    if (!(rate < std::numeric_limits<double>::infinity())) {
      return kNoGlide;
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
    if (legs != nullptr) {
      legs->push_back({part, end});
    }
    pose = flight::endOf(pose, part);
    altitude = end;
    left = left - part.length < kShortest ? 0.0 : left - part.length;
  }
  return altitude;
}

double DescentFlight::fly(geo::Pose& pose, double altitude, const std::vector<flight::Piece>& pieces, double share,
                          std::vector<mission::LandingLeg>* legs) {
  for (const flight::Piece& piece : pieces) {
    altitude = fly(pose, altitude, piece, share, legs);
    if (altitude == kNoGlide) {
      return kNoGlide;
    }
  }
  return altitude;
}

std::optional<Descent> DescentFlight::descendTo(const geo::Pose& pose, double altitude, const std::vector<flight::Piece>& pieces, double end) {
  const auto endAt = [&](double share, std::vector<mission::LandingLeg>* legs) {
    geo::Pose at = pose;
    return fly(at, altitude, pieces, share, legs);
  };
  Descent descent;
  const double highest = endAt(0.0, nullptr);
  const double lowest = endAt(1.0, nullptr);
  if (!(highest >= end)) {
    return std::nullopt;
  }
  if (lowest >= end) {
    descent.share = 1.0;
  } else {
    // linear but for the edges of bands; `low` always ends at `end` or above
    double low = 0.0;
    double high = 1.0;
    double endLow = highest;
    double endHigh = lowest;
    for (int i = 0; i < kHalvings && endLow - end > kSameAltitude; ++i) {
      const double secant = low + (high - low) * (endLow - end) / (endLow - endHigh);
      const double share = std::max(low, std::min(i % 3 == 2 ? 0.5 * (low + high) : secant - 1e-9, high));
      const double reached = endAt(share, nullptr);
      (reached >= end ? low : high) = share;
      (reached >= end ? endLow : endHigh) = reached;
    }
    descent.share = low;
  }
  descent.surplus = endAt(descent.share, &descent.legs) - end;
  return descent;
}

bool DescentFlight::isClear(const geo::Pose& pose, const flight::Piece& piece, double altitude, double end) const {
  if (world_->terrain.upperIn(flight::boxOf(pose, piece, 0.0, piece.length).grown(1e-3)) + world_->clearance <= end) {
    return true;
  }
  const double rate = (altitude - end) / piece.length;
  return landing::requiredStartHeight(world_->terrain, pose, piece, rate, world_->clearance, end - kRounding, altitude) <= altitude;
}

bool DescentFlight::isClear(const geo::Pose& pose, double altitude, const std::vector<mission::LandingLeg>& legs) const {
  geo::Pose at = pose;
  for (const mission::LandingLeg& leg : legs) {
    if (!isClear(at, leg.piece, altitude, leg.endAltitude)) {
      return false;
    }
    at = flight::endOf(at, leg.piece);
    altitude = leg.endAltitude;
  }
  return true;
}

}  // namespace vp::emergency
