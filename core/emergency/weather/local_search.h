#pragma once

#include "core/emergency/weather/roadmap_search.h"

#include <cstddef>
#include <vector>

namespace vp::emergency {

/** Poses at points of a way on the courses that the Trajectory Planner of [4] takes: half-way between that of the leg before and that of the leg
 *  after, so that the curve around a convex obstacle stays outside it. */
std::vector<geo::Pose> posesAt(const geo::Pose& start, const std::vector<geo::Point>& points, const geo::Pose& gate);

/** Euclidean local search: straight lines between any two points of a way, then between points every two nautical miles of it as well, as long as
 * that makes it better by 1 %. No leg of the way gives more than two points that follow each other.
 *  @return the points between start and gate: the given ones where nothing better is found
 *  @source [4] section 2.2, ELS */
std::vector<geo::Point> euclideanSearch(const RoadmapTask& task, std::vector<geo::Point> points, std::size_t goal, RoadmapCount& count);

/** Local search with dynamics: Dubins curves between any two points of a way, on five courses at each.
 *  @return poses between start and gate; none: no such way can be flown
 *  @source [4] section 2.2, DLS. There all subsets of the points are tried, as a cost between places does not know the courses; with the courses
 *  as part of the states A* finds the best of more ways in polynomial time: WHY-weather.md */
std::vector<std::vector<geo::Pose>> dynamicsSearch(const RoadmapTask& task, const std::vector<geo::Point>& points, std::size_t goal,
                                                   RoadmapCount& count);

}  // namespace vp::emergency
