#include "core/formats/mission_file.h"

#include "core/formats/atomic_file.h"
#include "core/formats/mission_json.h"
#include "core/formats/text_file.h"

#include <filesystem>
#include <system_error>

namespace vp::formats {

namespace fs = std::filesystem;

std::string resolvePath(const std::string& missionFileOrFolder, const std::string& relative) {
  const fs::path given(relative);
  if (given.is_absolute()) {
    return relative;
  }
  std::error_code code;
  const fs::path base(missionFileOrFolder);
  const fs::path folder = fs::is_directory(base, code) ? base : base.parent_path();
  return (folder / given).lexically_normal().string();
}

Result<mission::Mission> readMission(const std::string& path) {
  const Result<std::string> text = readText(path);
  if (!text) {
    return forward(text);
  }
  return parseMission(*text, path);
}

namespace {

Result<mission::Mission> parse(const std::string& text, const std::string& file, MissionPlace place) {
  const Result<JsonValue> json = parseJson(text, file);
  if (!json) {
    return forward(json);
  }
  ReadContext context(file, text);
  mission::Mission mission = readMissionObject(*json, "", context, place, file);
  if (context.error()) {
    return tl::unexpected<Error>(*context.error());
  }
  return mission;
}

}  // namespace

Result<mission::Mission> parseMission(const std::string& text, const std::string& file) {
  return parse(text, file, MissionPlace::File);
}

Result<mission::Mission> parseDraft(const std::string& text, const std::string& file) {
  return parse(text, file, MissionPlace::Draft);
}

Result<mission::Mission> readDraft(const std::string& path) {
  const Result<std::string> text = readText(path);
  return text ? parseDraft(*text, path) : forward(text);
}

std::string missionToText(const mission::Mission& mission) {
  const JsonLayout layout{120, {"targets", "landingSites", "airfields"}};
  return writeJson(missionToJson(mission, MissionPlace::File), layout);
}

Result<void> writeMission(const mission::Mission& mission, const std::string& path) {
  return writeFileAtomically(path, missionToText(mission));
}

}  // namespace vp::formats
