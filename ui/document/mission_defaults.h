#pragma once

#include "core/mission/mission.h"
#include "core/mission/settings_check.h"

namespace vp::document {

/** Safety of new missions: as in the source papers, but for the time in which a pilot reacts. */
inline mission::SafetySettings usualSafety() {
  mission::SafetySettings safety;
  safety.reactionTime = Duration::fromSi(mission::kUsualReaction);
  return safety;
}

/** What a new mission starts with. Missions that are open or saved keep their own values. */
struct MissionDefaults {
  mission::SafetySettings safety = usualSafety();
  mission::PlannerSettings planner;
  bool operator==(const MissionDefaults&) const = default;
};

}  // namespace vp::document
