#pragma once

#include "core/aircraft/aircraft_profile.h"
#include "core/formats/json_reader.h"
#include "core/formats/json_value.h"

#include <string>

namespace vp::formats {

inline constexpr const char* kAircraftFormat = "volplane-aircraft";

/** The profile's fields, units in their names. */
JsonValue aircraftToJson(const aircraft::AircraftProfile& profile);

/** Reads a profile from an object. @param isFile  the object is a file of its own, so it must name format and version;
 *  inside a mission both may be missing. Faults go to the context. */
aircraft::AircraftProfile readAircraftObject(const JsonValue& value, const std::string& pointer, ReadContext& context, bool isFile);

}  // namespace vp::formats
