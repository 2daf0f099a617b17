// Sites and targets of a plan against the mission embedded in it, the frame, and the terrain.

#include "core/safety/check_context.h"
#include "core/safety/landing_length.h"
#include "core/safety/limits.h"
#include "core/safety/rules.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace vp::safety {
namespace {

double courseDifference_deg(Angle a, Angle b) {
  return std::abs(Angle::radians(wrapPi(a.radians() - b.radians())).degrees());
}

/// The same place, height and course, allowing for the decimals of a file.
bool isSameSite(const mission::LandingSite& a, const mission::LandingSite& b) {
  return std::abs(a.touchdown.latitude_deg - b.touchdown.latitude_deg) <= 1e-7 &&
         std::abs(a.touchdown.longitude_deg - b.touchdown.longitude_deg) <= 1e-7 &&
         std::abs(a.elevation.metres() - b.elevation.metres()) <= kClaimTolerance && courseDifference_deg(a.landingCourse, b.landingCourse) <= 0.01;
}

/// True if the mission allows landings only on `oneWay`, and `site` is its other end.
bool isRefusedEnd(const mission::Plan& plan, const mission::LandingSite& site, const std::string& oneWay) {
  if (site.id == oneWay) {
    return false;
  }
  const std::size_t slash = oneWay.rfind('/');
  if (slash != std::string::npos && site.airportIdent == oneWay.substr(0, slash)) {
    std::string own = oppositeEnd(site.runwayIdent);
    const std::string allowed = oppositeEnd(oppositeEnd(oneWay.substr(slash + 1)));  // "3" and "03" are one
    if (!own.empty() && own == allowed) {
      return true;
    }
  }
  for (const mission::SiteInFrame& other : plan.sites) {  // other names of runway ends: by their geometry
    if (other.site.id == oneWay && other.site.airportIdent == site.airportIdent && oppositeEnd(site.runwayIdent).empty() &&
        courseDifference_deg(other.site.landingCourse, site.landingCourse) > 179.0) {
      return true;
    }
  }
  return false;
}

/// Why a site read from a file does not fit the newer rules of the filter; empty if it does.
std::string whyUnsuited(const mission::Mission& mission, const mission::LandingSite& site) {
  const mission::SiteFilter& filter = mission.siteFilter;
  if (filter.minWidth && site.width && *site.width < *filter.minWidth) {
    return fmt::format("it is {:.0f} m wide, the mission asks for {:.0f} m", site.width->si(), filter.minWidth->si());
  }
  if (!filter.surfaces.empty() && std::count(filter.surfaces.begin(), filter.surfaces.end(), site.surface) == 0) {
    return "its surface is not one that the mission allows";
  }
  if (filter.lighted && !site.lighted) {
    return "it is not lighted, which the mission asks for";
  }
  if (!filter.maxDistance || (!filter.distanceFrom && mission.targets.empty())) {
    return {};
  }
  double nearest = filter.distanceFrom ? geo::geodesicDistance(*filter.distanceFrom, site.touchdown).si() : kNoHeight;
  if (!filter.distanceFrom) {
    for (const mission::Target& target : mission.targets) {
      nearest = std::min(nearest, geo::geodesicDistance(target.position, site.touchdown).si());
    }
  }
  if (!(nearest <= filter.maxDistance->si() + kFrameTolerance)) {
    return fmt::format("it lies {:.1f} km away, the mission allows {:.1f} km", nearest / 1000.0, filter.maxDistance->si() / 1000.0);
  }
  return {};
}

/// Why the wind of the mission forbids landing there; empty if it does not.
std::string whyTooWindy(const mission::Mission& mission, const mission::LandingSite& site) {
  constexpr double kSlack = 1e-6;  // m/s
  const RunwayWinds wind = runwayWinds(mission, site);
  if (const auto& limit = mission.aircraft.maxTailwind; limit && wind.tail > limit->si() + kSlack) {
    return fmt::format("the wind may blow from behind at {:.1f} m/s, the aircraft allows {:.1f} m/s", wind.tail, limit->si());
  }
  if (const auto& limit = mission.aircraft.maxCrosswind; limit && wind.cross > limit->si() + kSlack) {
    return fmt::format("the wind may blow across at {:.1f} m/s, the aircraft allows {:.1f} m/s", wind.cross, limit->si());
  }
  return {};
}

/// Why the mission does not let this site count; empty if it does.
std::string whyExcluded(const mission::Plan& plan, const mission::LandingSite& site, bool isNamed) {
  const mission::SiteFilter& filter = plan.mission.siteFilter;
  for (const std::string& id : filter.exclude) {
    if (id == site.id || (!site.airportIdent.empty() && id == site.airportIdent)) {
      return fmt::format("the mission excludes {}", id);
    }
  }
  for (const std::string& id : filter.oneWay) {
    if (isRefusedEnd(plan, site, id)) {
      return fmt::format("the mission allows landings on {} only", id);
    }
  }
  if (std::string windy = whyTooWindy(plan.mission, site); !windy.empty() || isNamed) {
    return windy;
  }
  if (plan.mission.airfields.empty()) {
    return "the mission names neither this site nor any airfield file it could come from";
  }
  if (site.isApproximate() && !filter.approximate) {
    return "its geometry is approximate, which the mission excludes";
  }
  if (site.surface == mission::Surface::Water && !filter.water) {
    return "it is water, which the mission excludes";
  }
  if (filter.minLength && site.length && *site.length < *filter.minLength) {
    return fmt::format("it is {:.0f} m long, the mission asks for {:.0f} m", site.length->si(), filter.minLength->si());
  }
  return whyUnsuited(plan.mission, site);
}

/// Highest value of the closed cells around a place, as the checker counts them; infinity where unknown.
double groundAt(const CheckContext& context, geo::Point point) {
  const double ground = context.terrain.upperAt(point);
  return ground >= kLowestGround ? ground : kNoHeight;
}

void checkTargetInFrame(CheckContext& context, const mission::TargetInFrame& placed) {
  const mission::Target& target = placed.target;
  const FindingPlace place{-1, placed.point};
  const double offset = geo::distance(context.frame.toPoint(target.position), placed.point);
  if (!(offset <= kFrameTolerance)) {
    context.findings.violated(rule::kTargetPosition,
                              fmt::format("target {}: the plan has it {:.2f} m away from its own position", target.name, offset), place, -offset);
  }
  double altitude = target.height_m;
  if (target.reference == mission::HeightReference::AboveGround) {
    const double ground = groundAt(context, placed.point);
    if (!(ground < kNoHeight)) {
      context.findings.unknown(rule::kTerrainUnknown, fmt::format("target {}: the terrain below it is unknown, so its altitude is", target.name),
                               place);
      return;
    }
    altitude += ground;
  }
  if (!(std::abs(altitude - placed.altitude) <= kTargetHeightTolerance)) {
    context.findings.violated(
        rule::kTargetAltitude,
        fmt::format("target {}: the plan puts it at {:.1f} m MSL, terrain and mission at {:.1f} m", target.name, placed.altitude, altitude), place);
  }
}

}  // namespace

void checkSite(CheckContext& context, const mission::SiteInFrame& placed) {
  const mission::LandingSite& site = placed.site;
  const FindingPlace place{-1, placed.pose.point()};
  const double offset = geo::distance(context.frame.toPoint(site.touchdown), placed.pose.point());
  const double heading = context.frame.headingOf(site.landingCourse, site.touchdown);
  const double turned = std::abs(Angle::radians(wrapPi(heading - placed.pose.heading)).degrees());
  if (!(offset <= kFrameTolerance) || !(turned <= kFrameCourseTolerance)) {
    context.findings.violated(
        rule::kSitePosition,
        fmt::format("landing site {}: the plan uses it {:.2f} m and {:.3f} degrees away from its own position and course", site.id, offset, turned),
        place);
  }
  bool isNamed = false;
  for (const mission::LandingSite& given : context.plan.mission.sites) {
    if (given.id == site.id) {
      isNamed = true;
      if (!isSameSite(given, site)) {
        context.findings.violated(rule::kSiteData, fmt::format("landing site {}: position, elevation or course differ from the mission's", site.id),
                                  place);
      }
    }
  }
  const std::string reason = whyExcluded(context.plan, site, isNamed);
  if (!reason.empty()) {
    context.findings.violated(rule::kSiteExcluded, fmt::format("landing site {} must not be used: {}", site.id, reason), place);
  }
}

void checkSites(CheckContext& context) {
  std::set<std::string> ids;
  for (const mission::SiteInFrame& site : context.plan.sites) {
    if (!ids.insert(site.site.id).second) {
      context.findings.violated(rule::kSiteData, fmt::format("landing site {} is listed twice", site.site.id), {-1, site.pose.point()});
    }
    checkSite(context, site);
  }
}

void checkTargets(CheckContext& context) {
  const mission::Plan& plan = context.plan;
  std::map<std::string, const mission::Target*> asked;
  for (const mission::Target& target : plan.mission.targets) {
    if (!asked.emplace(target.name, &target).second) {
      context.findings.violated(rule::kTargetData, fmt::format("the mission has two targets named {}", target.name));
    }
  }
  std::set<std::string> planned;
  for (const mission::TargetInFrame& placed : plan.targets) {
    const auto found = asked.find(placed.target.name);
    if (found == asked.end() || !(*found->second == placed.target)) {
      context.findings.violated(rule::kTargetData,
                                fmt::format("target {} of the plan is not as the mission has it (position, height or reference)", placed.target.name),
                                {-1, placed.point});
    }
    if (!planned.insert(placed.target.name).second) {
      context.findings.violated(rule::kTargetData, fmt::format("target {} is listed twice in the plan", placed.target.name), {-1, placed.point});
    }
    checkTargetInFrame(context, placed);
  }
  for (const mission::Target& target : plan.mission.targets) {
    if (!planned.contains(target.name)) {
      context.findings.violated(rule::kTargetSkipped, fmt::format("target {} of the mission is not in the plan", target.name),
                                {-1, context.frame.toPoint(target.position)});
    }
  }
}

}  // namespace vp::safety
