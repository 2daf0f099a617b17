#pragma once
// An oracle for landing paths in still air or one steady wind that shares no code with planners or checker: positions every few metres by
// path_check.h, the wind triangle at each, every terrain cell near it.

#include "core/emergency/landing_request.h"
#include "tests/support/path_check.h"

#include <cmath>
#include <string>

namespace vp::test {

/** What is wrong with a path to a runway; empty if nothing is. Slopes, clearance (on a straight approach with an obstacle surface that one's),
 * arrival.
 *  @pre at most one layer of wind, of one direction and speed; one mass, no atmosphere */
inline std::string descentFault(const emergency::LandingRequest& request, const mission::LandingPath& path) {
  const mission::Mission& mission = *request.mission;
  const aircraft::AircraftProfile& craft = mission.aircraft;
  const double airspeed = craft.bestGlideSpeed.si();
  const double weight = craft.mass_kg * kGravity.si();
  const double force = 0.5 * craft.airDensity_kgm3 * airspeed * airspeed * craft.wingArea_m2;
  const double speed = mission.wind.empty() ? 0.0 : mission.wind[0].wind.mostSpeed;
  const double towards = mission.wind.empty() ? 0.0 : Angle::degrees(270.0 - mission.wind[0].wind.from_deg).radians();
  const double steepest = craft.steepestDescent ? tan(*craft.steepestDescent) : 0.0;
  std::vector<flight::Piece> pieces;
  double toGo = 0.0;
  for (const mission::LandingLeg& leg : path.legs) {
    pieces.push_back(leg.piece);
    toGo += leg.piece.length;
  }
  const std::vector<FlownPoint> points = fly(path.start, pieces, 10.0);
  double start = 0.0;
  double high = path.altitude;
  std::size_t at = 0;
  for (std::size_t i = 0; i < path.legs.size(); ++i) {
    const mission::LandingLeg& leg = path.legs[i];
    const double slope = (high - leg.endAltitude) / leg.piece.length;
    double mostLoss = 0.0;
    double leastSteepest = 1e300;
    for (; at < points.size() && points[at].piece <= i; ++at) {
      const FlownPoint& point = points[at];
      const double along = speed * std::cos(towards - point.heading);
      const double across = speed * std::sin(towards - point.heading);
      const double crab = std::asin(across / airspeed);
      double load = 1.0;
      if (leg.piece.turn != flight::Turn::Straight) {
        const double ground = airspeed * std::cos(crab) + along;
        load = std::hypot(1.0, ground * ground / (kGravity.si() * leg.piece.radius * std::cos(crab)));
      }
      const double lift = load * weight / force;
      const double sine = force * (craft.zeroLiftDrag + craft.inducedDrag * lift * lift) / weight;
      mostLoss = std::max(mostLoss, airspeed * sine / (std::sqrt(airspeed * airspeed * (1.0 - sine * sine) - across * across) + along));
      leastSteepest = std::min(leastSteepest, steepest * airspeed / (airspeed + along));
      const double altitude = high - slope * (point.distance - start);
      double clearance = mission.safety.clearance.si();
      if (mission.approach.surfaceSlope && toGo - point.distance <= mission.approach.finalLength.si()) {
        clearance = std::min(clearance, std::max(0.0, *mission.approach.surfaceSlope * (toGo - point.distance - mission.approach.surfaceStart.si())));
      }
      if (altitude < request.world->terrain.grid().upperAt({point.x, point.y}) + clearance - 0.5) {  // chords of 10 m
        return "too low at " + std::to_string(point.x) + ", " + std::to_string(point.y);
      }
    }
    if (slope < mostLoss * (1.0 - 1e-9)) {
      return "leg " + std::to_string(i) + " is flatter than the glide";
    }
    if (slope > std::max(leastSteepest, mostLoss * 1.001) * (1.0 + 1e-3) + 1e-4) {  // rates of turns in wind are upper bounds by half degrees
      return "leg " + std::to_string(i) + " is too steep: " + std::to_string(slope) + " and " + std::to_string(mostLoss);
    }
    start += leg.piece.length;
    high = leg.endAltitude;
  }
  const mission::SiteInFrame& site = request.world->sites[static_cast<std::size_t>(path.site)];
  const FlownPoint& end = points.back();
  if (std::hypot(end.x - site.pose.x, end.y - site.pose.y) > 0.05 || std::abs(wrapPi(end.heading - site.pose.heading)) > 1e-3) {
    return "does not end at the site";
  }
  return high < site.site.elevation.metres() + mission.safety.arrivalMargin.si() - 1e-3 ? "arrives too low" : "";
}

}  // namespace vp::test
