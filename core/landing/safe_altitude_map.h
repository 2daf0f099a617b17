#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/geo/pose.h"
#include "core/landing/roadmap.h"
#include "core/landing/world.h"

#include <vector>

namespace vp::landing {

/** Lowest safe altitudes that hold for whole cells, for maps that leave the program.
 *
 *  The value of a cell for a course is an UPPER bound: from every place in the cell, on every course within `courseRange` of it, at
 *  this altitude or above, a glide reaches a landing site. The glide is: straight on while the pilot reacts, turn onto the course, then turn by 0, 90
 * or 180 degrees if that is better, then an S-curve that ends at one pose for all places of the cell, from where the roadmap's glide goes on; the
 * cell's value is what this needs at most, over the highest ground that any of these paths can touch (tst_safe_altitude_map flies them). So it lies
 * some 20 to 100 m above the answer of a query at the centre, more where cells are wide.
 *  @source lengths of S-curves: inner tangents of two circles; length and turn grow with the lateral offset, length grows and turn
 *  shrinks with the distance (the gradient of a Dubins length is the direction of its straight part) */
struct SafeAltitudeMap {
  double originX = 0.0;  ///< m, south-west corner
  double originY = 0.0;
  double cell = 0.0;  ///< m
  int columns = 0;
  int rows = 0;
  double courseRange = 0.0;              ///< rad, to each side
  std::vector<double> headings;          ///< rad, mathematical
  std::vector<std::vector<float>> need;  ///< per heading, [row * columns + column], m MSL rounded up; infinity: no glide, or unknown ground

  /** Highest over the headings; with headings no more than twice courseRange apart it holds for every course. */
  [[nodiscard]] std::vector<float> worst() const;
  /** Lowest over the headings: for the best course. */
  [[nodiscard]] std::vector<float> best() const;
};

struct MapRequest {
  geo::Box area;
  double cell = 100.0;           ///< m, at least 10
  std::vector<double> headings;  ///< rad, at least one
  double courseRange = 0.0;      ///< rad, to each side, at most a quarter turn
  int threads = 1;
};

/** @errors OutOfRange - no area, or more than 4 million values;  Cancelled   @threads pure
 *  @cost per cell and heading 1 to 4 queries of some 40 us */
Result<SafeAltitudeMap> safeAltitudeMap(const World& world, const Roadmap& roadmap, const MapRequest& request, const Job& job);

}  // namespace vp::landing
