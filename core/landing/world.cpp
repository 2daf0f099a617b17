#include "core/landing/world.h"

#include "core/mission/glide_conditions.h"

#include <utility>

namespace vp::landing {

World worldOf(const mission::Mission& mission, std::vector<mission::SiteInFrame> sites, terrain::TerrainPyramid terrain) {
  World world;
  world.terrain = std::move(terrain);
  world.glide = aircraft::GlideModel(mission.aircraft, mission::glideConditionsOf(mission, sites));
  world.sites = std::move(sites);
  world.clearance = mission.safety.clearance.si();
  world.arrivalMargin = mission.safety.arrivalMargin.si();
  world.reactionLength = mission.safety.reactionTime.si() * world.glide.mostGroundSpeed();
  world.reactionLoss = mission.safety.reactionLoss.si();
  world.approach = mission.approach;
  world.steepestDescent = mission.aircraft.steepestDescent;
  world.rollRate_dps = mission.aircraft.rollRate_dps;
  return world;
}

}  // namespace vp::landing
