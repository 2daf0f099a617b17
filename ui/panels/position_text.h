#pragma once

#include "core/geo/local_frame.h"

#include <QString>

#include <optional>

namespace vp::panels {

/** Reads a position as people write it: "46.6003, 9.9017", "46°36.02′ N 009°54.10′ E", "N46 36 01 E9 54 06", "46.6N 9.9E".
 *  Degrees, degrees and minutes, or degrees, minutes and seconds; letters before or after; latitude first unless the
 *  letters say otherwise. @return nothing if it is no position on Earth */
std::optional<geo::LatLon> parsePosition(const QString& text);

}  // namespace vp::panels
