// Runways of the generated maps: a straight strip between two thresholds on level ground.
#pragma once

#include "core/geo/local_frame.h"
#include "maps/height_field.h"

#include <string>

namespace vp::maps {

/** A runway. `first` is the threshold where a landing towards `second` touches down. */
struct Airstrip {
  std::string ident;  ///< of the airfield
  std::string name;
  geo::Point first;  ///< m in the frame of the field
  geo::Point second;
  double width = 0.0;      ///< m
  std::string surface;     ///< as OurAirports writes it
  double elevation = 0.0;  ///< m, the same at both ends; set by levelGround

  [[nodiscard]] double length() const { return geo::distance(first, second); }
};

/** True course [deg] of a landing at `from` towards `to`. */
double landingCourse(const geo::LocalFrame& frame, geo::Point from, geo::Point to);

/** Runway number of a landing course: "01".."36". */
std::string runwayNumber(double course_deg);

/** Distance from a point to the strip's centre line [m]. */
double distanceToStrip(const Airstrip& strip, geo::Point p);

/** Makes the ground level within `flat` metres of the centre line and blends it into the terrain up to `blend`.
 *  The level is the mean of the terrain along the strip, rounded to `unit`. */
void levelGround(HeightField& field, Airstrip& strip, double flat, double blend, double unit);

}  // namespace vp::maps
