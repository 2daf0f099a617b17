#pragma once

#include "core/base/result.h"

#include <string>

namespace vp::maps {

/** Writes the mountain of Vana, Faigl, Slama 2020 (section 8) and its missions into a folder: 5 x 5 km, 0..1500 m, two two-way
 *  and one one-way runway on low ground, 5 to 100 targets 100 m above ground. @errors OutputFailed */
Result<void> writeMountain(const std::string& folder);

}  // namespace vp::maps
