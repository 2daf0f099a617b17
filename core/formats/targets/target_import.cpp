#include "core/formats/targets/target_import.h"

#include "core/formats/limits.h"
#include "core/formats/targets/found_targets.h"
#include "core/formats/targets/survey_lines.h"
#include "core/formats/targets/zip_member.h"
#include "core/formats/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace vp::formats {
namespace {

constexpr double kUsualHeight = 100.0;  // m above ground, as a target has it that is clicked on the map
constexpr double kSamePlace = 1.0;      // m, as the planner refuses it
constexpr std::size_t kLongestName = 60;

/// A name for people: no control characters, no blanks around it, not too long, whole characters.
std::string tidyName(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
  if (!isUtf8(name)) {
    name = fromWindows1252(name);
  }
  const std::size_t begin = std::min(name.find_first_not_of(' '), name.size());
  name = name.substr(begin, name.find_last_not_of(' ') + 1 - begin);
  if (name.size() > kLongestName) {
    std::size_t end = kLongestName;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0u) == 0x80u) {
      --end;
    }
    name.resize(end);
  }
  return name;
}

class TargetMaker {
public:
  TargetMaker(const TargetImportOptions& options, const std::vector<mission::Target>& existing, FoundTargets& found)
      : options_(&options), found_(&found) {
    for (const mission::Target& target : existing) {
      names_.insert(target.name);
      remember(target.position);
    }
  }

  void add(const FoundTargets::Place& place) {
    mission::Target target{place.name, place.position, kUsualHeight, mission::HeightReference::AboveGround};
    setHeight(place, target);
    fit(std::move(target));
  }

  /// With its height as it is; its name is made unique.
  void fit(mission::Target target) {
    const std::string given = std::exchange(target.name, uniqueName(target.name));
    if (isTaken(target.position)) {
      found_->leftOut.add("at the place of another target", given.empty() ? target.name : tidyName(given));
      return;
    }
    if (!(target.height_m >= -500.0 && target.height_m <= 20000.0)) {
      found_->leftOut.add("height out of range", target.name);
      return;
    }
    names_.insert(target.name);
    remember(target.position);
    targets.push_back(std::move(target));
  }

  std::vector<mission::Target> targets;

private:
  using Cell = std::pair<int, int>;

  /// Places by cells of a thousandth of a degree, so that duplicates among thousands are found at once.
  static Cell cellOf(geo::LatLon place) {
    return {static_cast<int>(std::floor(place.latitude_deg * 1000.0)), static_cast<int>(std::floor(place.longitude_deg * 1000.0))};
  }

  void remember(geo::LatLon place) {
    const Cell cell = cellOf(place);
    for (int i = -1; i <= 1; ++i) {
      for (int k = -1; k <= 1; ++k) {
        places_[{cell.first + i, cell.second + k}].push_back(place);
      }
    }
  }

  [[nodiscard]] bool isTaken(geo::LatLon place) const {
    const auto near = places_.find(cellOf(place));
    return near != places_.end() && std::any_of(near->second.begin(), near->second.end(),
                                                [&](const geo::LatLon& other) { return geo::geodesicDistance(other, place).si() < kSamePlace; });
  }

  void setHeight(const FoundTargets::Place& place, mission::Target& target) const {
    const bool fromFile = found_->heightsAreFlown || options_->fileHeights;
    if (options_->heightMsl_m) {
      target.height_m = *options_->heightMsl_m;
      target.reference = mission::HeightReference::Msl;
    } else if (options_->heightAboveGround_m) {
      target.height_m = *options_->heightAboveGround_m;
    } else if (fromFile && place.heightMsl_m) {
      target.height_m = *place.heightMsl_m;
      target.reference = mission::HeightReference::Msl;
    } else if (fromFile && place.heightAboveGround_m) {
      target.height_m = *place.heightAboveGround_m;
    }
  }

  std::string uniqueName(const std::string& given) {
    std::string name = tidyName(given);
    name = name.empty() ? "Target" : name;
    std::string candidate = name == "Target" ? name + " 1" : name;
    for (int& count = counts_[name]; names_.count(candidate) > 0;) {
      count = std::max(count, 1) + 1;
      candidate = fmt::format("{} {}", name, count);
    }
    return candidate;
  }

  const TargetImportOptions* options_;
  FoundTargets* found_;
  std::set<std::string> names_;
  std::map<std::string, int> counts_;
  std::map<Cell, std::vector<geo::LatLon>> places_;
};

Result<int> addSurveys(const FoundTargets& found, const TargetImportOptions& options, TargetMaker& maker, LeftOut& leftOut) {
  int lines = 0;
  std::size_t corners = 0;
  for (std::size_t i = 0; i < found.areas.size(); ++i) {
    if (found.job.stopRequested()) {
      return readingStopped();
    }
    const FoundTargets::Area& area = found.areas[i];
    const std::string name = area.name.empty() ? fmt::format("Area {}", i + 1) : tidyName(area.name);
    corners = std::accumulate(area.holes.begin(), area.holes.end(), corners + area.ring.size(),
                              [](std::size_t sum, const auto& hole) { return sum + hole.size(); });
    if (corners > kMostSurveyCorners) {
      return fail(Errc::OutOfRange, fmt::format("more than {} corners of areas; simplify them", kMostSurveyCorners), name);
    }
    if (maker.targets.size() > options.most) {
      return lines;  // more are refused anyway
    }
    const Result<std::vector<SurveyLine>> survey = surveyLines(area.ring, area.holes, options.spacing, options.lineCourse);
    if (!survey && survey.error().what == "the area has no extent") {
      leftOut.add("area without extent", name);
      continue;
    }
    if (!survey) {
      return fail(survey.error().code, survey.error().what, name);
    }
    for (std::size_t k = 0; k < survey->size(); ++k) {
      maker.add({fmt::format("{} L{} a", name, k + 1), (*survey)[k].from, {}, {}});
      maker.add({fmt::format("{} L{} b", name, k + 1), (*survey)[k].to, {}, {}});
    }
    lines += static_cast<int>(survey->size());
  }
  return lines;
}

std::string_view startOf(std::string_view text) {
  text.remove_prefix(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

TargetFile kindOfText(std::string_view start) {
  if (start.starts_with("PK\x03\x04")) {
    return TargetFile::Kmz;
  }
  const std::string_view text = startOf(start);
  if (text.starts_with('<')) {
    return text.find("<LittleNavmap") != std::string_view::npos ? TargetFile::LittleNavmap
           : text.find("<gpx") != std::string_view::npos        ? TargetFile::Gpx
           : text.find("<kml") != std::string_view::npos || text.find(":kml") != std::string_view::npos ||
                   text.find("<Placemark") != std::string_view::npos
               ? TargetFile::Kml
               : TargetFile::None;
  }
  if (text.starts_with('{')) {
    if (text.find("\"fileType\"") != std::string_view::npos && text.find("\"Plan\"") != std::string_view::npos) {
      return TargetFile::QgcPlan;
    }
    return text.find("\"type\"") != std::string_view::npos &&
                   (text.find("eature") != std::string_view::npos || text.find("\"coordinates\"") != std::string_view::npos)
               ? TargetFile::GeoJson
               : TargetFile::None;
  }
  const std::string_view line = text.substr(0, std::min(text.find_first_of("\r\n"), text.size()));
  if (!isTargetTableHeader(line)) {
    return TargetFile::None;
  }
  std::string lower(line);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower.find("style") != std::string::npos && lower.find("elev") != std::string::npos ? TargetFile::SeeYou : TargetFile::Table;
}

Result<void> find(const std::string& path, TargetFile kind, const TargetImportOptions& options, FoundTargets& found) {
  if (kind == TargetFile::GeoJson) {
    return findGeoJsonTargets(path, found);
  }
  const bool isXml = kind == TargetFile::Gpx || kind == TargetFile::Kml || kind == TargetFile::Kmz || kind == TargetFile::LittleNavmap;
  Result<std::string> text = isXml ? readFile(path) : readText(path);  // XML says its encoding itself
  if (text && kind == TargetFile::Kmz) {
    text = zipMember(path, *text, ".kml");
  }
  if (!text) {
    return forward(text);
  }
  switch (kind) {
    case TargetFile::SeeYou:
      return findCupTargets(path, *text, found);
    case TargetFile::Gpx:
      return findGpxTargets(path, *text, options.tracks, found);
    case TargetFile::Kml:
    case TargetFile::Kmz:
      return findKmlTargets(path, *text, options.tracks, found);
    case TargetFile::QgcPlan:
      return findQgcTargets(path, *text, found);
    case TargetFile::LittleNavmap:
      return findLnmTargets(path, *text, found);
    default:
      return findTableTargets(path, *text, found);
  }
}

}  // namespace

TargetFile targetFileOf(const std::string& path) {
  constexpr std::size_t kEnough = 65536;
  const Result<std::string> start = readStart(path, kEnough);
  return start ? kindOfText(*start) : TargetFile::None;
}

ImportedTargets fitTargets(const std::vector<mission::Target>& targets, const std::vector<mission::Target>& existing) {
  FoundTargets found;
  const TargetImportOptions options;
  TargetMaker maker(options, existing, found);
  for (const mission::Target& target : targets) {
    maker.fit(target);
  }
  return {std::move(maker.targets), found.leftOut.sentences(), 0};
}

Result<ImportedTargets> importTargets(const std::string& path, const TargetImportOptions& options, const std::vector<mission::Target>& existing,
                                      const Job& job) {
  if (const Result<std::string> start = readStart(path, 1); !start) {
    return forward(readFile(path));
  }
  const TargetFile kind = targetFileOf(path);
  if (kind == TargetFile::None) {
    return fail(Errc::BadFormat,
                "this is no file of targets that the program knows: SeeYou .cup, GPX, KML or KMZ, a table with the columns latitude and longitude, "
                "GeoJSON, QGroundControl .plan, Little Navmap .lnmpln",
                path);
  }
  FoundTargets found;
  found.job = job;
  if (const Result<void> read = find(path, kind, options, found); !read) {
    return forward(read);
  }
  if (found.places.size() > options.most) {
    return fail(Errc::BadFile,
                fmt::format("holds {} places; at most {} targets are imported at once, so take a part of them", found.places.size(), options.most),
                path);
  }
  TargetMaker maker(options, existing, found);
  for (const FoundTargets::Place& place : found.places) {
    if (job.stopRequested()) {
      return readingStopped();
    }
    maker.add(place);
  }
  const Result<int> lines = addSurveys(found, options, maker, found.leftOut);
  if (!lines && lines.error().code == Errc::Cancelled) {
    return forward(lines);
  }
  if (!lines) {
    return fail(lines.error().code, lines.error().what, path + ", " + lines.error().where);
  }
  if (maker.targets.size() > options.most) {
    return fail(
        Errc::OutOfRange,
        fmt::format("gives {} targets or more; at most {} are imported at once, so choose a wider spacing", maker.targets.size(), options.most),
        path);
  }
  ImportedTargets imported{std::move(maker.targets), found.leftOut.sentences(), *lines};
  if (*lines > 0) {
    imported.notes.push_back(fmt::format("{} survey lines; their ends are targets, which the tour visits in the order that is shortest", *lines));
  }
  if (found.trackPoints > 0) {
    imported.notes.push_back(fmt::format("{} points of tracks were not taken", found.trackPoints));
  }
  if (imported.targets.empty() && !(options.tracksAlone && found.trackPoints > 0)) {
    std::string why = "there are no places for targets in this file";
    for (const std::string& note : imported.notes) {
      why += "; " + note;
    }
    return fail(Errc::BadFormat, why, path);
  }
  return imported;
}

}  // namespace vp::formats
