#pragma once

#include "core/base/result.h"
#include "core/geo/local_frame.h"
#include "core/mission/plan.h"

#include <string>
#include <vector>

namespace vp::tour {

/** Index into `sites` of the site with this id. @errors OutOfRange, naming those that there are */
Result<int> findHomeSite(const std::vector<mission::SiteInFrame>& sites, const std::string& id);

/** Where a departure begins: the far end of the runway, on the takeoff course. The touchdown point if the length is unknown. */
geo::Pose departureEnd(const mission::SiteInFrame& site);

}  // namespace vp::tour
