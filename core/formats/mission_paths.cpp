#include "core/formats/mission_paths.h"

#include <filesystem>
#include <functional>

namespace vp::formats {
namespace {

namespace fs = std::filesystem;
using Change = std::function<std::string(const std::string&)>;

Change toAbsolute(const std::string& folder) {
  return [base = fs::absolute(folder)](const std::string& path) {
    return path.empty() ? path : (fs::path(path).is_absolute() ? fs::path(path) : base / path).lexically_normal().string();
  };
}

/// Whether two absolute paths have more in common than the root. A path that climbs up to there ("../../../usr/share/...") holds in no
/// other folder than the one it was written for, as files outside are not moved along.
bool shareFolder(const fs::path& one, const fs::path& other) {
  const auto first = [](const fs::path& path) {
    const fs::path rest = path.relative_path();
    return rest.empty() ? fs::path() : *rest.begin();
  };
  return one.root_path() == other.root_path() && first(one) == first(other);
}

/// By the names alone and not by where symbolic links lead, because toAbsolute goes back by the names alone.
Change toRelative(const std::string& folder) {
  return [base = fs::absolute(folder).lexically_normal()](const std::string& path) {
    if (path.empty()) {
      return path;
    }
    const fs::path whole = fs::absolute(path).lexically_normal();
    if (!shareFolder(whole, base)) {
      return whole.string();
    }
    const std::string relative = whole.lexically_proximate(base).string();
    return (base / relative).lexically_normal() == whole ? relative : whole.string();
  };
}

bool isFile(const std::string& aircraft) {
  return aircraft.find('/') != std::string::npos || aircraft.ends_with(".json");
}

void changePaths(mission::Mission& mission, const Change& change) {
  for (std::string& file : mission.terrain) {
    file = change(file);
  }
  for (mission::AirfieldSource& source : mission.airfields) {
    source.airports = change(source.airports);
    source.runways = change(source.runways);
  }
  for (std::string& file : mission.airspace.files) {
    file = change(file);
  }
  for (std::string& file : mission.populationFiles) {
    file = change(file);
  }
  if (isFile(mission.aircraftReference)) {
    mission.aircraftReference = change(mission.aircraftReference);
  }
}

void changePaths(mission::Plan& plan, const Change& change) {
  changePaths(plan.mission, change);
  for (mission::TerrainReference& reference : plan.terrain) {
    reference.path = change(reference.path);
  }
}

}  // namespace

void makePathsAbsolute(mission::Mission& mission, const std::string& folder) {
  changePaths(mission, toAbsolute(folder));
}

void makePathsRelative(mission::Mission& mission, const std::string& folder) {
  changePaths(mission, toRelative(folder));
}

void makePathsAbsolute(mission::Plan& plan, const std::string& folder) {
  changePaths(plan, toAbsolute(folder));
}

void makePathsRelative(mission::Plan& plan, const std::string& folder) {
  changePaths(plan, toRelative(folder));
}

}  // namespace vp::formats
