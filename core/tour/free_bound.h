#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/landing/altitude_floor.h"
#include "core/tour/segment.h"

#include <vector>

namespace vp::tour {

/** A lower bound [m] of the cost of every closed safe tour that visits the targets of `visits` from above, whatever its order,
 *  headings, curves and roadmap: straight distances, and the altitude floor above each target (WHY.md, 6).
 *  @errors Cancelled */
Result<double> freeLowerBound(const landing::AltitudeFloor& floor, const std::vector<VisitPose>& visits, double beta, const Job& job);

}  // namespace vp::tour
