#include "core/emergency/weather/weather_planner.h"

#include "core/emergency/landing_outcome.h"
#include "core/emergency/weather/best_landing.h"
#include "core/emergency/weather/local_search.h"
#include "core/emergency/weather/roadmap_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace vp::emergency {
namespace {

struct Named {
  std::string_view name;
  RoadmapOf roadmap;
  bool hasDynamics;
};

constexpr std::array kNamed{
    Named{"straight", RoadmapOf::Nothing, true},    Named{"vg", RoadmapOf::VisibilityGraph, false}, Named{"tg", RoadmapOf::TangentGraph, false},
    Named{"lvg", RoadmapOf::Layers, false},         Named{"hrm", RoadmapOf::Hybrid, false},         Named{"prm", RoadmapOf::Samples, false},
    Named{"vprm", RoadmapOf::SeededSamples, false}, Named{"dlvg", RoadmapOf::Layers, true},         Named{"dprm", RoadmapOf::Samples, true},
    Named{"dvprm", RoadmapOf::SeededSamples, true},
};

bool hasSamples(RoadmapOf roadmap) {
  return roadmap == RoadmapOf::Samples || roadmap == RoadmapOf::SeededSamples;
}

/** One request. */
class Run {
public:
  Run(std::string_view name, const WeatherPlannerOptions& options, const LandingRequest& request, const LandingGoals& goals,
      std::shared_ptr<const risk::Weather> weather, const Countdown& countdown)
      : name_(name),
        options_(options),
        request_(request),
        goals_(goals),
        countdown_(countdown),
        descents_(*request.world, *request.mission),
        flight_(request, descents_, std::move(weather)),
        best_(request, goals, flight_) {}

  void run() {
    best_.offerDirect(countdown_);
    tell();
    const int rounds = options_.roadmap == RoadmapOf::Nothing ? 0 : hasSamples(options_.roadmap) ? options_.rounds : 1;
    for (int round = 0; round < rounds && !best_.isClear() && !countdown_.isOver(); ++round) {
      const RoadmapTask task = taskOf(round);
      const WeatherRoadmap roadmap = roadmapOf(task);
      RoadmapSearch search(task, roadmap, count_);
      for (int way = 0; way < options_.ways && !countdown_.isOver(); ++way) {
        const std::optional<RoadmapWay> found = search.next();
        // a way that is flown as it was found and meets worse weather than the best is none; the first may still lead local search to a better one
        if (!found || (way > 0 && options_.hasDynamics && found->cost > best_.weather() + kSpareCost)) {
          break;
        }
        follow(task, roadmap, *found);
        tell();
      }
      best_.polish(options_.polish, request_.seed + static_cast<std::uint64_t>(round), countdown_);
      tell();
    }
  }

  LandingAnswer answer() const {
    LandingAnswer answer = answerWith(request_, goals_, name_, *best_.path());
    answer.tried = tried();
    answer.seconds = countdown_.elapsed();
    return answer;
  }
  [[nodiscard]] const BestLanding& best() const { return best_; }
  [[nodiscard]] std::vector<Tried> tried() const {
    return {{"runways in range", static_cast<std::int64_t>(goals_.inRange().size())},
            {"vertices of roadmaps", count_.vertices},
            {"states expanded", count_.expanded},
            {"edges evaluated", count_.edges},
            {"ways flown", best_.offered()},
            {"improvements", best_.improved()}};
  }

private:
  /// Clear air that a way may cost more than the best has of weather: a way of a thousand nautical miles.
  static constexpr double kSpareCost = 1000.0 * 1852.0 * kClearAir;

  RoadmapTask taskOf(int round) {
    RoadmapTask task{request_, goals_, flight_, countdown_};
    task.seed = request_.seed + 1000003ULL * static_cast<std::uint64_t>(round);
    task.samples = options_.samples << round;
    task.nearest = options_.nearest;
    way_ = best_.poses();
    if (best_.path()) {
      way_.push_back(goals_.inRange()[best_.goal()].approach.gate);
      task.way = &way_;
    }
    return task;
  }

  WeatherRoadmap roadmapOf(const RoadmapTask& task) const {
    switch (options_.roadmap) {
      case RoadmapOf::VisibilityGraph:
        return visibilityRoadmap(task, false);
      case RoadmapOf::TangentGraph:
        return visibilityRoadmap(task, true);
      case RoadmapOf::Layers:
        return layeredRoadmap(task, options_.hasDynamics);
      case RoadmapOf::Hybrid:
        return hybridRoadmap(task);
      case RoadmapOf::Samples:
        return sampledRoadmap(task, options_.hasDynamics);
      case RoadmapOf::SeededSamples:
        return seededRoadmap(task, options_.hasDynamics);
      case RoadmapOf::Nothing:
        break;
    }
    return bareRoadmap(task);
  }

  void follow(const RoadmapTask& task, const WeatherRoadmap& roadmap, const RoadmapWay& way) {
    std::vector<geo::Pose> poses;
    std::vector<geo::Point> points;
    for (const int vertex : way.vertices) {
      poses.push_back(roadmap.vertices[static_cast<std::size_t>(vertex)].pose);
      points.push_back(poses.back().point());
    }
    const geo::Pose& gate = goals_.inRange()[way.goal].approach.gate;
    best_.offer(options_.hasDynamics ? poses : posesAt(request_.pose, points, gate), way.goal);
    if (options_.searchesLines && !options_.hasDynamics) {
      points = euclideanSearch(task, points, way.goal, count_);
      best_.offer(posesAt(request_.pose, points, gate), way.goal);
    }
    if (options_.searchesCurves) {
      for (const std::vector<geo::Pose>& better : dynamicsSearch(task, points, way.goal, count_)) {
        best_.offer(better, way.goal);
      }
    }
  }

  void tell() {
    if (request_.better && best_.improved() > told_) {
      told_ = best_.improved();
      request_.better(answer());
    }
  }

  std::string_view name_;
  const WeatherPlannerOptions& options_;
  const LandingRequest& request_;
  const LandingGoals& goals_;
  const Countdown& countdown_;
  DescentFlight descents_;
  WeatherFlight flight_;
  BestLanding best_;
  RoadmapCount count_;
  std::vector<geo::Pose> way_;
  std::int64_t told_ = 0;
};

}  // namespace

LandingAnswer WeatherPlanner::plan(const LandingRequest& request) const {
  const Countdown countdown(request);
  if (std::optional<std::string> fault = requestFault(request)) {
    return answerToFault(request, name_, std::move(*fault));
  }
  const LandingGoals goals(*request.world, request.pose, request.altitude, request.onlySite);
  if (goals.inRange().empty()) {
    return answerWithout(request, name_, goals.whyNone(), goals.missing(), countdown);
  }
  std::shared_ptr<const risk::Weather> weather = request.weather;
  if (weather == nullptr) {
    weather = *risk::Weather::from({}, geo::LocalFrame(request.frameOrigin));
  }
  Run run(name_, options_, request, goals, std::move(weather), countdown);
  run.run();
  if (run.best().path()) {
    return run.answer();
  }
  const std::string why =
      fmt::format("No glide to any of the {} runway ends that are near enough stays clear of the ground, of {} ways that were flown.",
                  goals.inRange().size(), run.best().offered());
  LandingAnswer without = answerWithout(request, name_, why, 0.0, countdown);
  without.tried = run.tried();
  return without;
}

std::vector<std::string_view> weatherPlannerNames() {
  std::vector<std::string_view> names;
  names.reserve(kNamed.size());
  for (const Named& one : kNamed) {
    names.push_back(one.name);
  }
  return names;
}

std::optional<WeatherPlannerOptions> weatherPlannerOptions(std::string_view name) {
  const auto* const found = std::find_if(kNamed.begin(), kNamed.end(), [name](const Named& one) { return one.name == name; });
  if (found == kNamed.end()) {
    return std::nullopt;
  }
  WeatherPlannerOptions options;
  options.roadmap = found->roadmap;
  options.hasDynamics = found->hasDynamics;
  return options;
}

}  // namespace vp::emergency
