#include "core/tour/home_airspace.h"

#include "core/landing/required_height.h"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

namespace vp::tour {

std::optional<Error> insideAirspace(const landing::World& world, const ForbiddenAirspace* forbidden, const std::string& runway, geo::Point place,
                                    double altitude) {
  std::vector<HeightGate> gates;
  if (forbidden != nullptr) {
    forbidden->addGatesNear(world.terrain, place, 0.0, world.terrain.grid().upperAt(place), gates);
  }
  for (const HeightGate& gate : gates) {
    if (!gate.isPassed(altitude, altitude)) {
      return Error{
          Errc::NoSolution,
          fmt::format("home {} lies inside {}, which the mission forbids to the tour and so to its departure and arrival; allow the airspace "
                      "(Mission > Airspace), choose another runway, or plan without a home",
                      runway, forbidden->nameOf(gate.volume)),
          {}};
    }
  }
  return std::nullopt;
}

bool staysOutside(const landing::World& world, const ForbiddenAirspace* forbidden, const mission::HomePath& path) {
  std::vector<HeightGate> gates;
  for (std::size_t i = 0; forbidden != nullptr && i + 1 < path.points.size(); ++i) {
    const mission::DecisionPoint& point = path.points[i];
    gates.clear();
    forbidden->addGates(world.terrain, point.pose, point.onward, landing::maxTerrainAlong(world.terrain, point.pose, point.onward), gates);
    const auto [low, high] = std::minmax(point.altitude, path.points[i + 1].altitude);
    if (!std::all_of(gates.begin(), gates.end(), [low = low, high = high](const HeightGate& gate) { return gate.isPassed(low, high); })) {
      return false;
    }
  }
  return true;
}

}  // namespace vp::tour
