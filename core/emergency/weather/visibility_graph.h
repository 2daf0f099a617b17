#pragma once

#include "core/emergency/weather/weather_roadmap.h"

#include <cstddef>
#include <vector>

namespace vp::emergency {

/** A corner that ways around a cell may touch. */
struct WeatherCorner {
  geo::Point place;   ///< ten metres outside, so that no way along a side is within
  geo::Point corner;  ///< of the outline
  geo::Point before;  ///< corners beside it
  geo::Point after;
  double outward = 0.0;  ///< rad: away from the cell, between both sides
  std::size_t cell = 0;
};

/** Corners of all cells that a glide from the request's state can come by on its way to a runway; corners that bend inwards touch no shortest way
 *  and are left out. */
std::vector<WeatherCorner> cornersOf(const RoadmapTask& task);

/** Whether both sides of a corner lie on the same side of a line through it. @source [4] section 2.1, "locally tangent" */
bool isLocallyTangent(const WeatherCorner& corner, double course);

/** Lines between places that cross weather, whatever its altitudes.  @threads one thread */
class Sight {
public:
  explicit Sight(const RoadmapTask& task);

  /** Whether a line crosses no cell but those that hold the request's start or a gate in range: nothing could be seen from these otherwise. */
  [[nodiscard]] bool isFree(geo::Point from, geo::Point to);
  /** Whether a line crosses one of two cells. */
  [[nodiscard]] bool crosses(geo::Point from, geo::Point to, std::size_t one, std::size_t other);

private:
  const RoadmapTask& task_;
  std::vector<bool> isIgnored_;  ///< by cell
  std::vector<risk::WeatherStretch> stretches_;
};

/** Edges of a visibility graph over vertices that follow those of bareRoadmap(): corner i is vertex 1 + goals + i.
 *  @param tangentOnly  leave out edges with an end that is not locally tangent */
std::vector<std::vector<int>> visibleEdges(const RoadmapTask& task, const std::vector<WeatherCorner>& corners, bool tangentOnly);

/** Poses at corners for roadmaps with dynamics, two for each: tangent to it on either side. Vertex of corner i: 1 + goals + 2 i and the next. */
std::vector<RoadmapVertex> tangentPoses(const std::vector<WeatherCorner>& corners);

/** The edges of a visibility graph between such poses: those of corners whose headings differ by less than a right angle, [4] footnote 9. */
std::vector<std::vector<int>> edgesWithHeadings(const std::vector<std::vector<int>>& edges, std::size_t goals,
                                                const std::vector<RoadmapVertex>& poses);

}  // namespace vp::emergency
