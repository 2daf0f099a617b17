#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/mission/plan.h"
#include "core/safety/checker.h"
#include "ui/briefing/tour_figures.h"
#include "ui/document/terrain_data.h"

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace vp::briefing {

/** A file that the plan rests on. */
struct SourceFile {
  std::string path;
  std::string sha256;   ///< of terrain as the plan names it, of airfields as they are now; empty if it cannot be read
  std::string changed;  ///< day of its last change, "2026-03-01"; empty if it is not here
};

/** A plan with everything that a briefing says about it, taken from the files themselves. */
struct BriefingSource {
  std::shared_ptr<const mission::Plan> plan;  ///< its certificate is the checker's of now, or none
  std::shared_ptr<const document::TerrainData> terrain;
  safety::SafetyReport report;
  TourFigures figures;
  std::vector<SourceFile> terrainFiles;
  std::vector<SourceFile> airfieldFiles;
};

/** Reads the terrain of a plan afresh, lets the checker judge it, and works out the figures.
 *  A plan that is not safe is no error; one that cannot even be flown as written is.
 *  @param folder  where relative paths of the plan start
 *  @errors of terrain::readTerrain; BadFile - the plan is damaged, the checker's first sentence says how; Cancelled */
Result<BriefingSource> briefingSource(mission::Plan plan, const std::string& folder, std::chrono::year_month_day date, const Job& job);

}  // namespace vp::briefing
