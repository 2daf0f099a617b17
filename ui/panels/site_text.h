#pragma once

#include "core/mission/landing_site.h"
#include "ui/style/units.h"

#include <QString>

namespace vp::panels {

/** "hard", "grass", "unknown surface", translated. */
QString surfaceName(mission::Surface surface);

/** "Lands 030° T, 5 905 ft, hard, elevation 5 600 ft MSL", and what of it is approximate. */
QString runwayDetails(const mission::LandingSite& site, const style::Units& units);

/** "340 ft": height that is missing, rounded up. @param metres > 0 */
QString missingHeight(double metres, const style::Units& units);

}  // namespace vp::panels
