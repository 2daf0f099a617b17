#pragma once

#include "ui/map/map_camera.h"
#include "ui/map/map_scene.h"

#include <QPainter>
#include <QString>

namespace vp::map {

/** "12.4 NM   043° T": along the geodesic; without terrain (no frame) the plain distance. */
QString distanceText(const MapScene& scene, geo::Point from, geo::Point to);
/** "ground 5 610 ft MSL" or "ground unknown": the upper bound that counts for planning. */
QString groundText(const MapScene& scene, geo::Point at);

/** A line between two places of the ground with end marks, readable over any terrain. */
void drawRubberBand(QPainter& painter, const MapScene& scene, const MapCamera& camera, geo::Point from, geo::Point to);

}  // namespace vp::map
