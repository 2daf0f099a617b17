#pragma once

#include "core/safety/witness_check.h"

namespace vp::safety {

/** examineGlide where what a metre costs depends on the altitude: WHY.md section 12. */
GlideExamination examineLayered(const GlideQuery& query, const SplitGlide& pieces, GlideRates& rates, CellWalk& walk, const Job& job);

}  // namespace vp::safety
