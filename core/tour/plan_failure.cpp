#include "core/tour/plan_failure.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::tour {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

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
                                    const std::vector<VisitPose>& visits, double ceiling, PlanFailure& failure, const Job& job) {
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
  }
  return std::nullopt;
}

Error explainNoTour(const PlanTask& task, const Job& job, PlanFailure& failure) {
  constexpr std::size_t kNeighbours = 3;
  constexpr int kHeadings = 4;
  SegmentSettings unlimited = task.settings;
  unlimited.ceiling = SegmentSettings{}.ceiling;
  SegmentBuilder builder(task.world, task.roadmap, task.detours, unlimited, job.stopToken());
  const int k = task.input.mission.planner.headings;
  const int stride = std::max(1, k / kHeadings);
  double worst = 0.0;
  std::string text =
      "every target can be joined to a neighbour, but no closed tour over all of them stays over known terrain, below the ceiling and within glide "
      "of "
      "a runway; move targets that lie beside gaps in the terrain or below high ground, raise the ceiling, or drop targets that are hard to reach";
  for (std::size_t t = 0; t < task.input.targets.size(); ++t) {
    double lowestPeak = kInfinite;
    for (const int other : nearestTargets(task.input, t, kNeighbours)) {
      for (int a = 0; a < k; a += stride) {
        for (int b = 0; b < k; b += stride) {
          if (job.stopRequested()) {
            return cancelled();
          }
          const VisitPose& from = task.sampled[t * static_cast<std::size_t>(k) + static_cast<std::size_t>(a)];
          const VisitPose& to = task.sampled[static_cast<std::size_t>(other) * static_cast<std::size_t>(k) + static_cast<std::size_t>(b)];
          lowestPeak = std::min({lowestPeak, builder.safeSegment(from, to).peak, builder.safeSegment(to, from).peak});
        }
      }
    }
    const double missing = lowestPeak - task.settings.ceiling;
    if (missing > worst) {
      worst = missing;
      failure.target = static_cast<int>(t);
      failure.missingHeight = std::isfinite(missing) ? std::optional(missing) : std::nullopt;
      text = sayMissing(task, t, lowestPeak);
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
