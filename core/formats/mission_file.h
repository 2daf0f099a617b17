#pragma once

#include "core/base/result.h"
#include "core/mission/mission.h"

#include <string>

namespace vp::formats {

/** A mission together with the folder that its relative paths start from. */
struct MissionFile {
  mission::Mission mission;
  std::string folder;
};

/** Reads a *.vpm mission: JSON, format "volplane-mission", version 1 (resources/schema/mission.schema.json).
 *  The aircraft is resolved: a bundled name, a file relative to the mission, or given inline. Terrain and airfields are
 *  named only, not opened. Nothing is guessed: an unknown field, a wrong type or a value out of range is an error that
 *  names file, line, column and member path, and for a misspelt field the nearest known one.
 *  @errors BadFile - cannot be read, or the aircraft is not found;  BadFormat - not JSON, not a mission, wrong or
 *  unknown field;  OutOfRange - a value outside what it may be;  NewerVersion - written by a newer Volplane
 *  @threads pure but for the file system */
Result<mission::Mission> readMission(const std::string& path);

/** The same from text. @param file  name for errors, and where relative aircraft files are looked for */
Result<mission::Mission> parseMission(const std::string& text, const std::string& file);

/** The same for editors: a mission that is still being worked on may lack terrain. */
Result<mission::Mission> readDraft(const std::string& path);
Result<mission::Mission> parseDraft(const std::string& text, const std::string& file);

/** A mission as the text of a file. */
std::string missionToText(const mission::Mission& mission);

/** Writes a mission so that readMission gives it back exactly; the file appears whole or not at all.
 *  The aircraft is written as the reference if there is one and inline if not.  @errors OutputFailed */
Result<void> writeMission(const mission::Mission& mission, const std::string& path);

/** `relative` as seen from a mission file (or its folder); absolute paths stay as they are. Nothing is opened. */
std::string resolvePath(const std::string& missionFileOrFolder, const std::string& relative);

}  // namespace vp::formats
