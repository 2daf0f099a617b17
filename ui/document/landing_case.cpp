#include "ui/document/landing_case.h"

#include "core/emergency/landing_outcome.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace vp::document {
namespace {

constexpr double kSuccessSteps = 1000.0;  // probabilities that read the same, in tenths of a percent, count as equal

}  // namespace

ShownLanding shownLanding(emergency::LandingAnswer answer, const landing::World& world) {
  ShownLanding shown;
  shown.answer = std::move(answer);
  const std::optional<mission::LandingPath>& path = shown.answer.path;
  if (!path) {
    return shown;
  }
  EngineOut& glide = shown.glide;
  if (path->site >= 0) {
    shown.site = world.sites[static_cast<std::size_t>(path->site)];
  }
  const terrain::ElevationGrid& grid = world.terrain.grid();
  const auto add = [&](const geo::Pose& at, double height) { addGlidePoint(glide, at, height, grid.upperAt(at.point())); };
  geo::Pose pose = path->start;
  double altitude = path->altitude;
  glide.from.pose = pose;
  glide.from.altitude = altitude;
  glide.from.ground = grid.upperAt(pose.point());
  glide.site = path->site;
  glide.margin = shown.answer.heightInHand;
  add(pose, altitude);
  for (const mission::LandingLeg& leg : path->legs) {
    const int parts = leg.piece.length > 0.0 ? std::max(1, static_cast<int>(std::ceil(leg.piece.length / PlanView::kGlideSpacing))) : 0;
    const double before = glide.length;
    for (int k = 1; k <= parts; ++k) {
      const double share = static_cast<double>(k) / parts;
      glide.length = before + share * leg.piece.length;
      add(flight::poseAfter(pose, leg.piece, share * leg.piece.length), altitude + share * (leg.endAltitude - altitude));
    }
    glide.seconds += flight::glideSeconds(world.glide, pose, leg.piece);
    pose = flight::endOf(pose, leg.piece);
    altitude = leg.endAltitude;
  }
  if (shown.site) {
    glide.surplus = altitude - shown.site->site.elevation.metres();
  }
  return shown;
}

ShownRunway shownRunway(emergency::RankedRunway runway, const landing::World& world) {
  ShownRunway shown;
  shown.site = world.sites[static_cast<std::size_t>(runway.site)];
  shown.isReached = runway.isReached;
  shown.logRisk = runway.logRisk;
  shown.lines = std::move(runway.lines);
  shown.landing = shownLanding(std::move(runway.answer), world);
  return shown;
}

std::optional<double> termOf(const emergency::LandingAnswer& answer, const std::string& name) {
  const auto found = std::find_if(answer.terms.begin(), answer.terms.end(), [&](const emergency::CostTerm& term) { return term.name == name; });
  return found == answer.terms.end() ? std::nullopt : std::optional(found->value);
}

int bestLanding(const std::vector<ShownLanding>& landings) {
  const auto rank = [](const ShownLanding& one) {
    const bool isSafe = one.answer.verified && one.answer.reachesRunway();
    const double success = isSafe ? termOf(one.answer, emergency::kWeatherSuccess).value_or(1.0) : 1.0;
    const double shown = std::floor(success * kSuccessSteps + 0.5);
    return std::make_tuple(isSafe, one.answer.reachesRunway(), shown, isSafe ? one.answer.heightInHand : one.glide.length);
  };
  int best = -1;
  for (std::size_t i = 0; i < landings.size(); ++i) {
    const bool isBetter = best < 0 || rank(landings[i]) > rank(landings[static_cast<std::size_t>(best)]);
    if (landings[i].answer.path && isBetter) {
      best = static_cast<int>(i);
    }
  }
  return best;
}

}  // namespace vp::document
