#include "core/tour/planner.h"

#include "core/aircraft/wind_check.h"
#include "core/landing/approach.h"
#include "core/landing/build_roadmap.h"
#include "core/mission/glide_conditions.h"
#include "core/mission/settings_check.h"
#include "core/tour/assembly.h"
#include "core/tour/climb_limit.h"
#include "core/tour/free_bound.h"
#include "core/tour/home_path.h"
#include "core/tour/plan_failure.h"
#include "core/tour/refine.h"
#include "core/tour/segment_bound.h"
#include "core/tour/tour_search.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace vp::tour {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

SegmentSettings makeSettings(const mission::Mission& mission, const aircraft::GlideModel& glide) {
  SegmentSettings settings;
  settings.step = mission.planner.step.si();
  settings.beta = mission.planner.beta;
  settings.pitch = {glide.slopeOf(mission.aircraft.maxClimb), glide.slopeOf(mission.aircraft.maxDescent)};
  if (const std::optional<geo::HeightMsl> ceiling = mission::ceilingOf(mission)) {
    settings.ceiling = ceiling->metres();
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
  plan.airspaces = input.airspaces;
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

/// The bound of any tour, where it is cheap beside the refinement that it is compared with (0.03 s at 20 targets, growing with their square).
Result<void> addFreeBound(const PlanInput& input, const PlanBasis& basis, mission::PlanMetrics& metrics, const Job& job) {
  constexpr std::size_t kMostTargets = 60;
  const mission::PlannerSettings& planner = input.mission.planner;
  const bool isBounded = planner.refine == mission::Refine::Full && planner.lowTargets == mission::LowTargets::PassAbove;  // no bound with spirals
  if (!isBounded || !basis.floor || input.targets.size() > kMostTargets) {
    return {};
  }
  const Result<double> bound = freeLowerBound(*basis.floor, basis.visits, planner.beta, job);
  if (!bound) {
    return forward(bound);
  }
  metrics.freeLowerBound = *bound;
  return {};
}

std::vector<geo::Point> placesOf(const PlanInput& input) {
  std::vector<geo::Point> places;
  for (const mission::TargetInFrame& target : input.targets) {
    places.push_back(target.point);
  }
  return places;
}

landing::World makeWorld(const PlanInput& input, const terrain::TerrainPyramid& pyramid) {
  return landing::worldOf(input.mission, input.sites,
                          input.pyramid.levels() > 0 ? input.pyramid
                          : pyramid.levels() > 0     ? pyramid
                                                     : terrain::TerrainPyramid(input.terrain));
}

/// Searches order and headings into basis.visits, unless they are there; nothing in the second case.
Result<std::optional<SearchResult>> findVisits(const PlanTask& task, const PlanObserver& observer, PlanBasis& basis, PlanFailure& why, const Job& job,
                                               const Job& part) {
  if (!basis.visits.empty()) {
    return std::optional<SearchResult>();
  }
  const mission::PlannerSettings& planner = task.input.mission.planner;
  const SearchOptions options{planner.method,     planner.tourSolver, task.input.lkhProgram, planner.seed,
                              task.input.threads, basis.floor,        observer.roundDone};
  Result<SearchResult> found = searchTour(task.world, task.roadmap, task.detours, task.sampled, task.settings, options, part);
  if (!found) {
    if (found.error().code == Errc::NoSolution) {
      return tl::unexpected(explainNoTour(task, job, why));
    }
    return forward(found);
  }
  for (const int node : found->tour) {
    basis.visits.push_back(task.sampled[static_cast<std::size_t>(node)]);
  }
  basis.floor = found->floor;
  return std::optional<SearchResult>(std::move(*found));
}

/// Search and refinement do not count what rolling asks for. Where it raised the refined tour, the one before is joined too: the one
/// below the ceiling counts, and of two the cheaper.
void takeCheaper(const PlanTask& task, SegmentBuilder& builder, const std::vector<VisitPose>& sampled, PlanBasis& basis, mission::Plan& plan,
                 Assembled& assembled, const Job& job) {
  mission::Plan before = emptyPlan(task.input);
  const Result<Assembled> joined = assembleTour(task.world, builder, sampled, task.settings, task.input.mission.planner.lowTargets, before, job);
  if (!joined) {
    plan.metrics.sampledCost = 0.0;
    return;
  }
  plan.metrics.sampledCost = before.metrics.cost;
  const bool isBelow = joined->peak <= task.settings.ceiling;
  const bool isRefinedBelow = assembled.peak <= task.settings.ceiling;
  if (isBelow != isRefinedBelow ? isBelow : before.metrics.cost < plan.metrics.cost) {
    plan.tour = std::move(before.tour);
    plan.spirals = std::move(before.spirals);
    plan.metrics.cost = before.metrics.cost;
    plan.metrics.length = before.metrics.length;
    plan.metrics.penalty = before.metrics.penalty;
    basis.visits = sampled;
    assembled = *joined;
  }
}

/// Refines basis.visits where that is asked for, and joins them to a plan.
Result<mission::Plan> buildPlan(const PlanTask& task, bool isReused, PlanBasis& basis, PlanTimes& spent, PlanFailure& why, const Job& job) {
  auto start = Clock::now();
  const mission::PlannerSettings& planner = task.input.mission.planner;
  mission::Plan plan = emptyPlan(task.input);
  SegmentBuilder builder(task.world, task.roadmap, task.detours, task.settings, job.stopToken(), basis.floor.get());
  const std::vector<VisitPose> sampled = basis.visits;
  if (planner.refine == mission::Refine::Full) {
    const Result<void> refined = refineVisits(task.input, task.world, builder, task.settings, missingVisits(basis.visits, task.sampled), isReused,
                                              basis, plan.metrics, job.part(0.9, 0.98));
    if (!refined) {
      return forward(refined);
    }
    spent.refinement = secondsSince(start);
    start = Clock::now();
  }
  Result<Assembled> assembled = assembleTour(task.world, builder, basis.visits, task.settings, planner.lowTargets, plan, job);
  if (assembled && assembled->isRaised && plan.metrics.sampledCost > 0.0) {
    takeCheaper(task, builder, sampled, basis, plan, *assembled, job);
  }
  if (!assembled) {
    return forward(assembled);
  }
  if (const std::optional<Error> error = aboveCeiling(assembled->peak, task.settings.ceiling, why)) {
    return tl::unexpected(*error);
  }
  if (task.input.mission.home) {
    if (const Result<void> added = addHomePaths(task.world, task.roadmap, task.settings, plan, job); !added) {
      return forward(added);
    }
  }
  spent.assembly = secondsSince(start);
  return plan;
}

/// Ways around barred ground, and around forbidden airspace where there is any.
Result<Detours> findDetours(const PlanInput& input, const landing::World& world, const std::vector<VisitPose>& visits,
                            const SegmentSettings& settings, PlanBasis& basis, const Job& job) {
  const std::vector<geo::Point> places = placesOf(input);
  Result<Detours> detours = Detours::find(world, places, settings.ceiling, job);
  if (!detours || settings.forbidden == nullptr) {
    return detours;
  }
  if (!basis.floor) {
    auto floor = buildFloor(world, visits, job);
    if (!floor) {
      return forward(floor);
    }
    basis.floor = std::move(*floor);
  }
  const Result<void> found = detours->findAround(*settings.forbidden, *basis.floor, world, places, settings.ceiling, job);
  return found ? std::move(detours) : forward(found);
}

/// Search, refinement and loop.
Result<mission::Plan> attempt(const PlanTask& task, const PlanObserver& observer, PlanBasis& basis, PlanTimes& spent, PlanFailure& why,
                              const Job& job) {
  const Result<std::optional<SearchResult>> search = findVisits(task, observer, basis, why, job, job.part(0.4, 0.9));
  if (!search) {
    return forward(search);
  }
  Result<mission::Plan> plan = buildPlan(task, !search->has_value(), basis, spent, why, job);
  if (plan && *search) {
    takeSearchMetrics(**search, plan->metrics, spent);
  }
  return plan;
}

/** The second attempt where forbidden airspace is in the way: around every airspace that no target lies in, neither under nor over it.
 *  What each leg may do alone, the loop may not: a leg from above leaves the next one no height to pass below. No bound is known then: its
 *  own search knows only tours that go around, the one before knew other ways. */
Result<mission::Plan> attemptAround(const PlanTask& task, Result<mission::Plan> first, const PlanObserver& observer, PlanBasis& basis,
                                    PlanTimes& spent, const Job& job) {
  const ForbiddenAirspace walls = task.settings.forbidden->walledBut(placesOf(task.input));
  SegmentSettings settings = task.settings;
  settings.forbidden = &walls;
  const Result<Detours> detours = findDetours(task.input, task.world, task.sampled, settings, basis, job);
  if (!detours) {
    return forward(detours);
  }
  const PlanTask around{task.input, task.world, task.roadmap, *detours, settings, task.sampled};
  PlanFailure ignored;
  basis.visits.clear();
  Result<mission::Plan> plan = attempt(around, observer, basis, spent, ignored, job);
  if (plan) {
    plan->metrics.lowerBound = 0.0;
    plan->metrics.optimal = false;
    return plan;
  }
  return plan.error().code == Errc::NoSolution ? std::move(first) : std::move(plan);
}

}  // namespace

landing::World makeWorld(const PlanInput& input) {
  return makeWorld(input, {});
}

geo::Box roadmapArea(const PlanInput& input) {
  constexpr std::size_t kNearestSites = 3;
  constexpr double kMargin = 3000.0;  // m, room for glides around the outermost target or site
  geo::Box box;
  const auto addSite = [&](std::size_t number) {
    box.add(input.sites[number].pose.point());
    box.add(landing::gateOf(input.mission.approach, input.sites[number]).point());
  };
  for (const mission::TargetInFrame& target : input.targets) {
    box.add(target.point);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t s = 0; s < input.sites.size(); ++s) {
      order.emplace_back(geo::distance(target.point, input.sites[s].pose.point()), s);
    }
    const std::size_t count = std::min(kNearestSites, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end());
    for (std::size_t i = 0; i < count; ++i) {
      addSite(order[i].second);
    }
  }
  for (const mission::SiteInFrame& site : input.sites) {
    const std::optional<mission::HomeBase>& home = input.mission.home;
    if (home && (site.site.id == home->takeoff || site.site.id == home->landing)) {
      addSite(static_cast<std::size_t>(&site - input.sites.data()));
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
  if (const auto fault = mission::settingFaultForAircraft(input.mission)) {
    return fail(Errc::OutOfRange, fault->sentence);
  }
  if (const auto fault = aircraft::windFault(input.mission.aircraft, mission::glideConditionsOf(input.mission, input.sites))) {
    return fail(Errc::OutOfRange, fault->sentence);
  }
  if (const std::optional<Error> error = checkTargets(input, why)) {
    return tl::unexpected(*error);
  }
  PlanTimes spent;
  PlanBasis own = basis != nullptr ? *basis : PlanBasis{};
  landing::World world = makeWorld(input, own.pyramid);
  own.pyramid = world.terrain;

  const auto start = Clock::now();
  if (const Result<void> provided = provideRoadmap(input, world, observer, own, job.part(0.0, 0.4)); !provided) {
    return forward(provided);
  }
  const landing::Roadmap& roadmap = *own.roadmap;
  spent.roadmap = secondsSince(start);

  const ForbiddenAirspace forbidden(input.airspaces, input.mission.airspace, input.frame);
  SegmentSettings settings = makeSettings(input.mission, world.glide);
  settings.forbidden = forbidden.isEmpty() ? nullptr : &forbidden;
  const std::vector<VisitPose> visits = sampleHeadings(input);
  if (const std::optional<Error> error = hopelessTarget(input, world, roadmap, visits, settings, why, job)) {
    return tl::unexpected(*error);
  }
  const Result<Detours> detours = findDetours(input, world, visits, settings, own, job);
  if (!detours) {
    return forward(detours);
  }
  const PlanTask task{input, world, roadmap, *detours, settings, visits};
  const std::vector<VisitPose> given = own.visits;
  Result<mission::Plan> plan = planWithinClimb(input.mission, world, settings.pitch, [&] {
    own.visits = given;
    Result<mission::Plan> once = attempt(task, observer, own, spent, why, job);
    if (!once && once.error().code == Errc::NoSolution && !forbidden.isEmpty() && given.empty()) {
      once = attemptAround(task, std::move(once), observer, own, spent, job);
    }
    return once;
  });
  if (!plan) {
    return plan;
  }
  landing::setHolds(world, *plan);
  plan->metrics.roadmapExpansions = own.expansions;
  if (const Result<void> bounded = addFreeBound(input, own, plan->metrics, job); !bounded) {
    return forward(bounded);
  }
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
