#pragma once

#include "core/mission/landing_site.h"

#include <string_view>

namespace vp::formats {

/** The surface that a free text means ("ASPH-G", "Grassed brown clay", "TURF/GRVL"): the first word in it that is
 *  known, and water wherever in the text it is named. Unknown if no word is.
 *  @source codes of ourairports.com/help/data-dictionary.html (FAA and Jeppesen) and the spellings in the file of
 *  May 2026 */
mission::Surface surfaceFromText(std::string_view text);

}  // namespace vp::formats
