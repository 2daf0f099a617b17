#pragma once

#include "core/base/result.h"
#include "core/geo/local_frame.h"

#include <string>
#include <vector>

namespace vp::cli {

/** Exactly `count` finite numbers with commas between them. @errors OutOfRange */
Result<std::vector<double>> numbersIn(const std::string& text, std::size_t count);

/** A place on earth. @param option  that it was given by, for the sentence   @errors OutOfRange */
Result<geo::LatLon> placeFrom(double latitude, double longitude, const std::string& option);

/** Metres of "30km", "20nm", "500m" or "30" (km). @errors OutOfRange */
Result<double> distanceIn(const std::string& text, const std::string& option);

/** The parts of a text between commas, spaces around them dropped. */
std::vector<std::string> partsOf(const std::string& text);

}  // namespace vp::cli
