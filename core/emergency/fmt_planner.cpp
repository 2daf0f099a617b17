#include "core/emergency/fmt_planner.h"

#include "core/emergency/landing_outcome.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace vp::emergency {
namespace {

std::vector<Tried> triedBy(const FmtSearchCounts& counts, const LandingGoals& goals) {
  return {{"runways in range", static_cast<std::int64_t>(goals.inRange().size())},
          {"leaves of free space", counts.leaves},
          {"samples", counts.samples},
          {"samples reached", counts.visited},
          {"legs tried against the ground", counts.tested},
          {"ways made flyable", counts.smoothed},
          {"improvements", counts.improved}};
}

}  // namespace

FmtOptions FmtPlanner::plain() {
  FmtOptions options;
  options.usesOctree = false;
  options.first += static_cast<std::size_t>(options.further) * options.second;
  options.second = 0;
  options.further = 0;
  return options;
}

LandingAnswer FmtPlanner::plan(const LandingRequest& request) const {
  const Countdown countdown(request);
  if (std::optional<std::string> fault = requestFault(request)) {
    return answerToFault(request, name(), std::move(*fault));
  }
  const LandingGoals goals(*request.world, request.pose, request.altitude, request.onlySite);
  if (goals.inRange().empty()) {
    return answerWithout(request, name(), goals.whyNone(), goals.missing(), countdown);
  }
  FmtSearch search(request, goals, options_, countdown);
  const auto answer = [&] {
    LandingAnswer found = answerWith(request, goals, name(), *search.best());
    found.tried = triedBy(search.counts(), goals);
    found.seconds = countdown.elapsed();
    if (request.risk != nullptr) {
      found.notes.push_back("This planner keeps height and looks at no risk: its risk is told, not kept low.");
    }
    return found;
  };
  std::int64_t told = 0;
  const auto tell = [&] {
    if (request.better && search.counts().improved > told) {
      told = search.counts().improved;
      request.better(answer());
    }
  };
  search.tryDirect();
  tell();
  for (int round = 0; round < options_.rounds && !countdown.isOver() && !search.isFinished(); ++round) {
    search.run(round);
    tell();
    if (search.best()) {
      break;
    }
  }
  if (search.best()) {
    return answer();
  }
  const std::string why =
      fmt::format("No glide to any of the {} runway ends that are near enough stays clear of the ground, of {} ways that were tried.",
                  goals.inRange().size(), search.counts().smoothed);
  LandingAnswer without = answerWithout(request, name(), why, 0.0, countdown);
  without.tried = triedBy(search.counts(), goals);
  return without;
}

}  // namespace vp::emergency
