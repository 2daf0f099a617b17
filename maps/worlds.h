#pragma once

#include "core/base/result.h"

#include <string>

namespace vp::maps {

/** Writes the small worlds of Vana, Faigl, Slama 2020 into a folder, with missions without targets: Fig. 3 (two one-way runways
 *  at different heights) and Fig. 4 (one one-way runway, flat ground without and with three blocks 450 m high).
 *  Clearance is 0 there, as the figures show the bare height lost. @errors OutputFailed */
Result<void> writeWorlds(const std::string& folder);

}  // namespace vp::maps
