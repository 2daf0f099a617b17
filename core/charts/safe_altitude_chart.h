#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/geo/local_frame.h"
#include "core/geo/pose.h"
#include "core/landing/roadmap.h"
#include "core/landing/world.h"
#include "core/mission/mission.h"

#include <string>
#include <vector>

namespace vp::charts {

/** Which courses a map of lowest safe altitudes is for. */
enum class Courses {
  All,    ///< first band the worst course, then one band per course; contours of the worst
  Worst,  ///< holds whatever the course
  Best,   ///< for the best course at each place
  One,    ///< for one course
};

struct ChartRequest {
  geo::Box area;  ///< m, in the local frame
  Courses courses = Courses::All;
  double course_deg = 0.0;  ///< true course at the middle of the area, for Courses::One
  int count = 16;           ///< courses that the circle is cut into; each band holds for half a step to each side
  double cell = 0.0;        ///< m; 0: defaultCell
  double interval = 100.0;  ///< m, of contours
  int threads = 1;
};

struct ChartSummary {
  int columns = 0;
  int rows = 0;
  double cell = 0.0;        ///< m
  double lowest = 0.0;      ///< m MSL, of the first band; 0 if it has no value
  double highest = 0.0;     ///< m MSL
  double knownShare = 0.0;  ///< of the cells of the first band that have a value
  std::size_t bands = 0;
  std::size_t contours = 0;
  std::string air = {};  ///< that the values hold in, after the word "in"
};

/** 50 m, or as much more as keeps the longer side of an area below 250 cells. */
double defaultCell(const geo::Box& area);

/** Whether a file of this name can be written: .tif, .kml or .gpkg. @errors OutOfRange */
Result<void> checkChartName(const std::string& path);

/** Writes the lowest safe altitudes of an area to a file of the kind that its name ends in. What they promise stands in README.md and in the
 *  file itself, with aircraft, clearance, courses and units.
 *  @errors OutOfRange (name, area, cells, interval), OutputFailed, Cancelled; nothing is written then   @threads pure */
Result<ChartSummary> writeSafeAltitudeChart(const landing::World& world, const landing::Roadmap& roadmap, const geo::LocalFrame& frame,
                                            const mission::Mission& mission, const ChartRequest& request, const std::string& path, const Job& job);

}  // namespace vp::charts
