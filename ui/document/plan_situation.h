#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "ui/document/situation.h"

#include <memory>
#include <string>

namespace vp::document {

/** What a finished plan shows by itself: its sites and targets as planned, over its terrain. For pictures without a window. */
Situation situationOf(std::shared_ptr<const mission::Plan> plan, std::shared_ptr<const TerrainData> terrain);

/** Reads a plan file and the terrain that it names.
 *  @errors those of the readers; BadFile if a terrain file is not the one that the plan was made with */
Result<Situation> loadPlanSituation(const std::string& path, const Job& job);

}  // namespace vp::document
