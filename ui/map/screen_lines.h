#pragma once

#include "core/geo/pose.h"
#include "ui/map/map_camera.h"

#include <QPolygonF>

#include <vector>

namespace vp::map {

/** A stretch of a line that is in view. */
struct ScreenLine {
  QPolygonF points;
  double start = 0.0;  ///< px along the whole line at the first point: keeps dashes where they are when a view cuts the line
};

/** The parts of a line on the ground that come near the view, thinned to what can be seen.
 *  @param border  px around the view that still counts */
std::vector<ScreenLine> screenLines(const std::vector<geo::Point>& line, const MapCamera& camera, double border);

/** Places about every `spacing` px along a line, from spacing/2 on: position and direction (radians on screen, clockwise from right). */
struct LineMark {
  QPointF at;
  double angle = 0.0;
};
std::vector<LineMark> marksAlong(const ScreenLine& line, double spacing);

}  // namespace vp::map
