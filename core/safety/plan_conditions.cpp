#include "core/safety/plan_conditions.h"

#include "core/safety/standard_air.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::safety {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Airspeed held at a mass and in a density: the indicated one that flies at the profile's angle of attack.
double airspeedAt(const aircraft::AircraftProfile& profile, double mass_kg, double density) {
  return profile.bestGlideSpeed.si() * std::sqrt(mass_kg / profile.mass_kg * (profile.airDensity_kgm3 / density));
}

Airspeeds airspeedsBetween(const aircraft::AircraftProfile& profile, double denseAir, double thinAir) {
  return {airspeedAt(profile, profile.leastMass_kg.value_or(profile.mass_kg), denseAir),
          airspeedAt(profile, profile.mostMass_kg.value_or(profile.mass_kg), thinAir)};
}

double dragOf(const aircraft::AircraftProfile& profile, aircraft::Propeller propeller) {
  if (propeller == aircraft::Propeller::Windmilling && profile.windmillingDrag) {
    return *profile.windmillingDrag;
  }
  return propeller == aircraft::Propeller::Stopped && profile.stoppedDrag ? *profile.stoppedDrag : profile.zeroLiftDrag;
}

const aircraft::PowerSetting* chosenPower(const mission::Mission& mission) {
  const auto& all = mission.aircraft.powerSettings;
  const auto chosen = std::find_if(all.begin(), all.end(), [&](const aircraft::PowerSetting& one) { return one.name == mission.powerSetting; });
  return mission.powerSetting.empty() || chosen == all.end() ? nullptr : &*chosen;
}

/// Altitudes that a plan reaches. @return the lowest that it is flown at under power
double setAltitudes(const mission::Plan& plan, PlanConditions& conditions) {
  double flown = kInfinity;
  conditions.highest = -kInfinity;
  const auto add = [&](double altitude) {
    flown = std::min(flown, altitude);
    conditions.highest = std::max(conditions.highest, altitude);
  };
  for (const mission::DecisionPoint& point : plan.tour) {
    add(point.altitude);
  }
  for (const std::optional<mission::HomePath>* path : {&plan.departure, &plan.arrival}) {
    for (std::size_t i = 0; *path && i < (*path)->points.size(); ++i) {
      add((*path)->points[i].altitude);
    }
  }
  for (const mission::SpiralVisit& spiral : plan.spirals) {
    add(spiral.top);
    add(spiral.bottom);
  }
  conditions.lowest = conditions.highest;
  for (const mission::SiteInFrame& site : plan.sites) {
    conditions.lowest = std::min(conditions.lowest, site.site.elevation.metres());
  }
  return std::min(flown, conditions.lowest);
}

}  // namespace

bool PlanConditions::isAsInProfile(const aircraft::AircraftProfile& profile) const {
  const double speed = profile.bestGlideSpeed.si();
  return glide.least == speed && glide.most == speed && dragFactor == 1.0 && zeroLiftDrag == profile.zeroLiftDrag;
}

PlanConditions conditionsOf(const aircraft::AircraftProfile& profile, const std::vector<air::WindLayer>& winds) {
  PlanConditions conditions;
  conditions.winds = winds;
  conditions.glide = airspeedsBetween(profile, profile.airDensity_kgm3, profile.airDensity_kgm3);
  conditions.tour = conditions.glide;
  conditions.zeroLiftDrag = profile.zeroLiftDrag;
  return conditions;
}

PlanConditions conditionsOf(const mission::Plan& plan) {
  const mission::Mission& mission = plan.mission;
  const aircraft::AircraftProfile& profile = mission.aircraft;
  PlanConditions conditions = conditionsOf(profile, mission.wind);
  conditions.air = mission.atmosphere;
  conditions.dragFactor = mission.safety.dragFactor;
  conditions.zeroLiftDrag = dragOf(profile, mission.propeller);
  const double flown = setAltitudes(plan, conditions);
  if (mission.atmosphere) {
    const double thinAir = densityAt(*mission.atmosphere, conditions.highest);
    conditions.glide = airspeedsBetween(profile, densityAt(*mission.atmosphere, conditions.lowest), thinAir);
    conditions.tour = airspeedsBetween(profile, densityAt(*mission.atmosphere, flown), thinAir);
  }
  if (const aircraft::PowerSetting* power = chosenPower(mission); power != nullptr) {
    conditions.tour = {power->trueAirspeed.si(), power->trueAirspeed.si()};
  }
  return conditions;
}

Airspeeds glideAirspeeds(const PlanConditions& conditions, const aircraft::AircraftProfile& profile, double bottom, double top) {
  if (!conditions.air) {
    return conditions.glide;
  }
  const auto densityThere = [&](double altitude) {
    return densityAt(*conditions.air, std::min(std::max(altitude, conditions.lowest), conditions.highest));
  };
  return airspeedsBetween(profile, densityThere(bottom), densityThere(top));
}

double tourAirspeedAt(const mission::Mission& mission, double altitude) {
  if (const aircraft::PowerSetting* power = chosenPower(mission); power != nullptr) {
    return power->trueAirspeed.si();
  }
  const aircraft::AircraftProfile& profile = mission.aircraft;
  return mission.atmosphere ? airspeedAt(profile, profile.mass_kg, densityAt(*mission.atmosphere, altitude)) : profile.bestGlideSpeed.si();
}

}  // namespace vp::safety
