#include "core/emergency/gradient_planner.h"

#include "core/emergency/contingency.h"
#include "core/emergency/landing_goals.h"
#include "core/emergency/landing_outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <thread>
#include <utility>

namespace vp::emergency {
namespace {

constexpr std::size_t kSitesTried = 3;  // of those in range, the one with the most height to spare first
constexpr double kUseful = 1.0;         // m of surplus: less is not worth a word

/// The best way so far and how it came about.
struct Best {
  std::optional<mission::LandingPath> path;
  double risk = std::numeric_limits<double>::infinity();
  double surplus = std::numeric_limits<double>::infinity();
  std::string how;

  bool take(const BestDescent& found, const std::string& words) {
    if (!found.path()) {
      return false;
    }
    const bool isLower = found.surplus() < surplus - kUseful || (found.surplus() < surplus + kUseful && found.risk() < risk);
    if (path && !isLower) {
      return false;
    }
    path = found.path();
    risk = found.risk();
    surplus = found.surplus();
    how = words;
    return true;
  }
};

LandingAnswer answerOf(const LandingRequest& request, const LandingGoals& goals, std::string_view planner, const Best& best,
                       const Countdown& countdown) {
  LandingAnswer answer = answerWith(request, goals, planner, *best.path);
  answer.notes.push_back(best.how);
  if (best.surplus > kUseful) {
    answer.notes.push_back(fmt::format("The aircraft comes to the approach {:.0f} m too high: lose that in circles before it.", answer.heightInHand));
  }
  answer.seconds = countdown.elapsed();
  return answer;
}

std::string whyNone(const LandingGoals& goals) {
  return goals.inRange().empty()
             ? goals.whyNone()
             : "No way of turns and straights from here arrives at a runway clear of the ground within the deadline: try another planner.";
}

}  // namespace

LandingAnswer DubinsPlanner::plan(const LandingRequest& request) const {
  const Countdown countdown(request);
  if (std::optional<std::string> fault = requestFault(request)) {
    return answerToFault(request, name(), std::move(*fault));
  }
  const LandingGoals goals(*request.world, request.pose, request.altitude, request.onlySite);
  Best best;
  std::int64_t offered = 0;
  for (std::size_t i = 0; i < goals.inRange().size() && !countdown.isOver(); ++i) {
    Contingency one(request, goals.inRange()[i].approach, options_, nullptr);
    best.take(one.dubins(), "A turn, a straight and a turn, or an S-turn.");
    offered += one.dubins().offered();
  }
  if (!best.path) {
    return answerWithout(request, name(), whyNone(goals), goals.missing(), countdown);
  }
  LandingAnswer answer = answerOf(request, goals, name(), best, countdown);
  answer.tried = {{"Dubins ways", offered}};
  if (request.better) {
    request.better(answer);
  }
  return answer;
}

LandingAnswer GradientPlanner::plan(const LandingRequest& request) const {
  const Countdown countdown(request);
  if (std::optional<std::string> fault = requestFault(request)) {
    return answerToFault(request, name(), std::move(*fault));
  }
  const LandingGoals goals(*request.world, request.pose, request.altitude, request.onlySite);
  const std::size_t sites = std::min(kSitesTried, goals.inRange().size());
  Best best;
  GradientCount count;
  const auto tell = [&] {
    if (request.better) {
      request.better(answerOf(request, goals, name(), best, countdown));
    }
  };
  std::shared_ptr<const HoldingAreas> holds = holds_;
  for (std::size_t i = 0; i < sites && (i == 0 || !countdown.isOver()); ++i) {
    const landing::Approach& approach = goals.inRange()[i].approach;
    const std::string& site = request.world->sites[static_cast<std::size_t>(approach.site)].site.id;
    Contingency fallback(request, approach, options_, nullptr);
    const bool isHigh = fallback.people() != nullptr && fallback.people()->window().top < request.altitude;
    std::optional<std::jthread> beside;
    if (request.threads > 1) {
      beside.emplace([&fallback] { (void)fallback.dubins(); });
    } else if (best.take(fallback.dubins(), "Fallback to " + site + ": a turn, a straight and a turn, or an S-turn.")) {
      tell();
    }
    if (isHigh && holds == nullptr && !countdown.isOver()) {
      geo::Box reach;
      reach.add(approach.gate.point());
      const double range = (request.altitude - approach.altitude) / std::max(1e-3, request.world->glide.leastLoss());
      holds = std::make_shared<const HoldingAreas>(*fallback.people()->population(), searchRadius(*request.world, options_), reach.grown(range),
                                                   [&countdown] { return countdown.isOver() || countdown.left() < countdown.elapsed(); });
    }
    Contingency whole(request, approach, options_, isHigh ? holds.get() : nullptr);
    const BestDescent& found = whole.search(limits_, countdown);
    count.expanded += whole.count().expanded;
    count.states += whole.count().states;
    count.connected += whole.count().connected;
    if (beside) {
      beside.reset();
      best.take(fallback.dubins(), "Fallback to " + site + ": a turn, a straight and a turn, or an S-turn.");
    }
    if (best.take(found, fmt::format("Gradient-guided search to {}{}.", site, whole.isHolding() ? ", height lost in circles first" : ""))) {
      tell();
    }
  }
  const std::vector<Tried> tried{
      {"states expanded", count.expanded}, {"states known", count.states}, {"states connected to the goal", count.connected}};
  if (!best.path) {
    LandingAnswer answer = answerWithout(request, name(), whyNone(goals), goals.missing(), countdown);
    answer.tried = tried;
    return answer;
  }
  LandingAnswer answer = answerOf(request, goals, name(), best, countdown);
  answer.tried = tried;
  return answer;
}

}  // namespace vp::emergency
