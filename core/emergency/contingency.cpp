#include "core/emergency/contingency.h"

#include "core/flight/curve_sampling.h"
#include "core/risk/people_under.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::emergency {
namespace {

constexpr std::size_t kHoldsTried = 2;  // of the areas of greatest utility
constexpr double kShortest = 1e-6;      // m

void append(Pieces& pieces, const Pieces& more) {
  for (const flight::Piece& piece : more) {
    if (piece.length > kShortest) {
      pieces.push_back(piece);
    }
  }
}

/// Lowest-length way of the four types.
std::optional<Pieces> shortestWay(const geo::Pose& from, const geo::Pose& to, double radius) {
  std::optional<Pieces> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t type = 0; type < kDubinsTypes; ++type) {
    std::optional<Pieces> way = dubinsWay(from, to, radius, type);
    double length = 0.0;
    for (const flight::Piece& piece : way.value_or(Pieces{})) {
      length += piece.length;
    }
    if (way && length < least) {
      least = length;
      best = std::move(way);
    }
  }
  return best;
}

double elevationOf(const LandingRequest& request, const landing::Approach& approach) {
  return request.world->sites[static_cast<std::size_t>(approach.site)].site.elevation.metres();
}

}  // namespace

double searchRadius(const landing::World& world, const GradientOptions& options) {
  const double wide = world.glide.radiusOf(options.turnBank);
  return world.glide.glideRadii().empty() ? wide : std::max(wide, world.glide.glideRadii().front());
}

std::shared_ptr<const risk::DescentRisk> descentRiskOf(const LandingRequest& request, const landing::Approach& approach,
                                                       const GradientOptions& options) {
  std::shared_ptr<const risk::Population> population;
  double airspeed = request.world->glide.airspeed();
  if (const auto* const descent = dynamic_cast<const risk::DescentRisk*>(request.risk.get())) {
    population = descent->population();
    airspeed = descent->window().airspeed;
  } else if (const auto* const people = dynamic_cast<const risk::PeopleUnder*>(request.risk.get())) {
    population = people->population();
  }
  const double ground = std::min(elevationOf(request, approach), approach.altitude);
  const double top = std::min(request.altitude, ground + options.crossover.si());
  if (population == nullptr || !(top > approach.altitude)) {
    return nullptr;
  }
  DescentFlight flight(*request.world, *request.mission);
  const double bearing = std::atan2(approach.gate.y - request.pose.y, approach.gate.x - request.pose.x);
  const double slope = flight.rangeOf(bearing, {flight::Turn::Straight, 0.0, 1.0}, top).at(0.5);
  if (!std::isfinite(slope)) {
    return nullptr;
  }
  const risk::DescentWindow window{top, approach.altitude, ground, slope, airspeed};
  const auto asked = std::dynamic_pointer_cast<const risk::DescentRisk>(request.risk);
  return asked != nullptr && asked->window() == window ? asked : std::make_shared<const risk::DescentRisk>(population, window);
}

Contingency::Contingency(const LandingRequest& request, const landing::Approach& approach, const GradientOptions& options, const HoldingAreas* areas)
    : request_(&request),
      approach_(&approach),
      options_(&options),
      areas_(areas),
      flight_(*request.world, *request.mission),
      radius_(searchRadius(*request.world, options)),
      people_(descentRiskOf(request, approach, options)),
      direct_(request, flight_, approach),
      found_(request, flight_, approach) {}

double Contingency::crossover() const {
  return elevationOf(*request_, *approach_) + options_->crossover.si();
}

const BestDescent& Contingency::dubins() {
  if (direct_.offered() > 0) {
    return direct_;
  }
  std::vector<double> radii{radius_};
  for (const double radius : request_->world->glide.glideRadii()) {
    if (radius < radius_) {
      radii.push_back(radius);
    }
  }
  for (const double radius : radii) {
    DubinsWays ways(flight_, approach_->gate, approach_->altitude, radius);
    std::vector<Pieces> all;
    ways.direct(request_->pose, request_->altitude, all);
    ways.sTurns(request_->pose, request_->altitude, all);
    for (const Pieces& way : all) {
      direct_.offer(way);
    }
    if (direct_.path() && direct_.surplus() <= 0.0) {
      break;
    }
  }
  return direct_;
}

/// 0.5, or less where the optimal descent would not reach the goal ([3] section 4.5.2): halving down to what the shortest way needs.
double Contingency::shareFrom(const geo::Pose& pose, double altitude) {
  const std::optional<Pieces> way = shortestWay(pose, approach_->gate, radius_);
  double share = 0.5;
  for (int i = 0; i < 6 && way; ++i) {
    geo::Pose at = pose;
    if (flight_.fly(at, altitude, *way, share, nullptr) >= approach_->altitude) {
      return share;
    }
    share *= i == 4 ? 0.0 : 0.5;
  }
  return 0.0;
}

void Contingency::searchFrom(const Pieces& before, const GradientLimits& limits, const Countdown& countdown, bool isHold) {
  geo::Pose pose = request_->pose;
  double altitude = request_->altitude;
  const double risk = found_.riskAlong(pose, altitude, before, 0.5);
  if (!(altitude > approach_->altitude)) {
    return;
  }
  const double share = shareFrom(pose, altitude);
  const double bearing = std::atan2(approach_->gate.y - pose.y, approach_->gate.x - pose.x);
  const double slope = flight_.rangeOf(bearing, {flight::Turn::Straight, 0.0, 1.0}, altitude).at(share);
  if (!std::isfinite(slope) || !(slope > 0.0)) {
    return;
  }
  const GradientTask task{pose, altitude, approach_->gate, approach_->altitude, radius_, slope};
  GradientSearch search(flight_, found_, task, *options_, request_->risk.get(), people_.get(), share);
  const GradientCount count = search.run(before, risk, limits, countdown);
  if (count.improved > 0) {
    isHolding_ = isHold;
  }
  count_.expanded += count.expanded;
  count_.states += count.states;
  count_.connected += count.connected;
}

Pieces Contingency::downTo(const Pieces& pieces, double altitude) {
  Pieces part;
  geo::Pose pose = request_->pose;
  double high = request_->altitude;
  for (const flight::Piece& piece : pieces) {
    const geo::Pose before = pose;
    const double low = flight_.fly(pose, high, piece, 0.5, nullptr);
    if (low <= altitude) {
      double flown = 0.0;
      double rest = piece.length;
      while (rest - flown > 1.0) {  // to a metre: the state only says where the search begins
        const double middle = 0.5 * (flown + rest);
        geo::Pose at = before;
        (flight_.fly(at, high, flight::Piece{piece.turn, piece.radius, middle}, 0.5, nullptr) > altitude ? flown : rest) = middle;
      }
      part.push_back({piece.turn, piece.radius, rest});
      return part;
    }
    part.push_back(piece);
    high = low;
  }
  return part;
}

void Contingency::searchByHold(const HoldingArea& area, const GradientLimits& limits, const Countdown& countdown) {
  // (65): the circle is flown to the left, and come to on the course from the start to its centre, which then lies to the left
  const double course = std::atan2(area.centre.y - request_->pose.y, area.centre.x - request_->pose.x);
  const geo::Pose inbound{area.centre.x + radius_ * std::sin(course), area.centre.y - radius_ * std::cos(course), course};
  const std::optional<Pieces> to = shortestWay(request_->pose, inbound, radius_);
  if (!to) {
    return;
  }
  geo::Pose pose = request_->pose;
  const double reached = flight_.fly(pose, request_->altitude, *to, 0.5, nullptr);
  if (!(reached > crossover())) {
    searchFrom(downTo(*to, crossover()), limits, countdown, false);
    return;
  }
  // (66); d_gc tan(gamma_opt) counts from the goal's altitude, and the ground counts with the clearance
  const landing::World& world = *request_->world;
  geo::Box circle;
  circle.add(area.centre);
  const double bearing = std::atan2(approach_->gate.y - area.centre.y, approach_->gate.x - area.centre.x);
  const double slope = flight_.rangeOf(bearing, {flight::Turn::Straight, 0.0, 1.0}, reached).at(0.5);
  const double direct = approach_->altitude + geo::distance(area.centre, approach_->gate.point()) * slope;
  const double ground = world.terrain.upperIn(circle.grown(radius_)) + world.clearance;
  const double outbound = std::max({ground, direct, elevationOf(*request_, *approach_) + options_->holdingFloor.si()}) + options_->holdingBuffer.si();
  // (67): so many circles and a part of one
  const flight::Piece whole{flight::Turn::Left, radius_, 2.0 * Angle::kPi * radius_};
  Pieces pieces = *to;
  double altitude = reached;
  for (;;) {
    const double lower = flight_.fly(pose, altitude, whole, 0.5, nullptr);
    if (!(lower < altitude) || lower < outbound) {
      const double share = lower < altitude ? std::max(0.0, altitude - outbound) / (altitude - lower) : 0.0;
      append(pieces, {{whole.turn, whole.radius, share * whole.length}});
      break;
    }
    pieces.push_back(whole);
    altitude = lower;
  }
  searchFrom(pieces, limits, countdown, true);
}

const BestDescent& Contingency::search(const GradientLimits& limits, const Countdown& countdown) {
  if (request_->altitude <= crossover() || areas_ == nullptr) {
    searchFrom({}, limits, countdown, false);
    return found_;
  }
  std::vector<HoldingArea> candidates;
  std::vector<double> risks;
  const geo::Point goal = approach_->gate.point();
  const geo::Point site = request_->world->sites[static_cast<std::size_t>(approach_->site)].pose.point();
  const double reach = (request_->altitude - approach_->altitude) / std::max(1e-3, request_->world->glide.leastLoss());
  for (const HoldingArea& area : areas_->all()) {
    const double distance = geo::distance(area.centre, goal);
    if (area.room < radius_ || geo::distance(area.centre, site) < radius_ + options_->noFly.si() ||
        geo::distance(area.centre, request_->pose.point()) + distance > reach) {
      continue;
    }
    candidates.push_back(area);
    double risk = 0.0;
    if (people_ != nullptr) {
      const double course = std::atan2(goal.y - area.centre.y, goal.x - area.centre.x);
      const double start = std::min(people_->window().top, approach_->altitude + distance * people_->window().slope);
      risk = people_->of({area.centre.x, area.centre.y, course}, {flight::Turn::Straight, 0.0, distance}, start, approach_->altitude);
    }
    risks.push_back(risk);
  }
  const std::vector<RankedHold> ranked = rankHolds(candidates, goal, risks);
  for (std::size_t i = 0; i < std::min(kHoldsTried, ranked.size()) && !countdown.isOver(); ++i) {
    searchByHold(ranked[i].area, limits, countdown);
  }
  if (!found_.path()) {  // no area, or none that a way from could be found
    searchFrom({}, limits, countdown, false);
  }
  return found_;
}

}  // namespace vp::emergency
