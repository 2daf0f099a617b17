#include "include_rules.h"

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

namespace vp::architecture {
namespace {

using Names = std::set<std::string>;

constexpr int kLongestFile = 600;

/// Who may include whom among the folders of core; what a folder may include, its includers may too.
const std::map<std::string, Names>& directlyAllowed() {
  static const std::map<std::string, Names> table{
      {"base", {}},
      {"geo", {"base"}},
      {"terrain", {"geo"}},
      {"air", {"geo"}},
      {"aircraft", {"air"}},
      {"flight", {"geo", "aircraft"}},
      {"mission", {"geo", "aircraft", "flight"}},
      {"safety", {"aircraft", "terrain", "mission"}},
      {"audit", {"mission"}},
      {"landing", {"flight", "terrain", "mission"}},
      {"risk", {"terrain", "mission"}},
      {"emergency", {"landing", "risk", "safety"}},
      {"tour", {"landing", "flight"}},
      {"route", {"landing"}},
      {"formats", {"mission", "terrain"}},
      {"fetch", {"formats"}},
      {"charts", {"landing", "formats"}},
  };
  return table;
}

Names allowedFor(const std::string& folder) {
  Names result{folder};
  for (const std::string& next : directlyAllowed().at(folder)) {
    result.merge(allowedFor(next));
  }
  return result;
}

/// Third-party headers: how they begin, the areas that may use them ("core" stands for all its folders), and whether
/// headers may too.
struct Library {
  std::string name;
  std::regex header;
  Names areas;
  bool inHeaders = false;
};

const std::vector<Library>& libraries() {
  static const std::vector<Library> list{
      {"GDAL",
       std::regex("^(gdal|ogr|cpl_|vrtdataset|memdataset).*|^proj\\.h"),
       {"core/geo", "core/terrain", "core/formats", "core/fetch", "core/audit", "maps"}},
      {"nlohmann-json", std::regex("^nlohmann/.*"), {"core/formats", "app/cli", "maps"}},
      {"valijson", std::regex("^valijson/.*"), {"core/formats"}},
      {"GeographicLib", std::regex("^GeographicLib/.*"), {"core/geo"}},
      {"CLI11", std::regex("^CLI/.*"), {"app/cli"}},
      {"OpenSSL", std::regex("^openssl/.*"), {"core/terrain", "core/formats"}},
      {"zlib", std::regex("^zlib\\.h"), {"core/formats", "core/tour"}},
      {"pugixml", std::regex("^pugixml\\.hpp"), {"core/formats"}, true},  // in headers inside core/formats/targets only
      {"md4c", std::regex("^md4c(-html)?\\.h"), {"ui/help"}},
      {"OMPL", std::regex("^ompl/.*"), {"core/landing", "core/emergency"}},
      {"NLopt", std::regex("^nlopt.*"), {"core/emergency"}},
      {"oneTBB", std::regex("^(tbb|oneapi)/.*"), {"core/landing", "core/tour"}},
      {"Boost", std::regex("^boost/.*"), {"core/landing", "core/risk", "core/tour"}},
      {"fmt", std::regex("^(fmt|spdlog)/.*"), {"core", "ui", "app", "maps"}},
      {"OpenSceneGraph", std::regex("^(osg[A-Za-z]*|OpenThreads)/.*"), {"ui/scene3d"}},
      {"Qt", std::regex("^(Qt[A-Za-z]*/|Q[A-Z]|qt).*|^Qt$"), {"ui", "app"}, true},
      {"EGL", std::regex("^(EGL|GL|GLES[23]?)/.*"), {"ui/scene3d"}},
      {"Eigen", std::regex("^Eigen/.*"), {"core"}, true},
      {"tl::expected", std::regex("^tl/expected\\.hpp"), {"core/base"}, true},
      {"POSIX",
       std::regex("^(unistd|fcntl|signal|poll|spawn|dlfcn|pthread)\\.h|^sys/.*"),
       {"core/terrain", "core/formats", "core/fetch", "core/tour", "app"}},
  };
  return list;
}

/// "core/geo" of "core/geo/pose.h", "maps" of "maps/erosion.h", "ui/map" of "ui/map/tools/drag.h".
std::string areaOf(const std::string& path) {
  const std::size_t first = path.find('/');
  const std::string top = path.substr(0, first);
  if (top == "maps" || first == std::string::npos) {
    return top;
  }
  const std::size_t second = path.find('/', first + 1);
  return second == std::string::npos ? top : path.substr(0, second);
}

std::string topOf(const std::string& path) {
  return path.substr(0, path.find('/'));
}

bool isHeader(const std::string& path) {
  return path.ends_with(".h");
}

struct Include {
  int line = 0;
  bool quoted = false;
  std::string target;
};

std::vector<Include> includesOf(const std::string& text) {
  static const std::regex pattern(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)re");
  std::vector<Include> result;
  std::istringstream lines(text);
  std::string line;
  std::smatch match;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (std::regex_match(line, match, pattern)) {
      result.push_back({number, match[1] == "\"", match[2]});
    }
  }
  return result;
}

/// What the second opinion may see of the other folders: values without behaviour. Neither checker nor planner, and of curves, air and aircraft
/// no formula.
const std::regex& valuesForAudit() {
  static const std::regex values(
      "^core/(base|geo)/.*|^core/mission/(mission|plan|landing_site|airspace|weather)\\.h|^core/flight/curve\\.h|^core/aircraft/aircraft_profile\\.h"
      "|^core/air/(wind|wind_layer|atmosphere)\\.h");
  return values;
}

/// Empty if a file of `from` may include the project's header `target`, else the reason.
std::string projectRule(const std::string& from, const std::string& target) {
  const std::string fromArea = areaOf(from);
  const std::string toArea = areaOf(target);
  const std::string fromTop = topOf(from);
  const std::string toTop = topOf(target);
  if (fromTop == "app") {
    return toTop == "core" || toTop == "ui" || fromArea == toArea ? "" : fromArea + " may include core, ui and itself only";
  }
  if (fromTop == "ui") {
    return toTop == "core" || toTop == "ui" ? "" : "ui may include core and ui only";
  }
  if (fromTop == "maps") {
    return toTop == "maps" || toArea == "core/base" || toArea == "core/geo" ? "" : "maps may include core/base, core/geo and itself only";
  }
  const std::string folder = fromArea.substr(fromArea.find('/') + 1);
  if (!directlyAllowed().contains(folder)) {
    return "folder " + fromArea + " is not in the table of include rules";
  }
  if (toTop != "core" || !allowedFor(folder).contains(toArea.substr(toArea.find('/') + 1))) {
    return fromArea + " may not include " + toArea;
  }
  if (folder == "safety" && toArea == "core/flight" && target != "core/flight/curve.h") {
    return "the checker integrates curves itself: of core/flight it may include curve.h only";
  }
  if (folder == "safety" && target == "core/terrain/terrain_pyramid.h") {
    return "the checker uses the posts and not the pyramid";
  }
  if (folder == "audit" && toArea != "core/audit" && !std::regex_match(target, valuesForAudit())) {
    return "the second opinion shares values with planner and checker, but no formula: it may not include " + target;
  }
  return "";
}

/// Empty if a file of `from` may include the outside header `target`, else the reason.
std::string outsideRule(const std::string& from, const std::string& target) {
  for (const Library& library : libraries()) {
    if (!std::regex_match(target, library.header)) {
      continue;
    }
    if (!library.areas.contains(areaOf(from)) && !library.areas.contains(topOf(from))) {
      return areaOf(from) + " may not include headers of " + library.name;
    }
    return isHeader(from) && !library.inHeaders ? "headers of " + library.name + " may appear in .cpp files only" : "";
  }
  static const std::regex standard("^[a-z0-9_]+$");
  return std::regex_match(target, standard) ? "" : "<" + target + "> is neither of the standard library nor of a library in the rules";
}

/// The project's headers that a file includes, and those that they include; itself too.
Names reachedFrom(const std::string& path, const SourceTree& tree) {
  Names seen{path};
  std::vector<std::string> open{path};
  while (!open.empty()) {
    const auto file = tree.find(open.back());
    open.pop_back();
    if (file == tree.end()) {
      continue;
    }
    for (const Include& include : includesOf(file->second)) {
      if (include.quoted && seen.insert(include.target).second) {
        open.push_back(include.target);
      }
    }
  }
  return seen;
}

}  // namespace

std::vector<Violation> checkFile(const std::string& path, const std::string& text) {
  static const std::regex project("^(core|ui|app|maps)/.*");
  std::vector<Violation> violations;
  for (const Include& include : includesOf(text)) {
    const bool ours = std::regex_match(include.target, project);
    std::string what;
    if (ours && !include.quoted) {
      what = "own header in angle brackets";
    } else if (include.quoted && !ours && !include.target.ends_with(".moc")) {
      what = "\"" + include.target + "\" is not written from the root of the repository";
    } else if (ours) {
      what = projectRule(path, include.target);
    } else if (!include.quoted) {
      what = outsideRule(path, include.target);
    }
    if (!what.empty()) {
      violations.push_back({path, include.line, what});
    }
  }
  if (isHeader(path) && text.find("#pragma once") == std::string::npos) {
    violations.push_back({path, 0, "header without #pragma once"});
  }
  const auto lines = std::count(text.begin(), text.end(), '\n');
  if (lines > kLongestFile) {
    violations.push_back({path, 0, std::to_string(lines) + " lines, more than " + std::to_string(kLongestFile)});
  }
  return violations;
}

std::vector<Violation> checkIndependenceOfSafety(const SourceTree& tree) {
  static const std::regex planner("^core/(landing|tour|emergency|risk|flight)/.*|^core/terrain/terrain_pyramid\\.h");
  std::vector<Violation> violations;
  for (const auto& [path, text] : tree) {
    if (areaOf(path) != "core/safety") {
      continue;
    }
    for (const std::string& reached : reachedFrom(path, tree)) {
      if (reached != "core/flight/curve.h" && std::regex_match(reached, planner)) {
        violations.push_back({path, 0, "reaches " + reached + " through other headers; the checker shares no code with the planner"});
      }
    }
  }
  return violations;
}

std::vector<Violation> checkIndependenceOfAudit(const SourceTree& tree) {
  std::vector<Violation> violations;
  for (const auto& [path, text] : tree) {
    if (areaOf(path) != "core/audit") {
      continue;
    }
    for (const std::string& reached : reachedFrom(path, tree)) {
      if (areaOf(reached) != "core/audit" && !std::regex_match(reached, valuesForAudit())) {
        violations.push_back(
            {path, 0, "reaches " + reached + " through other headers; the second opinion shares no formula with planner and checker"});
      }
    }
  }
  return violations;
}

}  // namespace vp::architecture
