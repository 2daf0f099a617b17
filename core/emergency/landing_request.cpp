#include "core/emergency/landing_request.h"

#include "core/mission/glide_conditions.h"

#include <fmt/format.h>

#include <cmath>

namespace vp::emergency {

std::optional<std::string> requestFault(const LandingRequest& request) {
  const landing::World& world = *request.world;
  if (!(request.deadline > 0.0) || !std::isfinite(request.deadline)) {
    return "A deadline of zero leaves no time for any answer: give at least a few milliseconds, for example 1s.";
  }
  if (!std::isfinite(request.pose.x) || !std::isfinite(request.pose.y) || !std::isfinite(request.pose.heading) || !std::isfinite(request.altitude)) {
    return "The aircraft's position, course and altitude must be finite numbers: give longitude, latitude, altitude and true course.";
  }
  if (!world.terrain.grid().extent().contains(request.pose.point())) {
    return "The aircraft is outside the terrain of the mission, where nothing is known about the ground: give a place on the map, or add terrain "
           "that "
           "covers this one.";
  }
  const double ground = world.terrain.grid().upperAt(request.pose.point());
  if (!std::isfinite(ground)) {
    return "The terrain has no data at the aircraft's place, so nothing is known about the ground: give another place, or terrain without this gap.";
  }
  if (request.altitude < ground) {
    return fmt::format("The aircraft would be below the ground: {:.0f} m MSL where the terrain is up to {:.0f} m MSL; give an altitude above that.",
                       request.altitude, std::ceil(ground));
  }
  if (const std::optional<geo::HeightMsl> ceiling = mission::ceilingOf(*request.mission); ceiling && request.altitude > ceiling->metres()) {
    return fmt::format(
        "The aircraft is at {:.0f} m MSL, above the ceiling of {:.0f} m MSL up to which the mission's figures hold: give a lower altitude, or raise "
        "the "
        "ceiling of mission and aircraft.",
        request.altitude, ceiling->metres());
  }
  if (world.sites.empty()) {
    return "The mission has no landing site at all: add airfields to it.";
  }
  return std::nullopt;
}

}  // namespace vp::emergency
