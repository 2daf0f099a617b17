#pragma once

#include "core/air/wind_layer.h"
#include "core/base/result.h"
#include "core/formats/wind_scanner.h"
#include "core/formats/wind_text.h"

namespace vp::formats {

/** Metres per second of a speed in its unit; the same for reading and writing, so that one undoes the other. */
double windSpeed(double number, WindUnits::Speed unit);

/** One wind, with the range of directions that may follow it; the scanner stands behind it then.
 *  @param needsUnit  a speed must name its unit, as in a METAR
 *  @errors as parseWind */
Result<air::WindSector> readWind(WindScanner& scanner, bool needsUnit = false);

}  // namespace vp::formats
