#pragma once

#include "core/base/quantity.h"
#include "core/geo/local_frame.h"

#include <optional>
#include <string>
#include <string_view>

namespace vp::formats {

/** Course that a runway's name tells, degrees: its number times ten ("21L" 210), a number of three digits as it is, or a
 *  direction of the wind rose ("NE" 45). Nothing if the name is neither. */
std::optional<double> courseOfIdent(std::string_view ident);

/** A true course derived from a name, and how. */
struct NamedCourse {
  Angle course;
  std::string how;  ///< for LandingSite::approximations
};

/** True course of a runway that is known by its name alone. Numbers are magnetic, so the variation at the place is added
 *  (World Magnetic Model at its epoch: a runway's number is good to 5 degrees at best, so the day matters not and a mission
 *  gives the same sites next year). Where compasses are unreliable (horizontal field below 6000 nT, the model's caution
 *  zone) runways are numbered true, and so are the words of the wind rose taken.
 *  @source ICAO Annex 14 5.2.2.4 (nearest tenth of the magnetic azimuth); WMM2025 report for the caution zone */
std::optional<NamedCourse> courseFromName(std::string_view ident, geo::LatLon place);

/** Magnetic variation as courseFromName counts it; zero where runways are numbered true. */
Angle variationForRunways(geo::LatLon place);

/** "03R" for "21L", "SW" for "NE"; "" if the name has no opposite. */
std::string oppositeIdent(std::string_view ident);

/** "05" for a course of 45 to 54 degrees: the number of a runway that is flown on this course. */
std::string runwayNumber(double course_deg);

}  // namespace vp::formats
