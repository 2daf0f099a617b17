#pragma once

#include "core/mission/mission.h"

namespace vp::document {

/** What a new mission starts with. Missions that are open or saved keep their own values. */
struct MissionDefaults {
  mission::SafetySettings safety;
  mission::PlannerSettings planner;
  bool operator==(const MissionDefaults&) const = default;
};

}  // namespace vp::document
