#include "core/emergency/gradient_search.h"

#include "core/emergency/prism_set.h"
#include "core/flight/curve_sampling.h"

#include <queue>

#include <algorithm>
#include <cmath>

namespace vp::emergency {
namespace {

double greatestChange(const GradientOptions& options) {
  double most = 0.0;
  for (const double degrees : options.courseChanges_deg) {
    most = std::max(most, std::abs(Angle::degrees(degrees).radians()));
  }
  return most;
}

}  // namespace

GradientSearch::GradientSearch(DescentFlight& flight, BestDescent& best, const GradientTask& task, const GradientOptions& options,
                               const risk::LegRisk* risk, const risk::DescentRisk* people, double share)
    : flight_(&flight),
      best_(&best),
      task_(task),
      options_(options),
      risk_(risk),
      people_(people),
      share_(share),
      cost_(task, options),
      ways_(flight, task.goal, task.goalAltitude, task.radius) {
  widestSegment_ = segmentLength(task.altitude, greatestChange(options));
}

/// (17) and (18).
double GradientSearch::segmentLength(double altitude, double change) const {
  const double least = task_.radius * (std::tan(0.5 * std::abs(change)) + std::tan(0.5 * greatestChange(options_)));
  const double above = altitude - task_.goalAltitude - options_.floor.si();
  return std::max(least, task_.radius * std::abs(change)) + options_.lengthPerHeight * std::max(0.0, above);
}

bool GradientSearch::act(int parent, double change, State& next) {
  const State& from = states_[static_cast<std::size_t>(parent)];
  const double length = segmentLength(from.altitude, change);
  const double turned = task_.radius * std::abs(change);
  next = from;
  next.parent = parent;
  next.turn = {change > 0.0 ? flight::Turn::Left : flight::Turn::Right, task_.radius, turned};
  next.straight = {flight::Turn::Straight, 0.0, length - turned};
  next.flown = from.flown + length;
  for (const flight::Piece& piece : {next.turn, next.straight}) {
    const geo::Pose before = next.pose;
    const double high = next.altitude;
    next.altitude = flight_->fly(next.pose, high, piece, share_, nullptr);
    if (next.altitude == DescentFlight::kNoGlide || (piece.length > 0.0 && !flight_->isClear(before, piece, high, next.altitude))) {
      return false;
    }
  }
  // (25), with the bound on the way that is left
  const double bearing = std::atan2(task_.goal.y - next.pose.y, task_.goal.x - next.pose.x);
  const double glide = flight_->rangeOf(bearing, {flight::Turn::Straight, 0.0, 1.0}, next.altitude).least;
  return next.altitude >= task_.goalAltitude && next.altitude - task_.goalAltitude >= glide * cost_.leastLength(next.pose);
}

double GradientSearch::costOf(State& state) {
  const State& from = states_[static_cast<std::size_t>(state.parent)];
  geo::Pose pose = from.pose;
  double altitude = from.altitude;
  double people = 0.0;
  for (const flight::Piece& piece : {state.turn, state.straight}) {
    const geo::Pose before = pose;
    const double high = altitude;
    altitude = flight_->fly(pose, high, piece, share_, nullptr);
    const double risk = risk_ != nullptr ? risk_->of(before, piece, high, altitude) : 0.0;
    state.risk += risk;
    people += people_ == nullptr || people_ == risk_ ? risk : people_->of(before, piece, high, altitude);
  }
  double course = 0.0;
  const double guide = cost_.guide(state.pose, state.flown, course);
  // (44) of the segment alone, averaged over its time
  return people_ == nullptr ? guide : guide + GradientCost::weights(course).people * people * people_->length() / (state.flown - from.flown);
}

/// (57) and the third condition of (59); the second and the fourth are whether a way fits.
bool GradientSearch::isInSolutionVolume(const State& state) const {
  const double distance = geo::distance(state.pose.point(), task_.goal.point());
  return distance >= options_.annulusInner * task_.radius && distance <= options_.annulusOuter * task_.radius &&
         cost_.beyond(state.pose.point()) <= 0.0;
}

Pieces GradientSearch::piecesTo(int state) const {
  std::vector<int> chain;
  for (int i = state; i > 0; i = states_[static_cast<std::size_t>(i)].parent) {
    chain.push_back(i);
  }
  Pieces pieces;
  const auto append = [&pieces](const flight::Piece& piece) {
    if (!(piece.length > 0.0)) {
      return;
    }
    if (!pieces.empty() && pieces.back().turn == piece.turn && pieces.back().radius == piece.radius) {
      pieces.back().length += piece.length;
    } else {
      pieces.push_back(piece);
    }
  };
  std::reverse(chain.begin(), chain.end());
  for (const int i : chain) {
    append(states_[static_cast<std::size_t>(i)].turn);
    append(states_[static_cast<std::size_t>(i)].straight);
  }
  return pieces;
}

bool GradientSearch::connect(const Pieces& before, int state) {
  bool isFound = false;
  const State from = states_[static_cast<std::size_t>(state)];
  for (std::size_t type = 0; type < kDubinsTypes && best_->isWorthOffering(from.risk); ++type) {
    const std::optional<Pieces> way = ways_.fitted(from.pose, from.altitude, type);
    if (!way) {
      continue;
    }
    geo::Pose pose = from.pose;
    double altitude = from.altitude;
    if (!best_->isWorthOffering(from.risk + best_->riskAlong(pose, altitude, *way, share_))) {
      continue;
    }
    Pieces pieces = before;
    for (const Pieces& part : {piecesTo(state), *way}) {
      for (const flight::Piece& piece : part) {
        const bool isSame =
            !pieces.empty() && pieces.back().turn == piece.turn && pieces.back().radius == piece.radius && pieces.size() > before.size();
        if (isSame) {
          pieces.back().length += piece.length;
        } else {
          pieces.push_back(piece);
        }
      }
    }
    isFound = best_->offer(pieces) || isFound;
  }
  return isFound;
}

GradientCount GradientSearch::run(const Pieces& before, double risk, const GradientLimits& limits, const Countdown& countdown) {
  GradientCount count;
  const double circle =
      2.0 * Angle::kPi * task_.radius * flight_->rangeOf(task_.goal.heading, {flight::Turn::Left, task_.radius, 1.0}, task_.altitude).at(share_);
  PrismSet closed(std::max(1.0, circle), options_.courseStep.radians(), 0.5 * widestSegment_);
  std::priority_queue<Open> open;
  states_.assign(1, State{task_.start, task_.altitude, 0.0, risk, -1, {}, {}});
  open.push({0.0, 0});
  std::int64_t last = limits.expansions;
  const auto tryFrom = [&](int state) {
    ++count.connected;
    if (connect(before, state)) {
      ++count.improved;
      last = std::min<std::int64_t>(limits.expansions, count.expanded + limits.afterBest);
    }
  };
  while (!open.empty() && count.expanded < last && !countdown.isOver()) {
    const int current = open.top().state;
    open.pop();
    if (!best_->isWorthOffering(states_[static_cast<std::size_t>(current)].risk)) {
      continue;  // risk only grows on the way on
    }
    ++count.expanded;
    tryFrom(current);
    const double altitude = states_[static_cast<std::size_t>(current)].altitude;
    for (const double degrees : options_.courseChanges_deg) {
      State next;
      const double change = Angle::degrees(degrees).radians();
      if (!act(current, change, next)) {
        continue;
      }
      const double cost = costOf(next);
      if (!best_->isWorthOffering(next.risk) || !closed.add(next.pose, next.altitude, 0.5 * segmentLength(altitude, change), next.risk)) {
        continue;
      }
      states_.push_back(next);
      const int added = static_cast<int>(states_.size() - 1);
      if (isInSolutionVolume(next)) {
        tryFrom(added);
      }
      open.push({cost, added});
    }
  }
  count.states = static_cast<std::int64_t>(closed.size());
  return count;
}

}  // namespace vp::emergency
