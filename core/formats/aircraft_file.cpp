#include "core/formats/aircraft_file.h"

#include "core/formats/aircraft_json.h"
#include "core/formats/atomic_file.h"
#include "core/formats/mission_file.h"
#include "core/formats/text_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sys/auxv.h>
#include <system_error>

namespace vp::formats {
namespace {

namespace fs = std::filesystem;

bool isPath(const std::string& name) {
  return name.find('/') != std::string::npos || name.ends_with(".json");
}

/** The file of the running program; where /proc is not mounted (a bare chroot), by the name that it was started with. Empty if unknown. */
fs::path runningProgram() {
  std::error_code code;
  fs::path program = fs::read_symlink("/proc/self/exe", code);
  if (code) {
    const auto* started = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
    program = started == nullptr ? fs::path() : fs::canonical(started, code);
  }
  return program;
}

}  // namespace

Result<aircraft::AircraftProfile> readAircraft(const std::string& path) {
  const Result<std::string> text = readText(path);
  if (!text) {
    return forward(text);
  }
  return parseAircraft(*text, path);
}

Result<aircraft::AircraftProfile> parseAircraft(const std::string& text, const std::string& file) {
  const Result<JsonValue> json = parseJson(text, file);
  if (!json) {
    return forward(json);
  }
  ReadContext context(file, text);
  aircraft::AircraftProfile profile = readAircraftObject(*json, "", context, true);
  if (context.error()) {
    return tl::unexpected<Error>(*context.error());
  }
  profile.id = fs::path(file).stem().string();
  return profile;
}

std::string aircraftToText(const aircraft::AircraftProfile& profile) {
  JsonValue json = JsonValue::object();
  json.set("format", kAircraftFormat);
  json.set("version", 1);
  const JsonValue fields = aircraftToJson(profile);
  for (const JsonMember& member : *fields.as<JsonValue::Object>()) {
    if (member.key != "id") {
      json.set(member.key, member.value);
    }
  }
  return writeJson(json, {});
}

Result<void> writeAircraft(const aircraft::AircraftProfile& profile, const std::string& path) {
  return writeFileAtomically(path, aircraftToText(profile));
}

Result<aircraft::AircraftProfile> findAircraft(const std::string& nameOrPath, const std::string& baseFolder) {
  if (isPath(nameOrPath)) {
    return readAircraft(resolvePath(baseFolder, nameOrPath));
  }
  for (const std::string& folder : resourceFolders()) {
    const fs::path file = fs::path(folder) / "aircraft" / (nameOrPath + ".json");
    std::error_code code;
    if (!nameOrPath.empty() && fs::is_regular_file(file, code)) {
      return readAircraft(file.string());
    }
  }
  const std::vector<std::string> names = bundledAircraft();
  const std::string near = nearestWord(nameOrPath, names);
  if (names.empty()) {
    return fail(Errc::BadFile,
                fmt::format("there is no aircraft \"{}\": no bundled profiles were found in {}; set VOLPLANE_RESOURCES to their folder", nameOrPath,
                            fmt::join(resourceFolders(), ", ")));
  }
  return fail(Errc::BadFile, fmt::format("there is no bundled aircraft \"{}\"{}; choose one of {}, or name a .json file", nameOrPath,
                                         near.empty() ? "" : fmt::format(", is \"{}\" meant?", near), fmt::join(names, ", ")));
}

std::vector<std::string> bundledAircraft() {
  std::vector<std::string> names;
  for (const std::string& folder : resourceFolders()) {
    std::error_code code;
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(folder) / "aircraft", code)) {
      if (entry.path().extension() == ".json") {
        names.push_back(entry.path().stem().string());
      }
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::vector<std::string> resourceFolders() {
  std::vector<std::string> folders;
  if (const char* chosen = std::getenv("VOLPLANE_RESOURCES"); chosen != nullptr && *chosen != '\0') {
    folders.emplace_back(chosen);
  }
  const fs::path program = runningProgram();
  if (!program.empty()) {
    folders.push_back((program.parent_path().parent_path() / "share" / "volplane").string());
  }
#ifdef VOLPLANE_SOURCE_RESOURCES
  folders.emplace_back(VOLPLANE_SOURCE_RESOURCES);
#endif
  return folders;
}

}  // namespace vp::formats
