#pragma once

#include "core/geo/local_frame.h"
#include "core/geo/pose.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::risk {

using Ring = std::vector<geo::Point>;  ///< corners of a polygon's outline or hole, m, not closed

/** Corners in the frame, those that repeat the one before left out. */
Ring ringOf(const std::vector<geo::LatLon>& corners, const geo::LocalFrame& frame);

/** Where sides of the rings cross, their own or another's; none if they do not. Sides that only touch do not cross.  @threads pure */
std::optional<geo::Point> selfCrossing(const std::vector<Ring>& rings);

/** Latitude and longitude of a place for a message, to a decimetre. */
std::string placeText(const geo::LocalFrame& frame, geo::Point point);

}  // namespace vp::risk
