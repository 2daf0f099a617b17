#pragma once

#include "core/formats/json_reader.h"
#include "core/formats/json_value.h"
#include "core/mission/mission.h"

#include <string>

namespace vp::formats {

inline constexpr const char* kMissionFormat = "volplane-mission";

/** Where a mission's JSON stands, which decides how its aircraft is written. */
enum class MissionPlace {
  File,   ///< *.vpm: format and version; the aircraft by reference or inline
  Plan,   ///< inside a *.vpp: no header; the aircraft in full, its reference beside it
  Draft,  ///< *.vpm that is still being worked on: as File, but it may lack terrain
};

JsonValue missionToJson(const mission::Mission& mission, MissionPlace place);
JsonValue siteToJson(const mission::LandingSite& site);
JsonValue targetToJson(const mission::Target& target);

/** Read from an object; faults go to the context. @param folder  where an aircraft file is looked for */
mission::Mission readMissionObject(const JsonValue& value, const std::string& pointer, ReadContext& context, MissionPlace place,
                                   const std::string& folder);
mission::LandingSite readSite(ObjectReader& reader);
mission::Target readTarget(ObjectReader& reader);

}  // namespace vp::formats
