// What a pilot is told about the conditions that a guarantee holds for, beside wind, polar and terrain.

#include "core/safety/check_context.h"
#include "core/safety/limits.h"
#include "core/safety/rules.h"
#include "core/safety/standard_air.h"

#include <fmt/core.h>

#include <cmath>

namespace vp::safety {
namespace {

std::string airText(const CheckContext& context) {
  const mission::Mission& mission = context.plan.mission;
  const aircraft::AircraftProfile& profile = mission.aircraft;
  const PlanConditions& conditions = context.rates.conditions();
  std::string text;
  if (mission.atmosphere) {
    const double off = mission.atmosphere->temperatureOffset_K;
    const std::string warmth = off == 0.0 ? "as warm as" : fmt::format("{:.10g} K {} than", std::abs(off), off > 0.0 ? "warmer" : "colder");
    text += fmt::format(
        " It holds from {:.0f} to {:.0f} m MSL in air {} the standard atmosphere under a QNH of {:.10g} hPa, at the true airspeeds that the "
        "indicated best glide speed has there.",
        std::ceil(conditions.lowest), std::floor(conditions.highest), warmth, mission.atmosphere->qnh_hPa);
  }
  const double least = profile.leastMass_kg.value_or(profile.mass_kg);
  const double most = profile.mostMass_kg.value_or(profile.mass_kg);
  if (least < most) {
    text += fmt::format(" It holds for every mass from {:.10g} to {:.10g} kg, at the best glide speed of the mass.", least, most);
  }
  return text;
}

std::string dragText(const mission::Mission& mission) {
  std::string text;
  if (mission.propeller != aircraft::Propeller::AsInPolar) {
    text += fmt::format(" The propeller is taken to {} after the failure.",
                        mission.propeller == aircraft::Propeller::Windmilling ? "windmill" : "stand still");
  }
  if (mission.safety.dragFactor != 1.0) {
    text += fmt::format(" The drag is counted as {:.10g} times that of the polar.", mission.safety.dragFactor);
  }
  return text;
}

std::string climbText(const aircraft::AircraftProfile& profile) {
  if (!profile.climbRate || !profile.serviceCeiling) {
    return {};
  }
  return fmt::format(
      " Under power it climbs nowhere steeper than an aircraft can whose rate of climb falls from {:.10g} m/s at sea level to {} m/s at a "
      "density altitude of {:.10g} m.",
      profile.climbRate->si(), kClimbAtServiceCeiling, profile.serviceCeiling->metres());
}

std::string reactionText(const CheckContext& context) {
  const double seconds = context.plan.mission.safety.reactionTime.si();
  std::string text;
  if (!context.plan.mission.powerSetting.empty()) {
    text += fmt::format(" The tour is flown at a true airspeed of {:.1f} m/s ({}).", context.rates.conditions().tour.most,
                        context.plan.mission.powerSetting);
  }
  if (seconds > 0.0) {
    text +=
        fmt::format(" After the engine stops the pilot may take {:.10g} s to react: for {:.0f} m every glide follows the tour or goes straight on.",
                    seconds, std::floor(reactionLength(context)));
  }
  if (context.reactionLoss > 0.0) {
    text += fmt::format(" Until the glide is established it may lose {:.10g} m of height besides.", context.reactionLoss);
  }
  return text;
}

std::string approachText(const mission::Mission& mission) {
  const mission::ApproachSettings& approach = mission.approach;
  std::string text;
  switch (approach.kind) {
    case mission::ApproachKind::Threshold:
      break;
    case mission::ApproachKind::Straight:
      text = fmt::format(" Every glide ends in a straight final of {:.10g} m", approach.finalLength.si());
      text += approach.slope ? fmt::format(", flown at {:.10g} degrees.", approach.slope->degrees()) : ".";
      break;
    case mission::ApproachKind::Overhead:
      text = " Every glide ends in one full circle from above the touchdown point";
      text += approach.keyHeight ? fmt::format(", begun at least {:.10g} m above it.", approach.keyHeight->si()) : ".";
      break;
  }
  if (approach.kind != mission::ApproachKind::Threshold && approach.surfaceSlope) {
    text += fmt::format(
        " On that last part it may be as low above the terrain as an obstacle surface that begins {:.10g} m before the touchdown point and rises "
        "by {:.10g} %.",
        approach.surfaceStart.si(), 100.0 * *approach.surfaceSlope);
  }
  if (approach.hold) {
    text += " Before every approach there is room for a hold, down to its altitude in the plan.";
  }
  if (mission.aircraft.landingDistance) {
    text += fmt::format(
        " Runways of known length are long enough for an aircraft that lands in {:.10g} m at sea level, with the day's air, wind, slope and "
        "surface.",
        mission.aircraft.landingDistance->si());
  }
  return text;
}

/// From a tour that is slower than the glide the aircraft has to speed up first, which costs its kinetic energy.
void warnAboutSlowTour(CheckContext& context) {
  const PlanConditions& conditions = context.rates.conditions();
  if (context.plan.mission.powerSetting.empty() || !(conditions.tour.least < conditions.glide.most)) {
    return;
  }
  const double needed = (conditions.glide.most * conditions.glide.most - conditions.tour.least * conditions.tour.least) / (2.0 * kGravity.si());
  if (needed > context.reactionLoss) {
    context.findings.warning(
        rule::kSettingsReaction,
        fmt::format("the tour is flown at {:.1f} m/s and glides at up to {:.1f} m/s: speeding up costs {:.0f} m of height, but only "
                    "{:.0f} m are counted as lost after an engine failure",
                    conditions.tour.least, conditions.glide.most, std::ceil(needed), std::floor(context.reactionLoss)));
  }
}

/// A cold column of air is shorter than the standard one that altimeters count with.
void warnAboutAltimeter(CheckContext& context) {
  const std::optional<air::Atmosphere>& air = context.plan.mission.atmosphere;
  if (!air || !(air->temperatureOffset_K < 0.0)) {
    return;
  }
  const PlanConditions& conditions = context.rates.conditions();
  const double highest = altimeterShowsTooMuch(*air, conditions.highest, conditions.lowest);
  const double closest = altimeterShowsTooMuch(*air, context.closest.altitude, conditions.lowest);
  context.findings.warning(
      rule::kAirAltimeter,
      fmt::format(
          "in air {:.10g} K colder than the standard atmosphere an altimeter set at the lowest landing site shows about {:.0f} m too much at the "
          "highest point ({:.0f} m MSL), and about {:.0f} m where the flight is closest to its clearance ({:.0f} m MSL): add as much, or fly by "
          "satellite "
          "height",
          -air->temperatureOffset_K, std::ceil(highest), conditions.highest, std::ceil(std::max(0.0, closest)), context.closest.altitude));
}

void warnAboutPropeller(CheckContext& context) {
  const aircraft::AircraftProfile& profile = context.plan.mission.aircraft;
  const bool windmills = context.plan.mission.propeller == aircraft::Propeller::Windmilling && !profile.windmillingDrag;
  const bool stands = context.plan.mission.propeller == aircraft::Propeller::Stopped && !profile.stoppedDrag;
  if (windmills || stands) {
    context.findings.warning(rule::kAircraftPropeller, fmt::format("{} gives no drag for a {} propeller, so its polar is used as it is", profile.name,
                                                                   windmills ? "windmilling" : "stopped"));
  }
}

void warnAboutGreatestSpeed(CheckContext& context) {
  const std::optional<Speed>& limit = context.plan.mission.aircraft.maxSpeed;
  const PlanConditions& conditions = context.rates.conditions();
  const double fastest = std::max(conditions.glide.most, conditions.tour.most);
  if (limit && fastest > limit->si()) {
    context.findings.warning(
        rule::kAircraftSpeed,
        fmt::format("the plan counts with a true airspeed of {:.1f} m/s at {:.0f} m MSL, above the aircraft's limit of {:.1f} m/s", fastest,
                    conditions.highest, limit->si()));
  }
}

}  // namespace

std::string conditionsText(const CheckContext& context) {
  const mission::Mission& mission = context.plan.mission;
  return airText(context) + dragText(mission) + climbText(mission.aircraft) + reactionText(context) + approachText(mission);
}

void addConditionWarnings(CheckContext& context) {
  warnAboutSlowTour(context);
  warnAboutAltimeter(context);
  warnAboutPropeller(context);
  warnAboutGreatestSpeed(context);
}

}  // namespace vp::safety
