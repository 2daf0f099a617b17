#pragma once

#include "ui/map/map_camera.h"
#include "ui/map/map_scene.h"

#include <QPointF>

namespace vp::map {

/** What lies under a point of the map. */
struct MapObject {
  enum class Kind { Ground, Target, Site, Tour };
  Kind kind = Kind::Ground;
  int index = -1;         ///< Target: into Situation::targets; Site: into Situation::sites
  double distance = 0.0;  ///< Tour: m along it
};

inline constexpr double kReach = 11.0;  ///< px around a mark that still hit it

/** The object under a point: targets before runways before the tour. */
MapObject objectAt(const MapScene& scene, const MapCamera& camera, QPointF at);

/** Where a new target goes in the mission's list if it is put on the tour at `distance`: before the target that the tour
 *  visits next. -1 (at the end) if there is none. */
int insertionIndex(const MapScene& scene, double distance);

}  // namespace vp::map
