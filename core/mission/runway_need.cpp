#include "core/mission/runway_need.h"

#include "core/aircraft/landing_distance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::mission {
namespace {

constexpr double kOppositeWithin = 10.0;  // degrees that the courses of two ends may differ from 180
constexpr double kAheadWithin = 10.0;     // degrees that the other end may lie beside the landing course
constexpr double kNearest = 50.0;         // m, ends nearer than this make no slope
constexpr double kFarthest = 1.5;         // of the known length; displaced thresholds are nearer

double difference(Angle a, Angle b) {
  return std::abs(wrapPi((a - b).radians())) * 180.0 / Angle::kPi;
}

/// Percent that the runway falls along the landing course; 0 where the other end is not known.
double downhillPercent(const LandingSite& site, const std::vector<SiteInFrame>& sites) {
  for (const SiteInFrame& other : sites) {
    const LandingSite& end = other.site;
    const bool isOpposite = end.airportIdent == site.airportIdent && end.source == site.source &&
                            difference(end.landingCourse, site.landingCourse) > 180.0 - kOppositeWithin;
    if (!isOpposite || end.touchdown == site.touchdown) {
      continue;
    }
    const double apart = geo::geodesicDistance(site.touchdown, end.touchdown).si();
    const bool isThere = apart >= kNearest && (!site.length || apart <= kFarthest * site.length->si());
    if (isThere && difference(geo::geodesicCourse(site.touchdown, end.touchdown), site.landingCourse) < kAheadWithin) {
      return 100.0 * (site.elevation.metres() - end.elevation.metres()) / apart;
    }
  }
  return 0.0;
}

double factorOf(Surface surface) {
  switch (surface) {
    case Surface::Hard:
      return aircraft::kHardFactor;
    case Surface::Gravel:
      return aircraft::kGravelFactor;
    case Surface::Grass:
      return aircraft::kGrassFactor;
    case Surface::Dirt:
    case Surface::Snow:
      return aircraft::kSoftFactor;
    case Surface::Water:
    case Surface::Unknown:
      break;
  }
  return aircraft::kUnknownSurfaceFactor;
}

}  // namespace

std::optional<Length> landingNeed(const Mission& mission, const LandingSite& site, const std::vector<SiteInFrame>& sites) {
  if (site.surface == Surface::Water) {
    return std::nullopt;
  }
  aircraft::LandingConditions conditions;
  conditions.air = mission.atmosphere.value_or(air::Atmosphere());
  conditions.elevation = site.elevation;
  conditions.wind = aircraft::runwayWind(mission.wind, site.elevation, site.landingCourse);
  conditions.downhillPercent = downhillPercent(site, sites);
  conditions.surfaceFactor = factorOf(site.surface);
  return aircraft::landingDistance(mission.aircraft, conditions);
}

std::string tooShort(const Mission& mission, const LandingSite& site, const std::vector<SiteInFrame>& sites) {
  const std::optional<Length> need = landingNeed(mission, site, sites);
  if (!need || !site.length || *need <= *site.length) {
    return {};
  }
  return fmt::format("{:.0f} m long, {:.0f} m needed", std::floor(site.length->si()), std::ceil(need->si()));
}

}  // namespace vp::mission
