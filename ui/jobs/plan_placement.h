#pragma once

#include "core/mission/plan.h"
#include "core/terrain/elevation_grid.h"

#include <memory>

namespace vp::jobs {

/** The plan as it lies in another local frame, for showing an out-of-date plan over terrain that was added to or changed:
 *  poses and places are moved, lengths stay. Off by the difference of the two projections, centimetres to metres; never for
 *  planning, checking or writing.
 *  @return the plan itself if its frame is `frame`; null if some point of its tour lies over unknown ground of `grid` */
std::shared_ptr<const mission::Plan> placedIn(std::shared_ptr<const mission::Plan> plan, const geo::LocalFrame& frame,
                                              const terrain::ElevationGrid& grid);

}  // namespace vp::jobs
