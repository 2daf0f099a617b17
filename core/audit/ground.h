#pragma once

#include "core/geo/pose.h"

#include <functional>
#include <limits>
#include <vector>

namespace vp::audit {

/// Height of ground that nothing is known of [m MSL]: higher than everything, so never safe.
inline constexpr double kUnknownGround = std::numeric_limits<double>::infinity();

/** Heights of the ground [m MSL] at places of the local frame, kUnknownGround where it is not known; as many as places.
 *  @threads for one thread alone */
using GroundLookup = std::function<void(const std::vector<geo::Point>& places, std::vector<double>& heights)>;

}  // namespace vp::audit
