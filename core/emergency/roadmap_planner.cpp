#include "core/emergency/roadmap_planner.h"

#include "core/emergency/deadline_job.h"
#include "core/emergency/glide_flight.h"
#include "core/emergency/landing_goals.h"
#include "core/emergency/landing_outcome.h"
#include "core/landing/build_roadmap.h"
#include "core/landing/glide_straightener.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::emergency {
namespace {

Result<std::shared_ptr<const landing::Roadmap>> roadmapFor(const LandingRequest& request, const Countdown& countdown) {
  if (request.roadmap != nullptr) {
    return request.roadmap;
  }
  const DeadlineJob timed(request, countdown);
  landing::RoadmapRequest wanted;
  wanted.area = request.world->terrain.grid().extent();
  wanted.threads = request.threads;
  return landing::buildRoadmap(*request.world, request.mission->planner, wanted, timed.job());
}

/// The pieces of a witness up to the gate of its site.
std::vector<flight::Piece> upToGate(std::vector<flight::Piece> pieces, const landing::Approach& approach) {
  pieces.resize(pieces.size() - std::min(pieces.size(), approach.pieces.size()));
  return pieces;
}

/// How much higher the glide must begin than where it is, found by flying it [m]; 0 if it is high enough.
double missingFor(const LandingRequest& request, const landing::SafeAltitude& answer, const std::vector<flight::Piece>& pieces,
                  const landing::Approach& approach, std::optional<mission::LandingPath>& path) {
  constexpr double kStep = 1.0;    // m: turns in wind are flown at the rate of their dearest metre, which the roadmap's sum is a little below
  constexpr double kMost = 100.0;  // m
  const GlideFlight flight(*request.world);
  const double least = std::max(0.0, std::ceil(answer.altitude - request.altitude));
  for (double higher = least; higher <= least + kMost; higher += kStep) {
    geo::Pose pose = request.pose;
    std::vector<mission::LandingLeg> legs;
    const double altitude = flight.fly(pose, request.altitude + higher, pieces, &legs);
    if (altitude > GlideFlight::kTouches) {
      std::optional<mission::LandingPath> whole = withApproach(request, approach, std::move(legs), altitude);
      if (whole) {
        if (higher <= 0.0) {
          path = std::move(whole);
        }
        return higher;
      }
    }
  }
  return least + kMost;
}

/// The glide of an answer with few turns: from here, where the aircraft may turn at once.
std::vector<flight::Piece> straightened(const LandingRequest& request, const landing::Roadmap& roadmap, const landing::SafeAltitude& safe) {
  landing::World turning = *request.world;  // its terrain is shared
  turning.reactionLength = 0.0;
  turning.reactionLoss = 0.0;
  const landing::GlideStraightener straightener(turning, safe.site);
  return straightener.improved(request.pose, {}, {roadmap.witnessPieces(safe), safe.altitude}, safe.site, request.altitude).pieces;
}

}  // namespace

LandingAnswer RoadmapPlanner::plan(const LandingRequest& request) const {
  const Countdown countdown(request);
  if (std::optional<std::string> fault = requestFault(request)) {
    return answerToFault(request, name(), std::move(*fault));
  }
  const landing::World& world = *request.world;
  const Result<std::shared_ptr<const landing::Roadmap>> roadmap = roadmapFor(request, countdown);
  if (!roadmap) {
    const std::string why = roadmap.error().code == Errc::Cancelled
                                ? "There was not enough time to build the roadmap of landing glides: give a later deadline."
                                : fmt::format("There is no roadmap of landing glides: {}.", roadmap.error().what);
    return answerWithout(request, name(), why, 0.0, countdown);
  }
  landing::QueryScratch scratch;
  const std::optional<landing::SafeAltitude> safe = (*roadmap)->queryTurning(world, request.pose, scratch);
  const std::vector<Tried> tried{{"poses of the roadmap", static_cast<std::int64_t>((*roadmap)->size())},
                                 {"glides tried against the ground", scratch.legs}};
  const auto without = [&](const std::string& why, double missing) {
    LandingAnswer answer = answerWithout(request, name(), why, missing, countdown);
    answer.tried = tried;
    return answer;
  };
  if (!safe) {
    return without("The roadmap knows no glide from here to a runway, from any height.", 0.0);
  }
  if (request.onlySite && safe->site != *request.onlySite) {
    return without("The lowest glide that the roadmap knows from here is to another runway: ask another planner.", 0.0);
  }
  const Result<landing::Approach> approach = approachInLegs(world, static_cast<std::size_t>(safe->site));
  if (!approach) {
    return without(fmt::format("There is no approach to the runway of the roadmap: {}.", approach.error().what), 0.0);
  }
  std::optional<mission::LandingPath> path;
  double missing = missingFor(request, *safe, upToGate(straightened(request, **roadmap, *safe), *approach), *approach, path);
  if (!path) {
    missing = std::min(missing, missingFor(request, *safe, upToGate((*roadmap)->witnessPieces(*safe), *approach), *approach, path));
  }
  if (!path) {
    return without(fmt::format("The lowest glide that the roadmap knows from here, to {}, has to begin at {:.0f} m MSL: {:.0f} m are missing.",
                               world.sites[static_cast<std::size_t>(safe->site)].site.id, std::ceil(request.altitude + missing), std::ceil(missing)),
                   missing);
  }
  LandingAnswer answer = answerWith(request, LandingGoals(world, request.pose, request.altitude, request.onlySite), name(), std::move(*path));
  answer.tried = tried;
  answer.seconds = countdown.elapsed();
  if (request.better) {
    request.better(answer);
  }
  return answer;
}

}  // namespace vp::emergency
