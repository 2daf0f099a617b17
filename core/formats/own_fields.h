#pragma once

#include "core/formats/csv.h"

#include <string_view>

namespace vp::formats {

/** True if a table with this header is one of own fields: a place, and something that tells a runway from a mere point. */
bool isOwnTableHeader(const CsvRecord& header);

/** True if the beginning of a GeoJSON text has properties that tell a runway from a mere point. */
bool mentionsRunways(std::string_view json);

}  // namespace vp::formats
