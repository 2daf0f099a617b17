#include "core/tour/planner.h"

#include "core/landing/build_roadmap.h"
#include "core/tour/assembly.h"
#include "core/tour/home_path.h"
#include "core/tour/refine.h"
#include "core/tour/tour_search.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace vp::tour {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

SegmentSettings makeSettings(const mission::Mission& mission) {
  SegmentSettings settings;
  settings.step = mission.planner.step.si();
  settings.beta = mission.planner.beta;
  settings.pitch = {tan(mission.aircraft.maxClimb), tan(mission.aircraft.maxDescent)};
  for (const std::optional<geo::HeightMsl>& ceiling : {mission.ceiling, mission.aircraft.ceiling}) {
    settings.ceiling = ceiling ? std::min(settings.ceiling, ceiling->metres()) : settings.ceiling;
  }
  return settings;
}

/// k headings per target, evenly spread from East ([1] (12)).
std::vector<VisitPose> sampleHeadings(const PlanInput& input) {
  std::vector<VisitPose> visits;
  const int k = input.mission.planner.headings;
  for (std::size_t t = 0; t < input.targets.size(); ++t) {
    for (int h = 0; h < k; ++h) {
      const mission::TargetInFrame& target = input.targets[t];
      visits.push_back({static_cast<int>(t), {target.point.x, target.point.y, 2.0 * Angle::kPi * h / k}, target.altitude});
    }
  }
  return visits;
}

Error cancelled() {
  return {Errc::Cancelled, "stopped while planning the tour", {}};
}

/// Says before any search which target cannot be part of a safe tour, whatever the order.
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

/** After a search without a tour: the target whose legs to its neighbours miss the ceiling by most. Looks at a few
 *  neighbours and headings only, so that the answer comes in seconds and not after all k^2 n^2 safe segments. */
Error explainNoTour(const PlanInput& input, const landing::World& world, const landing::Roadmap& roadmap, const Detours& detours,
                    const std::vector<VisitPose>& visits, const SegmentSettings& settings, const Error& reason, const Job& job,
                    PlanFailure& failure) {
  constexpr std::size_t kNeighbours = 3;
  constexpr int kHeadings = 4;
  SegmentSettings unlimited = settings;
  unlimited.ceiling = SegmentSettings{}.ceiling;
  SegmentBuilder builder(world, roadmap, detours, unlimited, job.stopToken());
  const int k = input.mission.planner.headings;
  const int stride = std::max(1, k / kHeadings);
  double worst = 0.0;
  std::string text = reason.what + "; load terrain without gaps, raise the ceiling, or drop targets that are hard to reach";
  for (std::size_t t = 0; t < input.targets.size(); ++t) {
    double lowestPeak = kInfinite;
    for (const int other : nearestTargets(input, t, kNeighbours)) {
      for (int a = 0; a < k; a += stride) {
        for (int b = 0; b < k; b += stride) {
          if (job.stopRequested()) {
            return cancelled();
          }
          const VisitPose& from = visits[t * static_cast<std::size_t>(k) + static_cast<std::size_t>(a)];
          const VisitPose& to = visits[static_cast<std::size_t>(other) * static_cast<std::size_t>(k) + static_cast<std::size_t>(b)];
          lowestPeak = std::min({lowestPeak, builder.safeSegment(from, to).peak, builder.safeSegment(to, from).peak});
        }
      }
    }
    const double missing = lowestPeak - settings.ceiling;
    if (missing > worst) {
      worst = missing;
      failure.target = static_cast<int>(t);
      failure.missingHeight = std::isfinite(missing) ? std::optional(missing) : std::nullopt;
      text = std::isfinite(lowestPeak)
                 ? fmt::format(
                       "target {}: the legs to its nearest targets must climb to {:.0f} m MSL to stay within glide of a runway, {:.0f} m above the "
                       "ceiling of "
                       "{:.0f} m; raise the ceiling, add a landing site, or drop the target",
                       input.targets[t].target.name, std::ceil(lowestPeak), std::ceil(missing), settings.ceiling)
                 : fmt::format(
                       "target {}: the legs to its nearest targets leave known terrain or have points without any glide to a landing site; load more "
                       "terrain or drop the target",
                       input.targets[t].target.name);
    }
  }
  if (job.stopRequested()) {
    return cancelled();  // what was found out last may be no answer
  }
  return {Errc::NoSolution, text, {}};
}

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

/// The basis's roadmap, or a new one in its place.
Result<void> provideRoadmap(const PlanInput& input, const landing::World& world, const PlanObserver& observer, PlanBasis& basis, const Job& job) {
  if (basis.roadmap) {
    return {};
  }
  landing::RoadmapRequest request;
  request.area = roadmapArea(input);
  request.threads = input.threads;
  request.grew = observer.roadmapGrew;
  auto built = landing::buildRoadmap(world, input.mission.planner, request, job, &basis.expansions);
  if (!built) {
    return forward(built);
  }
  basis.roadmap = std::move(*built);
  basis.area = request.area;
  basis.floor.reset();
  return {};
}

mission::Plan emptyPlan(const PlanInput& input) {
  mission::Plan plan;
  plan.createdBy = input.createdBy;
  plan.mission = input.mission;
  plan.frameOrigin = input.frame.origin();
  plan.terrainCell = input.terrain->cellSize();
  plan.terrain = input.terrainFiles;
  plan.sites = input.sites;
  plan.targets = input.targets;
  return plan;
}

/// First visits of the targets that a tour lacks.
std::vector<VisitPose> missingVisits(const std::vector<VisitPose>& tour, const std::vector<VisitPose>& sampled) {
  std::vector<VisitPose> missing;
  for (const VisitPose& visit : sampled) {
    const auto isSame = [&](const VisitPose& other) { return other.target == visit.target; };
    if (std::none_of(tour.begin(), tour.end(), isSame) && std::none_of(missing.begin(), missing.end(), isSame)) {
      missing.push_back(visit);
    }
  }
  return missing;
}

void takeSearchMetrics(const SearchResult& found, mission::PlanMetrics& metrics, PlanTimes& times) {
  const double sampledCost = metrics.sampledCost > 0.0 ? metrics.sampledCost : metrics.cost;
  metrics.lowerBound = found.lowerBound;
  metrics.optimal = found.optimal && sampledCost <= found.lowerBound * (1.0 + 1e-9);
  metrics.safeQueries += found.safeQueries;
  metrics.tourSolutions = found.tourSolutions;
  metrics.safeSegments = found.safeSegments;
  times.terrainSegments = found.terrainSeconds;
  times.safeSegments = found.safeSeconds;
  times.tourSolver = found.solverSeconds;
}

/// Refines basis.visits, which lack `missing`, and says in the metrics what it did.
Result<void> refineVisits(const PlanInput& input, const landing::World& world, SegmentBuilder& builder, const SegmentSettings& settings,
                          std::vector<VisitPose> missing, bool isReused, PlanBasis& basis, mission::PlanMetrics& metrics, const Job& job) {
  constexpr std::int64_t kQueriesOverReusedTour = 100;  // per target; most of it is refined already
  RefineOptions options;
  options.lowTargets = input.mission.planner.lowTargets;
  options.seed = input.mission.planner.seed;
  options.queriesPerTarget = isReused ? kQueriesOverReusedTour : options.queriesPerTarget;
  options.insert = std::move(missing);
  Result<RefineResult> refined = refineTour(world, builder, basis.visits, settings, options, job);
  if (!refined) {
    return forward(refined);
  }
  basis.visits = std::move(refined->visits);
  metrics.sampledCost = !isReused && std::isfinite(refined->costBefore) ? refined->costBefore : 0.0;
  metrics.movesTried = refined->movesTried;
  metrics.movesAccepted = refined->movesAccepted;
  metrics.safeQueries += builder.queries();
  if (isReused && !std::isfinite(refined->cost)) {
    return fail(Errc::NoSolution, "the tour before leaves no safe place for what changed");
  }
  return {};
}

std::vector<geo::Point> placesOf(const PlanInput& input) {
  std::vector<geo::Point> places;
  for (const mission::TargetInFrame& target : input.targets) {
    places.push_back(target.point);
  }
  return places;
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

landing::World makeWorld(const PlanInput& input, const terrain::TerrainPyramid& pyramid) {
  landing::World world;
  world.terrain = input.pyramid.levels() > 0 ? input.pyramid : pyramid.levels() > 0 ? pyramid : terrain::TerrainPyramid(input.terrain);
  world.glide = aircraft::GlideModel(input.mission.aircraft);
  world.sites = input.sites;
  world.clearance = input.mission.safety.clearance.si();
  world.arrivalMargin = input.mission.safety.arrivalMargin.si();
  return world;
}

}  // namespace

landing::World makeWorld(const PlanInput& input) {
  return makeWorld(input, {});
}

geo::Box roadmapArea(const PlanInput& input) {
  constexpr std::size_t kNearestSites = 3;
  constexpr double kMargin = 3000.0;  // m, room for glides around the outermost target or site
  geo::Box box;
  for (const mission::TargetInFrame& target : input.targets) {
    box.add(target.point);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t s = 0; s < input.sites.size(); ++s) {
      order.emplace_back(geo::distance(target.point, input.sites[s].pose.point()), s);
    }
    const std::size_t count = std::min(kNearestSites, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end());
    for (std::size_t i = 0; i < count; ++i) {
      box.add(input.sites[order[i].second].pose.point());
    }
  }
  for (const mission::SiteInFrame& site : input.sites) {
    const std::optional<mission::HomeBase>& home = input.mission.home;
    if (home && (site.site.id == home->takeoff || site.site.id == home->landing)) {
      box.add(site.pose.point());
    }
  }
  const geo::Box extent = input.terrain->extent();
  if (box.isEmpty()) {
    return extent;
  }
  box = box.grown(kMargin);
  return {std::max(box.minX, extent.minX), std::max(box.minY, extent.minY), std::min(box.maxX, extent.maxX), std::min(box.maxY, extent.maxY)};
}

Result<mission::Plan> planTour(const PlanInput& input, const Job& job, PlanTimes* times, const PlanObserver& observer, PlanFailure* failure,
                               PlanBasis* basis) {
  PlanFailure ignored;
  PlanFailure& why = failure != nullptr ? *failure : ignored;
  if (const std::optional<Error> error = checkTargets(input, why)) {
    return tl::unexpected(*error);
  }
  const mission::PlannerSettings& planner = input.mission.planner;
  PlanTimes spent;
  PlanBasis own = basis != nullptr ? *basis : PlanBasis{};
  landing::World world = makeWorld(input, own.pyramid);
  own.pyramid = world.terrain;

  auto start = Clock::now();
  if (const Result<void> provided = provideRoadmap(input, world, observer, own, job.part(0.0, 0.4)); !provided) {
    return forward(provided);
  }
  const landing::Roadmap& roadmap = *own.roadmap;
  spent.roadmap = secondsSince(start);

  const SegmentSettings settings = makeSettings(input.mission);
  const std::vector<VisitPose> visits = sampleHeadings(input);
  if (const std::optional<Error> error = hopelessTarget(input, world, roadmap, visits, settings.ceiling, why, job)) {
    return tl::unexpected(*error);
  }
  const Result<Detours> detours = Detours::find(world, placesOf(input), settings.ceiling, job);
  if (!detours) {
    return forward(detours);
  }
  std::optional<SearchResult> search;
  if (own.visits.empty()) {
    const SearchOptions options{planner.method, planner.tourSolver, input.lkhProgram, planner.seed, input.threads, own.floor, observer.roundDone};
    Result<SearchResult> found = searchTour(world, roadmap, *detours, visits, settings, options, job.part(0.4, 0.9));
    if (!found) {
      if (found.error().code == Errc::NoSolution) {
        return tl::unexpected(explainNoTour(input, world, roadmap, *detours, visits, settings, found.error(), job, why));
      }
      return forward(found);
    }
    for (const int node : found->tour) {
      own.visits.push_back(visits[static_cast<std::size_t>(node)]);
    }
    own.floor = found->floor;
    search = std::move(*found);
  }

  start = Clock::now();
  mission::Plan plan = emptyPlan(input);
  SegmentBuilder builder(world, roadmap, *detours, settings, job.stopToken(), own.floor.get());
  if (planner.refine == mission::Refine::Full) {
    const Result<void> refined =
        refineVisits(input, world, builder, settings, missingVisits(own.visits, visits), !search.has_value(), own, plan.metrics, job.part(0.9, 0.98));
    if (!refined) {
      return forward(refined);
    }
    spent.refinement = secondsSince(start);
    start = Clock::now();
  }
  const Result<double> assembled = assembleTour(world, builder, own.visits, settings, planner.lowTargets, plan, job);
  if (!assembled) {
    return forward(assembled);
  }
  if (const std::optional<Error> error = aboveCeiling(*assembled, settings.ceiling, why)) {
    return tl::unexpected(*error);
  }
  if (input.mission.home) {
    if (const Result<void> added = addHomePaths(world, roadmap, settings, plan, job); !added) {
      return forward(added);
    }
  }
  plan.metrics.roadmapExpansions = own.expansions;
  if (search) {
    takeSearchMetrics(*search, plan.metrics, spent);
  }
  spent.assembly = secondsSince(start);
  if (times != nullptr) {
    *times = spent;
  }
  if (basis != nullptr) {
    *basis = std::move(own);
  }
  job.progress(1.0, "planned");
  return plan;
}

}  // namespace vp::tour
