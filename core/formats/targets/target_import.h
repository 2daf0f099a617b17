#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/mission/mission.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::formats {

/// Targets that are added to a mission at once; planning more takes hours.
inline constexpr std::size_t kMostImportedTargets = 5000;

/** How places and areas of a file become targets. */
struct TargetImportOptions {
  std::optional<double> heightMsl_m;          ///< of all targets, instead of what the file says
  std::optional<double> heightAboveGround_m;  ///< the same above ground; heightMsl_m goes before it
  /** Takes heights from formats whose heights usually are those of the ground or of a computed climb (.cup, GPX, .lnmpln). The
   *  heights of .plan, KML (absolute or above ground), tables and GeoJSON properties are always taken. */
  bool fileHeights = false;
  bool tracks = false;                      ///< the points of GPX and KML tracks too
  Length spacing = Length::fromSi(500.0);   ///< between survey lines
  std::optional<Angle> lineCourse;          ///< true course of survey lines; absent = along the longest side of each area
  std::size_t most = kMostImportedTargets;  ///< a file that gives more is refused
  bool tracksAlone = false;                 ///< no error if all there is are tracks that `tracks` leaves out: they can be asked for yet
};

/** Targets of a file, names unique among each other and against those that are there already. */
struct ImportedTargets {
  std::vector<mission::Target> targets;
  std::vector<std::string> notes;  ///< what was left out and why, counted, with the lines of the file; one sentence each
  int surveyLines = 0;
};

/** What a file of targets is by its content. */
enum class TargetFile { None, SeeYou, Gpx, Kml, Kmz, Table, GeoJson, QgcPlan, LittleNavmap };
TargetFile targetFileOf(const std::string& path);

/** Reads targets from a SeeYou .cup, GPX (waypoints, routes, by choice tracks), KML or KMZ, a table (csv: name, latitude,
 *  longitude, height_m or altitude_m), GeoJSON, QGroundControl .plan or Little Navmap .lnmpln; told apart by content. Places
 *  become targets at 100 m above ground unless heights are given. Areas (polygons) become survey lines, lawn-mower fashion,
 *  clipped to the area and free of its holes; the ends of the lines become targets. A place within 1 m of an earlier one is
 *  left out. @param existing  targets that are in the mission already
 *  @errors BadFile, BadFormat - unreadable, none of these, nothing in it, more places than options.most; OutOfRange - survey lines give more
 *  targets than that, or are too many, which a wider spacing helps; Cancelled
 *  @threads pure; XML is read as a whole before a stop is seen   @source FORMATS of each reader's file */
Result<ImportedTargets> importTargets(const std::string& path, const TargetImportOptions& options, const std::vector<mission::Target>& existing,
                                      const Job& job = {});

/** Fits targets to those of a mission that has changed since they were read: names that are taken get a number, a place within 1 m of another target
 *  is left out and told.   @threads pure */
ImportedTargets fitTargets(const std::vector<mission::Target>& targets, const std::vector<mission::Target>& existing);

}  // namespace vp::formats
