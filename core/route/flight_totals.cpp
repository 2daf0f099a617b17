#include "core/route/flight_totals.h"

#include "core/air/wind_at.h"
#include "core/aircraft/energy.h"
#include "core/flight/piece_loss.h"
#include "core/mission/glide_conditions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vp::route {
namespace {

double airspeedAt(const mission::Plan& plan, double altitude) {
  return mission::tourAirspeedAt(plan.mission, geo::HeightMsl::fromMetres(altitude));
}

void add(FlightTotals& totals, const mission::Plan& plan, const mission::DecisionPoint& from, const mission::DecisionPoint& to) {
  totals.length += from.onward.length;
  totals.seconds += secondsBetween(plan, from, to);
  totals.climbed += std::max(0.0, to.altitude - from.altitude);
}

void add(FlightTotals& totals, const mission::Plan& plan, const mission::SpiralVisit& spiral) {
  const double around = 2.0 * Angle::kPi * spiral.radius;
  const double height = spiral.top - spiral.bottom;
  totals.length += (spiral.turnsDown + spiral.turnsUp) * around;
  totals.seconds += (std::hypot(spiral.turnsDown * around, height) + std::hypot(spiral.turnsUp * around, height)) /
                    airspeedAt(plan, 0.5 * (spiral.top + spiral.bottom));
  totals.climbed += height;
}

void addEnergy(FlightTotals& totals, const mission::Plan& plan) {
  if (const aircraft::PowerSetting* power = mission::powerSettingOf(plan.mission)) {
    const aircraft::AircraftProfile& craft = plan.mission.aircraft;
    totals.energy = aircraft::energyUsed(*power, craft.mostMass_kg.value_or(craft.mass_kg), totals.seconds, totals.climbed);
  }
}

FlightTotals withoutEnergy(const mission::Plan& plan) {
  FlightTotals totals;
  for (std::size_t i = 0; i < plan.tour.size(); ++i) {
    add(totals, plan, plan.tour[i], plan.tour[(i + 1) % plan.tour.size()]);
  }
  for (const mission::SpiralVisit& spiral : plan.spirals) {
    add(totals, plan, spiral);
  }
  return totals;
}

}  // namespace

double secondsBetween(const mission::Plan& plan, const mission::DecisionPoint& from, const mission::DecisionPoint& to) {
  const double middle = 0.5 * (from.altitude + to.altitude);
  const air::Wind wind = air::middleWind(plan.mission.wind, geo::HeightMsl::fromMetres(middle));
  return flight::cruiseSeconds(airspeedAt(plan, middle), wind, from.pose, from.onward, to.altitude - from.altitude);
}

FlightTotals tourTotals(const mission::Plan& plan) {
  FlightTotals totals = withoutEnergy(plan);
  addEnergy(totals, plan);
  return totals;
}

FlightTotals flightTotals(const mission::Plan& plan) {
  FlightTotals totals = withoutEnergy(plan);
  for (const std::optional<mission::HomePath>* path : {&plan.departure, &plan.arrival}) {
    for (std::size_t i = 0; *path && i + 1 < (*path)->points.size(); ++i) {
      add(totals, plan, (*path)->points[i], (*path)->points[i + 1]);
    }
  }
  addEnergy(totals, plan);
  return totals;
}

}  // namespace vp::route
