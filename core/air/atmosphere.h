#pragma once

namespace vp::air {

/// Air density at sea level [kg/m^3]. @source ICAO Doc 7488/3 (1993), International Standard Atmosphere
inline constexpr double kSeaLevelDensity = 1.225;

}  // namespace vp::air
