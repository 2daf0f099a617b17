#pragma once

#include "core/base/quantity.h"
#include "core/base/result.h"
#include "core/geo/local_frame.h"

#include <optional>
#include <vector>

namespace vp::formats {

/** A line to be flown from one end to the other. */
struct SurveyLine {
  geo::LatLon from;
  geo::LatLon to;
};

/** Parallel lines over an area, in the order and directions in which a lawn mower goes: clipped to the area, free of its
 *  holes, evenly spread, no farther apart than the spacing, the outermost half of that from the area's edge.
 *  @param ring    corners of the area, at least three, not closed; straight between them in the local frame of their middle
 *  @param course  true course of the lines; absent = along the longest side
 *  @errors OutOfRange - more than 5000 lines, a spacing that is not positive, an area of no extent   @threads pure */
Result<std::vector<SurveyLine>> surveyLines(const std::vector<geo::LatLon>& ring, const std::vector<std::vector<geo::LatLon>>& holes, Length spacing,
                                            std::optional<Angle> course);

}  // namespace vp::formats
