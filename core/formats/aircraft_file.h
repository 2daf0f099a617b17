#pragma once

#include "core/aircraft/aircraft_profile.h"
#include "core/base/result.h"

#include <string>
#include <vector>

namespace vp::formats {

/** The bundled profile of missions that nobody chose an aircraft for: one with the glide of the handbook, that is, the
 *  propeller windmilling, because the better glide of the others promises more than a pilot may have. */
inline constexpr const char* kDefaultAircraft = "cessna172-handbook";

/** Reads an aircraft profile: JSON, format "volplane-aircraft", version 1 (resources/schema/aircraft.schema.json).
 *  Units are in the field names (kg, m2, mps, deg, m). The id is the file name without ending.
 *  @errors BadFile, BadFormat, OutOfRange, NewerVersion; each names file, line, column and field */
Result<aircraft::AircraftProfile> readAircraft(const std::string& path);

/** The same from text. @param file  name for errors and, without ending, the id */
Result<aircraft::AircraftProfile> parseAircraft(const std::string& text, const std::string& file);

/** A profile as the text of a file, so that parseAircraft gives it back exactly (the id comes from the file name).
 *  @pre every number is finite */
std::string aircraftToText(const aircraft::AircraftProfile& profile);

/** Writes that text; the file appears whole or not at all. @errors OutputFailed */
Result<void> writeAircraft(const aircraft::AircraftProfile& profile, const std::string& path);

/** A profile by what a mission calls it: the name of a bundled one ("cessna172-elasp") or, with a folder separator or
 *  the ending .json, a file relative to `baseFolder`.
 *  @errors as readAircraft; BadFile lists the bundled names if there is none of that name */
Result<aircraft::AircraftProfile> findAircraft(const std::string& nameOrPath, const std::string& baseFolder);

/** Names of the bundled profiles, sorted. */
std::vector<std::string> bundledAircraft();

/** Where bundled files are looked for, in this order: the environment variable VOLPLANE_RESOURCES, ../share/volplane
 *  beside the program, the source tree that the program was built from (not where it was built for a package). Folders
 *  need not exist. */
std::vector<std::string> resourceFolders();

}  // namespace vp::formats
