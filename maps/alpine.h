#pragma once

#include "core/base/result.h"

#include <string>

namespace vp::maps {

/** Writes a made-up alpine massif of 60 x 60 km, its airfields as OurAirports files, and two missions into a folder.
 *  @errors OutputFailed */
Result<void> writeAlpine(const std::string& folder);

}  // namespace vp::maps
