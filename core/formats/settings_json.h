#pragma once

#include "core/formats/json_reader.h"
#include "core/mission/mission.h"
#include "core/mission/settings_check.h"

#include <string>

namespace vp::formats {

/** Member "safety" of a mission; what is as in the source papers is left out, so that files of before stay what they are. */
JsonValue safetyToJson(const mission::SafetySettings& safety);
mission::SafetySettings readSafety(ObjectReader reader);

/** Adds the members "atmosphere", "approach", "propeller" and "powerSetting" of a mission, each only where it differs from the default. */
void writeSettings(JsonValue& json, const mission::Mission& mission);

/** The same back, bit for bit; a member that is absent leaves its default. Faults go to the reader's context. */
void readSettings(ObjectReader& reader, mission::Mission& mission);

/** Reports a setting that the mission's aircraft does not allow. Missions to be planned and plans are checked so; drafts are not: they may
 *  be opened to be put right.  @param pointer  of the mission */
void checkSettingsAgainstAircraft(const mission::Mission& mission, const std::string& pointer, ReadContext& context);

/** Where a setting stands in the JSON of a mission: "safety/dragFactor". */
std::string fieldOf(mission::SettingFault::Value value);

}  // namespace vp::formats
