// What a pilot is told about a plan in which nothing is violated or unknown.

#include "core/safety/check_context.h"
#include "core/safety/limits.h"
#include "core/safety/rules.h"

#include <fmt/core.h>

#include <cmath>

namespace vp::safety {
namespace {

/// A 172 simulated with six degrees of freedom ended up to 30 m below the point-mass model that plans are made with, at 45
/// degrees of bank (DESIGN section 2, "What the model leaves out").
constexpr double kDynamicsAllowance = 30.0;  // m

/// Cells hold upper bounds, so no runway lies above its cell unless heights or datums disagree.
constexpr double kRunwayAboveTerrain = 30.0;  // m

void warnAboutSite(CheckContext& context, const mission::SiteInFrame& placed) {
  const mission::LandingSite& site = placed.site;
  const FindingPlace place{-1, placed.pose.point()};
  if (site.isApproximate()) {
    std::string what;
    for (const std::string& item : site.approximations) {
      what += (what.empty() ? "" : "; ") + item;
    }
    context.findings.warning(rule::kSiteApproximate, fmt::format("landing site {} is approximate: {}", site.id, what), place);
  }
  const double ground = context.terrain.upperAt(placed.pose.point());
  if (site.elevation.metres() > ground + kRunwayAboveTerrain) {
    context.findings.warning(rule::kSiteElevation,
                             fmt::format("landing site {} is given at {:.0f} m MSL, but the terrain there is at most {:.0f} m: check both heights",
                                         site.id, site.elevation.metres(), ground),
                             place);
  }
}

/// Without a rate of roll: as it was measured on an aircraft that is not this one.
void warnAboutRolling(CheckContext& context) {
  if (!context.rollCost && context.clearance < kDynamicsAllowance) {
    context.findings.warning(
        rule::kSettingsClearance,
        fmt::format("the clearance of {:.0f} m leaves no room for what the glide model leaves out (rolling into turns: up to {:.0f} m)",
                    context.clearance, kDynamicsAllowance));
  }
}

std::string rollingText(const CheckContext& context) {
  if (!context.rollCost) {
    return "rolling into turns is not modelled and is covered by the clearance only";
  }
  return fmt::format("rolling into turns and out of them, at {:.10g} degrees per second, may cost up to {:.0f} m, for which every glide has the "
                     "height above the ground",
                     *context.plan.mission.aircraft.rollRate_dps, std::ceil(context.mostRolling));
}

}  // namespace

void addWarnings(CheckContext& context) {
  for (const std::string& text : aircraft::profileWarnings(context.plan.mission.aircraft)) {
    context.findings.warning(rule::kAircraftWarning, text);
  }
  warnAboutRolling(context);
  addConditionWarnings(context);
  for (std::size_t i = 0; i < context.plan.sites.size(); ++i) {
    if (i < context.siteUsed.size() && context.siteUsed[i]) {
      warnAboutSite(context, context.plan.sites[i]);
    }
  }
}

mission::Certificate issueCertificate(const CheckContext& context, const std::vector<Finding>& findings,
                                      const std::vector<mission::Margin>& margins) {
  const mission::Plan& plan = context.plan;
  const auto sites = std::count(context.siteUsed.begin(), context.siteUsed.end(), true);
  const std::string profile = plan.mission.aircraft.name.empty() ? plan.mission.aircraft.id : plan.mission.aircraft.name;
  const std::string runways = sites == 1 ? std::string("the one runway end used") : fmt::format("one of {} runway ends", sites);
  mission::Certificate certificate;
  certificate.pointsChecked = static_cast<std::int64_t>(plan.tour.size());
  certificate.glidesChecked = certificate.pointsChecked;
  for (const std::optional<mission::HomePath>* path : {&plan.departure, &plan.arrival}) {
    if (*path) {
      const auto points = static_cast<std::int64_t>((*path)->points.size());
      certificate.pointsChecked += points;
      certificate.glidesChecked += points - (*path)->guaranteed;
    }
  }
  certificate.margins = margins;
  const GlideRates& rates = context.rates;
  const std::string air = rates.isCalm() ? windText({}) : windText(plan.mission.wind);
  const std::string windRatio =
      rates.isCalm() ? std::string() : fmt::format(" in still air, {:.1f} against the strongest wind", 1.0 / rates.mostStraight());
  const Airspeeds& glide = rates.conditions().glide;
  const std::string speeds = glide.least < glide.most ? fmt::format("{:.1f} to {:.1f}", glide.least, glide.most) : fmt::format("{:.1f}", glide.most);
  // Heights are written in full: rounding would promise more than was checked.
  certificate.statement = fmt::format(
      "From every point of this tour ({} decision points and all points between them) the aircraft, its engine stopped and gliding at {} m/s in "
      "{} with the polar of {} (glide ratio {:.1f} straight ahead{}), can reach {} on the landing course, at least {} m above "
      "the terrain on all the way and at least {} m above the runway on arrival. Terrain is the highest ground of each cell of {:.1f} m, runways are "
      "as "
      "listed in the plan; {}.",
      plan.tour.size(), speeds, air, profile, 1.0 / rates.stillStraight(), windRatio, runways, context.clearance, context.arrivalMargin,
      context.terrain.cellSize(), rollingText(context));
  certificate.statement += conditionsText(context);
  for (const Finding& finding : findings) {
    if (finding.severity == Severity::Warning) {
      certificate.warnings.push_back(finding.text);
    }
    if (finding.rule == rule::kHomeGuarantee) {
      certificate.statement += " " + finding.text;
    }
    if (finding.rule == rule::kSpiralSuspended) {
      certificate.statement += fmt::format(" Exception: {}.", finding.text);
    }
  }
  return certificate;
}

}  // namespace vp::safety
