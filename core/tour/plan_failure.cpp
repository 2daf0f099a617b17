#include "core/tour/plan_failure.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::tour {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::size_t kNeighbours = 3;  // targets that a target's legs are tried to

Error cancelled() {
  return {Errc::Cancelled, "stopped while planning the tour", {}};
}

/// The k targets nearest to one, itself left out.
std::vector<int> nearestTargets(const PlanInput& input, std::size_t target, std::size_t k) {
  std::vector<std::pair<double, int>> order;
  for (std::size_t t = 0; t < input.targets.size(); ++t) {
    if (t != target) {
      order.emplace_back(geo::distance(input.targets[target].point, input.targets[t].point), static_cast<int>(t));
    }
  }
  std::sort(order.begin(), order.end());
  std::vector<int> nearest;
  for (std::size_t i = 0; i < std::min(k, order.size()); ++i) {
    nearest.push_back(order[i].second);
  }
  return nearest;
}

/// A target that can be visited neither below nor above a forbidden airspace around it.
std::optional<Error> insideAirspace(const PlanInput& input, const landing::World& world, std::size_t target, double lowest,
                                    const SegmentSettings& settings) {
  const geo::Point place = input.targets[target].point;
  std::vector<HeightGate> gates;
  settings.forbidden->addGatesNear(world.terrain, place, 0.0, input.terrain->upperAt(place), gates);
  for (const HeightGate& gate : gates) {
    if (!gate.isPassed(lowest, lowest) && gate.ceiling > settings.ceiling) {
      return Error{
          Errc::NoSolution,
          fmt::format("target {} lies inside {}, which the mission forbids to the tour: the lowest safe altitude above it is {:.0f} m MSL, so it "
                      "cannot be visited from below that airspace, nor from above it under the ceiling of the tour; allow the airspace (Mission > "
                      "Airspace), move the target out of it, or drop the target",
                      input.targets[target].target.name, settings.forbidden->nameOf(gate.volume), std::ceil(lowest)),
          {}};
    }
  }
  return std::nullopt;
}

/// The lowest peak of a few legs between a target and its nearest ones; nothing if stopped.
std::optional<double> lowestPeakAt(const PlanTask& task, std::size_t target, SegmentBuilder& builder, const Job& job) {
  constexpr int kHeadings = 4;
  const int k = task.input.mission.planner.headings;
  const int stride = std::max(1, k / kHeadings);
  double lowestPeak = kInfinite;
  for (const int other : nearestTargets(task.input, target, kNeighbours)) {
    for (int a = 0; a < k; a += stride) {
      for (int b = 0; b < k; b += stride) {
        if (job.stopRequested()) {
          return std::nullopt;
        }
        const VisitPose& from = task.sampled[target * static_cast<std::size_t>(k) + static_cast<std::size_t>(a)];
        const VisitPose& to = task.sampled[static_cast<std::size_t>(other) * static_cast<std::size_t>(k) + static_cast<std::size_t>(b)];
        lowestPeak = std::min({lowestPeak, builder.safeSegment(from, to).peak, builder.safeSegment(to, from).peak});
      }
    }
  }
  return lowestPeak;
}

/// Numbers of the forbidden airspaces on the straight lines from a target to its `count` nearest ones.
std::vector<int> airspacesAround(const PlanTask& task, std::size_t target, std::size_t count) {
  std::vector<HeightGate> gates;
  const geo::Point from = task.input.targets[target].point;
  for (const int other : nearestTargets(task.input, target, count)) {
    const geo::Point to = task.input.targets[static_cast<std::size_t>(other)].point;
    const geo::Pose start{from.x, from.y, std::atan2(to.y - from.y, to.x - from.x)};
    task.settings.forbidden->addGates(task.world.terrain, start, {flight::Turn::Straight, 0.0, geo::distance(from, to)}, 0.0, gates);
  }
  std::vector<int> volumes(gates.size());
  std::transform(gates.begin(), gates.end(), volumes.begin(), [](const HeightGate& gate) { return gate.volume; });
  return volumes;
}

/// A few of them by name, each once.
std::string namesOf(const PlanTask& task, std::vector<int> volumes) {
  constexpr std::size_t kMostNames = 3;
  std::sort(volumes.begin(), volumes.end());
  volumes.erase(std::unique(volumes.begin(), volumes.end()), volumes.end());
  std::string names;
  for (std::size_t i = 0; i < std::min(kMostNames, volumes.size()); ++i) {
    names += (i == 0 ? "" : ", ") + task.settings.forbidden->nameOf(volumes[i]);
  }
  return volumes.size() > kMostNames ? fmt::format("{} and {} more", names, volumes.size() - kMostNames) : names;
}

/// What is said where no target stands out.
std::string sayNoClosedTour(const PlanTask& task) {
  std::vector<int> volumes;
  for (std::size_t t = 0; task.settings.forbidden != nullptr && t < task.input.targets.size(); ++t) {
    const std::vector<int> around = airspacesAround(task, t, task.input.targets.size());
    volumes.insert(volumes.end(), around.begin(), around.end());
  }
  if (!volumes.empty()) {
    return fmt::format(
        "every target can be joined to a neighbour, but no closed tour over all of them stays within glide of a runway, below the "
        "ceiling and out of the airspaces that the mission forbids to the tour; between the targets lie {}; allow one of them (Mission > "
        "Airspace), raise the ceiling, or drop the targets behind it",
        namesOf(task, volumes));
  }
  return "every target can be joined to a neighbour, but no closed tour over all of them stays over known terrain, below the ceiling and within "
         "glide of a runway; move targets that lie beside gaps in the terrain or below high ground, raise the ceiling, or drop targets that are "
         "hard to reach";
}

/// Without the forbidden airspaces the legs of a target would fit.
std::string sayAirspace(const PlanTask& task, std::size_t target) {
  const std::string names = namesOf(task, airspacesAround(task, target, kNeighbours));
  return fmt::format(
      "target {}: its legs to the nearest targets find no way below, above or around {}, which the mission forbids to the tour; allow "
      "that airspace (Mission > Airspace), raise the ceiling, or move or drop the target",
      task.input.targets[target].target.name, names.empty() ? "the airspace beside it" : names);
}

/// The legs of a target to its neighbours climb to `lowestPeak` at least; infinite: they cannot be flown at all.
std::string sayMissing(const PlanTask& task, std::size_t target, double lowestPeak) {
  const std::string& name = task.input.targets[target].target.name;
  if (!std::isfinite(lowestPeak)) {
    return fmt::format(
        "target {}: the legs to its nearest targets leave known terrain or have points without any glide to a landing site; load more terrain or "
        "drop "
        "the target",
        name);
  }
  return fmt::format(
      "target {}: the legs to its nearest targets must climb to {:.0f} m MSL to stay within glide of a runway, {:.0f} m above the ceiling of {:.0f} "
      "m; "
      "raise the ceiling, add a landing site, or drop the target",
      name, std::ceil(lowestPeak), std::ceil(lowestPeak - task.settings.ceiling), task.settings.ceiling);
}

}  // namespace

std::optional<Error> checkTargets(const PlanInput& input, PlanFailure& failure) {
  if (input.targets.empty()) {
    return Error{Errc::OutOfRange, "the mission has no targets; add at least one", {}};
  }
  for (const mission::TargetInFrame& target : input.targets) {
    if (!input.terrain->isKnownAt(target.point)) {
      failure.target = static_cast<int>(&target - input.targets.data());
      return Error{Errc::MissingTerrain,
                   fmt::format("target {}: the terrain has no data there; move the target or load terrain that covers it", target.target.name),
                   {}};
    }
  }
  return std::nullopt;
}

std::optional<Error> hopelessTarget(const PlanInput& input, const landing::World& world, const landing::Roadmap& roadmap,
                                    const std::vector<VisitPose>& visits, const SegmentSettings& settings, PlanFailure& failure, const Job& job) {
  const double ceiling = settings.ceiling;
  landing::QueryScratch scratch;
  for (std::size_t t = 0; t < input.targets.size(); ++t) {
    if (job.stopRequested()) {
      return cancelled();
    }
    double lowest = kInfinite;
    for (const VisitPose& visit : visits) {
      if (visit.target == static_cast<int>(t)) {
        if (const auto answer = roadmap.query(world, visit.pose, scratch)) {
          lowest = std::min(lowest, std::max(answer->altitude, visit.altitude));
        }
      }
    }
    const std::string& name = input.targets[t].target.name;
    if (lowest == kInfinite) {
      failure.target = static_cast<int>(t);
      return Error{
          Errc::NoSolution,
          fmt::format("target {}: no glide from above it reaches any of the {} landing sites over known terrain; add landing sites or terrain "
                      "around it, or drop the target",
                      name, input.sites.size()),
          {}};
    }
    if (lowest > ceiling) {
      failure = {static_cast<int>(t), lowest - ceiling};
      return Error{
          Errc::NoSolution,
          fmt::format("target {}: the lowest safe altitude above it is {:.0f} m MSL ({:.0f} ft), {:.0f} m above the ceiling of {:.0f} m; raise the "
                      "ceiling by "
                      "{:.0f} m, add a landing site nearer to it, or drop the target",
                      name, std::ceil(lowest), std::ceil(lowest / kMetresPerFoot), std::ceil(lowest - ceiling), ceiling, std::ceil(lowest - ceiling)),
          {}};
    }
    if (settings.forbidden != nullptr) {
      if (const std::optional<Error> error = insideAirspace(input, world, t, lowest, settings)) {
        failure.target = static_cast<int>(t);
        return error;
      }
    }
  }
  return std::nullopt;
}

Error explainNoTour(const PlanTask& task, const Job& job, PlanFailure& failure) {
  SegmentSettings unlimited = task.settings;
  unlimited.ceiling = SegmentSettings{}.ceiling;
  unlimited.forbidden = nullptr;
  SegmentBuilder builder(task.world, task.roadmap, task.detours, unlimited, job.stopToken());
  SegmentBuilder confined(task.world, task.roadmap, task.detours, task.settings, job.stopToken());
  bool isAirspace = false;
  double worst = 0.0;
  std::string text = sayNoClosedTour(task);
  for (std::size_t t = 0; t < task.input.targets.size(); ++t) {
    const std::optional<double> lowestPeak = lowestPeakAt(task, t, builder, job);
    if (!lowestPeak) {
      return cancelled();
    }
    if (task.settings.forbidden != nullptr && !isAirspace && *lowestPeak <= task.settings.ceiling) {
      const std::optional<double> confinedPeak = lowestPeakAt(task, t, confined, job);
      if (confinedPeak && *confinedPeak > task.settings.ceiling && worst == 0.0) {
        isAirspace = true;
        failure.target = static_cast<int>(t);
        text = sayAirspace(task, t);
      }
    }
    const double missing = *lowestPeak - task.settings.ceiling;
    if (missing > worst) {
      worst = missing;
      failure.target = static_cast<int>(t);
      failure.missingHeight = std::isfinite(missing) ? std::optional(missing) : std::nullopt;
      text = sayMissing(task, t, *lowestPeak);
    }
  }
  if (job.stopRequested()) {
    return cancelled();  // what was found out last may be no answer
  }
  return {Errc::NoSolution, text, {}};
}

std::optional<Error> aboveCeiling(double peak, double ceiling, PlanFailure& failure) {
  if (!(peak > ceiling)) {
    return std::nullopt;
  }
  failure.missingHeight = peak - ceiling;
  return Error{
      Errc::NoSolution,
      fmt::format(
          "joined into one loop within the pitch limits the tour climbs to {:.0f} m MSL, {:.0f} m above the ceiling of {:.0f} m; raise the ceiling",
          std::ceil(peak), std::ceil(peak - ceiling), ceiling),
      {}};
}

}  // namespace vp::tour
