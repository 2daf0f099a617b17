#pragma once

#include "core/formats/json_reader.h"
#include "core/mission/airspace.h"

namespace vp::formats {

/** Member "airspace" of a mission. */
JsonValue airspaceSettingsToJson(const mission::AirspaceSettings& settings);
mission::AirspaceSettings readAirspaceSettings(ObjectReader reader);

/** An element of "airspaces" of a plan. */
JsonValue airspaceToJson(const mission::Airspace& airspace);
mission::Airspace readAirspace(ObjectReader reader);

}  // namespace vp::formats
