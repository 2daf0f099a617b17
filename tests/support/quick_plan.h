#pragma once
// A coarse plan of a bundled mission within a second, for tests of what is done with plans.

#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/formats/mission_paths.h"
#include "core/safety/checker.h"
#include "core/tour/planner.h"

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

namespace vp::test {

/** The mission of a file with absolute paths and settings that plan fast. */
inline mission::Mission quickMission(const std::string& path) {
  Result<mission::Mission> mission = formats::readMission(path);
  if (!mission) {
    throw std::runtime_error(mission.error().message());
  }
  formats::makePathsAbsolute(*mission, std::filesystem::path(path).parent_path().string());
  mission->planner.headings = 4;
  mission->planner.step = Length::fromSi(100.0);
  mission->planner.roadmapSamples = 800;
  return *mission;
}

struct QuickPlan {
  std::shared_ptr<const mission::Plan> plan;  ///< certified
  formats::LoadedMission loaded;
};

/** Plans and certifies a mission; throws if that fails. */
inline QuickPlan quickPlan(const mission::Mission& mission) {
  QuickPlan made;
  Result<formats::LoadedMission> loaded = formats::loadMission(mission, "", Job{});
  if (!loaded) {
    throw std::runtime_error(loaded.error().message());
  }
  made.loaded = *loaded;
  const tour::PlanInput input{
      loaded->mission, loaded->frame, loaded->terrain, loaded->terrainFiles, loaded->sites, loaded->targets, "test", "LKH", 1};
  Result<mission::Plan> plan = tour::planTour(input, Job{});
  if (!plan) {
    throw std::runtime_error(plan.error().message());
  }
  std::vector<std::string> checksums;
  for (const mission::TerrainReference& file : plan->terrain) {
    checksums.push_back(file.sha256);
  }
  plan->certificate = safety::check({*plan, *loaded->terrain, checksums}, Job{})->certificate;
  made.plan = std::make_shared<const mission::Plan>(std::move(*plan));
  return made;
}

}  // namespace vp::test
