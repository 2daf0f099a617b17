#include "core/emergency/anytime_planner.h"

#include "core/emergency/anytime_search.h"

#include <fmt/format.h>

#include <utility>

namespace vp::emergency {
namespace {

std::vector<Tried> triedBy(const AnytimeCounts& counts, const LandingGoals& goals) {
  return {{"runways in range", static_cast<std::int64_t>(goals.inRange().size())},
          {"direct glides", counts.direct},
          {"samples", counts.samples},
          {"poses", counts.poses},
          {"glides tried against the ground", counts.glides},
          {"rewired", counts.rewired},
          {"improvements", counts.improved}};
}

/// The best so far as an answer; tells the request of it.
LandingAnswer tell(const LandingRequest& request, const LandingGoals& goals, const AnytimeSearch& search, const Countdown& countdown) {
  LandingAnswer answer = answerWith(request, goals, "anytime", *search.best());
  answer.tried = triedBy(search.counts(), goals);
  answer.seconds = countdown.elapsed();
  if (request.better) {
    request.better(answer);
  }
  return answer;
}

}  // namespace

LandingAnswer AnytimePlanner::plan(const LandingRequest& request) const {
  const Countdown countdown(request);
  if (std::optional<std::string> fault = requestFault(request)) {
    return answerToFault(request, name(), std::move(*fault));
  }
  const LandingGoals goals(*request.world, request.pose, request.altitude, request.onlySite);
  if (goals.inRange().empty()) {
    return answerWithout(request, name(), goals.whyNone(), goals.missing(), countdown);
  }
  AnytimeSearch search(request, goals);
  search.tryDirect(countdown);
  std::int64_t told = 0;
  LandingAnswer answer;
  for (std::int64_t i = 0; !search.isFinished() && !countdown.isOver() && i < iterations_; ++i) {
    if (request.better && search.counts().improved > told) {
      told = search.counts().improved;
      answer = tell(request, goals, search, countdown);
    }
    search.grow();
  }
  if (!search.best()) {
    const std::string why =
        fmt::format("No glide to any of the {} runway ends that are near enough stays clear of the ground, of {} that were tried.",
                    goals.inRange().size(), search.counts().glides);
    LandingAnswer without = answerWithout(request, name(), why, 0.0, countdown);
    without.tried = triedBy(search.counts(), goals);
    return without;
  }
  answer = tell(request, goals, search, countdown);
  if (answer.lowerBound && search.isFinished()) {
    answer.notes.push_back("No path leaves more height in hand by half a metre or more.");
  }
  return answer;
}

}  // namespace vp::emergency
