#include "core/emergency/runway_ranking.h"

#include "core/aircraft/runway_wind.h"
#include "core/emergency/landing_goals.h"
#include "core/emergency/landing_judge.h"
#include "core/emergency/landing_outcome.h"
#include "core/emergency/verified_answer.h"
#include "core/emergency/weather/weather_planner.h"
#include "core/flight/curve_sampling.h"
#include "core/mission/runway_need.h"
#include "core/risk/descent_risk.h"
#include "core/risk/people_under.h"
#include "core/risk/weather.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <thread>
#include <utility>

namespace vp::emergency {
namespace {

constexpr double kKnot = kMetresPerNauticalMile / 3600.0;  // m/s

std::shared_ptr<const risk::Population> populationOf(const LandingRequest& request) {
  if (const auto* const people = dynamic_cast<const risk::PeopleUnder*>(request.risk.get())) {
    return people->population();
  }
  const auto* const descent = dynamic_cast<const risk::DescentRisk*>(request.risk.get());
  return descent == nullptr ? nullptr : descent->population();
}

/// Metres of a path within each cell of weather, by the cell's name, in the order of cells.
std::vector<std::pair<std::string, double>> metresInWeather(const risk::Weather& weather, const mission::LandingPath& path) {
  std::map<std::size_t, double> metres;
  std::vector<risk::WeatherStretch> stretches;
  geo::Pose pose = path.start;
  double altitude = path.altitude;
  for (const mission::LandingLeg& leg : path.legs) {
    const double slope = leg.piece.length > 0.0 ? (leg.endAltitude - altitude) / leg.piece.length : 0.0;
    weather.along(pose, leg.piece, std::min(altitude, leg.endAltitude), std::max(altitude, leg.endAltitude), stretches);
    for (const risk::WeatherStretch& stretch : stretches) {
      metres[stretch.cell] += risk::lengthInside(weather.cell(stretch.cell), stretch, altitude, slope);
    }
    pose = flight::endOf(pose, leg.piece);
    altitude = leg.endAltitude;
  }
  std::vector<std::pair<std::string, double>> named;
  for (const auto& [cell, length] : metres) {
    if (length >= 1.0) {
      named.emplace_back(weather.cell(cell).name, length);
    }
  }
  return named;
}

/** The lines of one runway. */
class Lines {
public:
  Lines(const LandingRequest& request, const RankingOptions& options, RankedRunway& runway)
      : request_(request), options_(options), runway_(runway), site_(request.world->sites[static_cast<std::size_t>(runway.site)]) {}

  void write() {
    way();
    reach();
    unknown("ceiling and visibility", options_.ceilingNotKnown, "Ceiling and visibility there are not known.");
    length();
    width();
    surface();
    wind();
    people();
    unknown("emergency services", options_.servicesNotKnown, "Fire and rescue services there are not known.");
    lights();
    for (const RankingLine& line : runway_.lines) {
      runway_.logRisk += line.logRisk;
    }
  }

private:
  void known(const char* name, double value, const char* unit, double logRisk, std::string sentence) {
    runway_.lines.push_back({name, value, unit, true, std::max(0.0, logRisk), std::move(sentence)});
  }
  void unknown(const char* name, double logRisk, std::string sentence) {
    runway_.lines.push_back({name, 0.0, "", false, logRisk, std::move(sentence)});
  }

  void way() {
    constexpr const char* kName = "weather on the way";
    if (request_.weather == nullptr) {
      unknown(kName, options_.unknownWeather, "Weather on the way is not known.");
      return;
    }
    if (!runway_.isReached) {
      unknown(kName, 0.0, "Weather on the way does not count, as there is no way.");
      return;
    }
    const double weather = weatherOf(request_, *runway_.answer.path);
    std::string through;
    for (const auto& [name, metres] : metresInWeather(*request_.weather, *runway_.answer.path)) {
      through += fmt::format("{}{:.1f} km of {}", through.empty() ? "" : ", ", 1e-3 * metres, name);
    }
    known(kName, std::exp(-weather), "", weather,
          through.empty() ? "No bad weather on the way." : fmt::format("Through {}: {:.0f} % come through.", through, 100.0 * std::exp(-weather)));
  }

  void reach() {
    constexpr const char* kName = "height in hand";
    if (!runway_.isReached) {
      known(kName, -runway_.answer.missing, "m", options_.outOfRange, "Not reached: " + runway_.answer.whyNot);
      return;
    }
    const double hand = runway_.answer.heightInHand;
    known(kName, hand, "m", options_.noHand * (1.0 - hand / options_.lowestHand), fmt::format("Reached with {:.0f} m of height in hand.", hand));
  }

  void length() {
    constexpr const char* kName = "runway length";
    const mission::LandingSite& site = site_.site;
    if (!site.length) {
      unknown(kName, options_.lengthNotKnown, "The length of the runway is not known.");
      return;
    }
    const double metres = site.length->si();
    const std::optional<Length> need = mission::landingNeed(*request_.mission, site, request_.world->sites);
    if (!need) {
      known(kName, metres, "m", options_.needNotKnown, fmt::format("{:.0f} m long; what the aircraft needs is not known.", metres));
      return;
    }
    const double ratio = metres / need->si();
    const double risk = ratio >= 1.0 ? options_.shortRunway * (options_.factoredLength - ratio) / (options_.factoredLength - 1.0)
                                     : options_.shortRunway + 20.0 * options_.shortRunway * (1.0 - ratio);
    known(kName, metres, "m", risk,
          fmt::format("{:.0f} m long, {:.0f} m needed{}.", metres, std::ceil(need->si()), ratio < 1.0 ? ": too short" : ""));
  }

  void width() {
    constexpr const char* kName = "runway width";
    if (!site_.site.width) {
      unknown(kName, options_.widthNotKnown, "The width of the runway is not known.");
      return;
    }
    const double metres = site_.site.width->si();
    known(kName, metres, "m", options_.noWidth * (1.0 - metres / options_.fullWidth), fmt::format("{:.0f} m wide.", metres));
  }

  void surface() {
    constexpr const char* kName = "surface";
    struct Kind {
      double risk;
      const char* sentence;
    };
    const auto kind = [&]() -> Kind {
      switch (site_.site.surface) {
        case mission::Surface::Hard:
          return {0.0, "A hard surface."};
        case mission::Surface::Gravel:
          return {0.01, "A gravel surface."};
        case mission::Surface::Grass:
          return {0.01, "A grass surface."};
        case mission::Surface::Dirt:
          return {0.02, "A dirt surface."};
        case mission::Surface::Snow:
          return {0.05, "A surface of snow."};
        case mission::Surface::Water:
          return {0.5, "Water."};
        case mission::Surface::Unknown:
          break;
      }
      return {0.03, "The surface is not known."};
    }();
    if (site_.site.surface == mission::Surface::Unknown) {
      unknown(kName, kind.risk, kind.sentence);
    } else {
      known(kName, kind.risk, "", kind.risk, kind.sentence);
    }
  }

  void wind() {
    constexpr const char* kName = "wind";
    const mission::Mission& mission = *request_.mission;
    if (mission.wind.empty()) {
      unknown(kName, options_.windNotKnown, "The wind there is not known; the way is planned in still air.");
      return;
    }
    const aircraft::RunwayWind wind = aircraft::runwayWind(mission.wind, site_.site.elevation, site_.site.landingCourse);
    const double crossLimit = mission.aircraft.maxCrosswind ? mission.aircraft.maxCrosswind->si() : options_.crosswindLimit * kKnot;
    const double tailLimit = mission.aircraft.maxTailwind ? mission.aircraft.maxTailwind->si() : options_.tailwindLimit * kKnot;
    const double cross = wind.crosswind / crossLimit;
    const double tail = std::max(0.0, wind.tailwind) / tailLimit;
    known(kName, wind.crosswind / kKnot, "kt", options_.windAtLimit * (cross * cross + tail * tail),
          fmt::format("Up to {:.0f} kt of crosswind, {}.", wind.crosswind / kKnot,
                      wind.tailwind > 0.0 ? fmt::format("up to {:.0f} kt of tailwind", wind.tailwind / kKnot)
                                          : fmt::format("at least {:.0f} kt of headwind", std::max(0.0, -wind.tailwind / kKnot))));
  }

  void people() {
    constexpr const char* kName = "people under the final approach";
    const std::shared_ptr<const risk::Population> population = populationOf(request_);
    if (population == nullptr) {
      unknown(kName, options_.peopleNotKnown, "How many people live under the final approach is not known.");
      return;
    }
    const double length = options_.approachLength * kMetresPerNauticalMile;
    const geo::Pose& end = site_.pose;
    const geo::Pose begin{end.x - length * std::cos(end.heading), end.y - length * std::sin(end.heading), end.heading};
    const double people = population->integralAlong(begin, {flight::Turn::Straight, 0.0, length}) * 2.0 * options_.approachHalfWidth;
    known(kName, people, "people", std::min(options_.mostPeople, options_.perPerson * people),
          fmt::format("{:.0f} people live under the last {:.0f} NM of the final course.", people, options_.approachLength));
  }

  void lights() {
    const bool isLighted = site_.site.lighted;
    known("lights", isLighted ? 1.0 : 0.0, "", isLighted ? 0.0 : options_.noLights, isLighted ? "Lighted." : "Not known to be lighted.");
  }

  const LandingRequest& request_;
  const RankingOptions& options_;
  RankedRunway& runway_;
  const mission::SiteInFrame& site_;
};

/// Runways in the order of the height that they need at least, those that no glide may reach last.
std::vector<int> sitesInOrder(const LandingRequest& request, std::size_t& inRange) {
  const LandingGoals goals(*request.world, request.pose, request.altitude);
  std::vector<int> order;
  for (const LandingGoal& goal : goals.inRange()) {
    order.push_back(goal.approach.site);
  }
  inRange = order.size();
  for (int site = 0; site < static_cast<int>(request.world->sites.size()); ++site) {
    if (std::find(order.begin(), order.end(), site) == order.end()) {
      order.push_back(site);
    }
  }
  return order;
}

LandingAnswer planTo(const LandingRequest& request, int site, double seconds) {
  WeatherPlannerOptions options = *weatherPlannerOptions("dvprm");
  options.polish = 300;  // a list of many runways is wanted soon
  LandingRequest own = request;
  own.onlySite = site;
  own.deadline = seconds;
  own.better = {};
  return verifiedAnswer(own, WeatherPlanner("dvprm", options).plan(own));
}

}  // namespace

std::vector<RankedRunway> rankRunways(const LandingRequest& asked, const RankingOptions& options) {
  const LandingRequest request = withJudge(asked);
  const Countdown countdown(request);
  std::size_t inRange = 0;
  const std::vector<int> order = sitesInOrder(request, inRange);
  std::vector<RankedRunway> ranked(order.size());
  const auto threads = static_cast<std::size_t>(std::max(1, request.threads));
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < order.size(); i = next++) {
      RankedRunway& runway = ranked[i];
      runway.site = order[i];
      const bool isOver = countdown.isOver();
      const std::size_t rounds = i < inRange ? (inRange - i + threads - 1) / threads : 1;
      if (i >= inRange) {
        const LandingGoals goals(*request.world, request.pose, request.altitude, runway.site);
        runway.answer.whyNot = goals.whyNone();
        runway.answer.missing = goals.missing();
      } else if (isOver) {
        runway.answer.whyNot = "There was not enough time to look for a way there: give a later deadline.";
      } else {
        runway.answer = planTo(request, runway.site, std::max(1e-3, countdown.left() / static_cast<double>(rounds)));
      }
      const LandingAnswer* const known = options.known;
      if (known != nullptr && known->verified && known->reachesRunway() && known->path->site == runway.site &&
          (!runway.answer.reachesRunway() || weatherOf(request, *known->path) <= weatherOf(request, *runway.answer.path))) {
        runway.answer = *known;
      }
      runway.isReached = runway.answer.reachesRunway();
      Lines(request, options, runway).write();
    }
  };
  {
    std::vector<std::jthread> workers;
    for (std::size_t i = 1; i < std::min(threads, order.size()); ++i) {
      workers.emplace_back(work);
    }
    work();
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const RankedRunway& a, const RankedRunway& b) { return a.isReached != b.isReached ? a.isReached : a.logRisk < b.logRisk; });
  return ranked;
}

}  // namespace vp::emergency
