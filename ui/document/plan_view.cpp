#include "ui/document/plan_view.h"

#include "core/aircraft/glide_bands.h"
#include "core/base/expect.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"
#include "core/landing/required_height.h"
#include "core/mission/glide_conditions.h"
#include "core/tour/profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::document {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

int partsOf(double length, double step) {
  return std::max(1, static_cast<int>(std::ceil(length / step - 1e-9)));
}

/// The part of a piece that is left after `flown` metres.
flight::Piece rest(const flight::Piece& piece, double flown) {
  return {piece.turn, piece.radius, std::max(0.0, piece.length - flown)};
}

}  // namespace

PlanView::PlanView(std::shared_ptr<const mission::Plan> plan, std::shared_ptr<const TerrainData> terrain)
    : plan_(std::move(plan)), terrain_(std::move(terrain)) {
  VP_EXPECT(plan_ != nullptr && terrain_ != nullptr && !plan_->tour.empty());
  glide_ = aircraft::GlideModel(plan_->mission.aircraft, mission::glideConditionsOf(plan_->mission, plan_->sites));
  for (const mission::DecisionPoint& point : plan_->tour) {
    distances_.push_back(length_);
    length_ += point.onward.length;
  }
  distances_.push_back(length_);
  sampleTour();
  addPitchOnly();
}

TourState PlanView::stateAt(std::size_t point, double beyond) const {
  const mission::DecisionPoint& from = plan_->tour[point];
  const mission::DecisionPoint& to = plan_->tour[(point + 1) % plan_->tour.size()];
  const double length = from.onward.length;
  const double flown = std::clamp(beyond, 0.0, length);
  TourState state;
  state.distance = distances_[point] + flown;
  state.pose = flight::poseAfter(from.pose, from.onward, flown);
  state.altitude = length > 0.0 ? from.altitude + (to.altitude - from.altitude) * flown / length : from.altitude;
  state.ground = terrain_->grid->upperAt(state.pose.point());
  state.point = static_cast<int>(point);
  state.safeAltitude = from.safeAltitude;
  if (flown > 0.0) {
    const flight::Piece onward = rest(from.onward, flown);
    const double radius = onward.turn == flight::Turn::Straight ? glide_.tourRadius() : onward.radius;
    const double lostAtOnce = glide_.bands() != nullptr ? plan_->mission.safety.reactionLoss.si() : 0.0;  // heights of the tour, and those after it
    const auto needed = [&](const aircraft::GlideModel& cover, double end, double /*giveUpAbove*/) {
      const auto byCourse = cover.courseLoss(radius);
      const flight::PieceLoss loss(onward, state.pose.heading, {cover.straightLoss(), cover.lossAt(radius), byCourse.get()});
      return landing::requiredStartHeight(terrain_->pyramid, state.pose, onward, loss, plan_->mission.safety.clearance.si(), end + lostAtOnce);
    };
    state.safeAltitude = aircraft::leastStart(glide_, to.safeAltitude - lostAtOnce, needed);
  }
  return state;
}

TourState PlanView::at(double distance) const {
  double wrapped = length_ > 0.0 ? std::fmod(distance, length_) : 0.0;
  wrapped = wrapped < 0.0 ? wrapped + length_ : wrapped;
  const auto after = std::upper_bound(distances_.begin(), distances_.end() - 1, wrapped);
  const auto point = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - distances_.begin() - 1));
  return stateAt(point, wrapped - distances_[point]);
}

double PlanView::corridorAt(geo::Point p) const {
  const terrain::ElevationGrid& grid = *terrain_->grid;
  double highest = -kInfinite;
  const int south = grid.rowOf(p.y - kCorridor);
  const int north = grid.rowOf(p.y + kCorridor);
  for (int row = south; row <= north; ++row) {
    const double dy = grid.originY() + (row + 0.5) * grid.cellSize() - p.y;
    const double half = std::sqrt(std::max(0.0, kCorridor * kCorridor - dy * dy));
    const int east = grid.columnOf(p.x + half);
    for (int column = grid.columnOf(p.x - half); column <= east; ++column) {
      const float value = grid.upperInCell(column, row);
      highest = std::isfinite(value) ? std::max(highest, static_cast<double>(value)) : highest;
    }
  }
  return highest;
}

void PlanView::sampleTour() {
  for (std::size_t i = 0; i < plan_->tour.size(); ++i) {
    const double length = plan_->tour[i].onward.length;
    const int parts = partsOf(length, kSampleStep);
    for (int k = 0; k < parts; ++k) {
      samples_.push_back({stateAt(i, length * k / parts), 0.0, 0.0});
    }
  }
  samples_.push_back(samples_.front());
  samples_.back().state.distance = length_;
  lowestAltitude_ = kInfinite;
  highestAltitude_ = -kInfinite;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    TourSample& sample = samples_[i];
    sample.corridor = std::max(corridorAt(sample.state.pose.point()), std::isfinite(sample.state.ground) ? sample.state.ground : -kInfinite);
    lowestAltitude_ = std::min(lowestAltitude_, sample.state.altitude);
    highestAltitude_ = std::max(highestAltitude_, sample.state.altitude);
    leastMargin_ = sample.state.glideMargin() < samples_[leastMargin_].state.glideMargin() ? i : leastMargin_;
    leastClearance_ = sample.state.clearance() < samples_[leastClearance_].state.clearance() ? i : leastClearance_;
    highestGround_ = sample.state.ground > samples_[highestGround_].state.ground ? i : highestGround_;
  }
}

void PlanView::addPitchOnly() {
  const std::size_t count = samples_.size() - 1;
  const double clearance = plan_->mission.safety.clearance.si();
  std::vector<double> step(count);
  std::vector<double> altitude(count);
  for (std::size_t i = 0; i < count; ++i) {
    step[i] = samples_[i + 1].state.distance - samples_[i].state.distance;
    altitude[i] = samples_[i].state.ground + clearance;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const TourState& state = samples_[i].state;
    const mission::DecisionPoint& point = plan_->tour[static_cast<std::size_t>(state.point)];
    if (point.target >= 0 && state.distance == distances_[static_cast<std::size_t>(state.point)]) {
      altitude[i] = std::max(altitude[i], plan_->targets[static_cast<std::size_t>(point.target)].altitude);
    }
  }
  const aircraft::AircraftProfile& aircraft = plan_->mission.aircraft;
  tour::raiseForPitchAround(step, altitude, {tan(aircraft.maxClimb), tan(aircraft.maxDescent)});
  for (std::size_t i = 0; i < count; ++i) {
    samples_[i].pitchOnly = altitude[i];
  }
  samples_.back().pitchOnly = samples_.front().pitchOnly;
}

std::optional<double> PlanView::distanceOfTarget(int target) const {
  for (std::size_t i = 0; i < plan_->tour.size(); ++i) {
    if (plan_->tour[i].target == target) {
      return distances_[i];
    }
  }
  return std::nullopt;
}

std::optional<double> PlanView::nearest(geo::Point place, double within) const {
  std::optional<double> best;
  double bestDistance = within;
  for (std::size_t i = 0; i + 1 < samples_.size(); ++i) {
    const geo::Point a = samples_[i].state.pose.point();
    const geo::Point b = samples_[i + 1].state.pose.point();
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double square = dx * dx + dy * dy;
    const double t = square > 0.0 ? std::clamp(((place.x - a.x) * dx + (place.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
    const double away = geo::distance(place, {a.x + t * dx, a.y + t * dy});
    if (away <= bestDistance) {
      bestDistance = away;
      best = samples_[i].state.distance + t * (samples_[i + 1].state.distance - samples_[i].state.distance);
    }
  }
  return best;
}

void addGlidePoint(EngineOut& glide, const geo::Pose& pose, double altitude, double ground) {
  glide.path.push_back({glide.length, pose, altitude, ground});
  if (glide.path.size() == 1 || altitude - ground < glide.leastClearance) {
    glide.leastClearance = altitude - ground;
    glide.leastClearanceAt = glide.path.size() - 1;
  }
}

EngineOut PlanView::engineOutAt(double distance) const {
  EngineOut out;
  out.from = at(distance);
  const auto point = static_cast<std::size_t>(out.from.point);
  const double beyond = out.from.distance - distances_[point];
  std::vector<flight::Piece> pieces;
  const mission::Witness* witness = &plan_->tour[point].witness;
  if (beyond > 0.0) {
    pieces.push_back(rest(plan_->tour[point].onward, beyond));
    witness = &plan_->tour[(point + 1) % plan_->tour.size()].witness;
  }
  pieces.insert(pieces.end(), witness->pieces.begin(), witness->pieces.end());
  out.site = witness->site;
  out.margin = out.from.glideMargin();

  geo::Pose pose = out.from.pose;
  double altitude = out.from.altitude;
  const auto add = [&](const geo::Pose& at, double height) { addGlidePoint(out, at, height, terrain_->grid->upperAt(at.point())); };
  add(pose, altitude);
  for (const flight::Piece& piece : pieces) {
    const int parts = piece.length > 0.0 ? partsOf(piece.length, kGlideSpacing) : 0;
    const double before = out.length;
    for (int k = 1; k <= parts; ++k) {
      const double flown = piece.length * k / parts;
      out.length = before + flown;
      add(flight::poseAfter(pose, piece, flown), flight::heightAlong(glide_, pose, piece, altitude, flown));
    }
    altitude = flight::heightAlong(glide_, pose, piece, altitude, piece.length);
    out.seconds += flight::glideSeconds(glide_, pose, piece);
    pose = flight::endOf(pose, piece);
  }
  if (out.site >= 0) {
    out.surplus = altitude - plan_->sites[static_cast<std::size_t>(out.site)].site.elevation.metres();
  }
  return out;
}

}  // namespace vp::document
