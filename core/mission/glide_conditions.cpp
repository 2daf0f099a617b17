#include "core/mission/glide_conditions.h"

#include <algorithm>

namespace vp::mission {

std::optional<geo::HeightMsl> ceilingOf(const Mission& mission) {
  const std::optional<geo::HeightMsl>& own = mission.ceiling;
  const std::optional<geo::HeightMsl>& ofAircraft = mission.aircraft.ceiling;
  if (own && ofAircraft) {
    return geo::HeightMsl::fromMetres(std::min(own->metres(), ofAircraft->metres()));
  }
  if (own || ofAircraft) {
    return own ? own : ofAircraft;
  }
  return mission.atmosphere ? std::optional(geo::HeightMsl::fromMetres(kCeilingWithoutOne)) : std::nullopt;
}

double highestAltitude(const Plan& plan) {
  double highest = plan.tour.front().altitude;
  const auto raise = [&highest](const std::vector<DecisionPoint>& points) {
    for (const DecisionPoint& point : points) {
      highest = std::max(highest, point.altitude);
    }
  };
  raise(plan.tour);
  for (const std::optional<HomePath>* path : {&plan.departure, &plan.arrival}) {
    if (*path) {
      raise((*path)->points);
    }
  }
  for (const SpiralVisit& spiral : plan.spirals) {
    highest = std::max(highest, spiral.top);
  }
  return highest;
}

double tourAirspeedAt(const Mission& mission, geo::HeightMsl altitude) {
  return aircraft::tourAirspeed(mission.aircraft, glideConditionsOf(mission, {}), altitude);
}

bool sameConditions(const Mission& a, const Mission& b) {
  return a.wind == b.wind && a.atmosphere == b.atmosphere && a.approach == b.approach && a.propeller == b.propeller &&
         a.powerSetting == b.powerSetting && (!a.atmosphere || ceilingOf(a) == ceilingOf(b));
}

const aircraft::PowerSetting* powerSettingOf(const Mission& mission) {
  const std::vector<aircraft::PowerSetting>& all = mission.aircraft.powerSettings;
  const auto found = std::find_if(all.begin(), all.end(), [&](const aircraft::PowerSetting& one) { return one.name == mission.powerSetting; });
  return found != all.end() ? &*found : nullptr;
}

aircraft::GlideConditions glideConditionsOf(const Mission& mission, const std::vector<SiteInFrame>& sites) {
  aircraft::GlideConditions conditions;
  conditions.winds = mission.wind;
  conditions.dragFactor = mission.safety.dragFactor;
  conditions.propeller = mission.propeller;
  if (const aircraft::PowerSetting* power = powerSettingOf(mission)) {
    conditions.tourSpeed = power->trueAirspeed;
  }
  const std::optional<geo::HeightMsl> ceiling = ceilingOf(mission);
  if (mission.atmosphere && ceiling) {
    double lowest = ceiling->metres();
    for (const SiteInFrame& site : sites) {
      lowest = std::min(lowest, site.site.elevation.metres());
    }
    conditions.air = aircraft::AirRange{*mission.atmosphere, geo::HeightMsl::fromMetres(lowest), *ceiling};
  }
  return conditions;
}

}  // namespace vp::mission
