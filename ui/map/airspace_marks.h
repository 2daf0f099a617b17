#pragma once

#include "ui/map/chart_text.h"
#include "ui/map/map_camera.h"
#include "ui/map/map_scene.h"

#include <QPainter>
#include <QString>

namespace vp::map {

/** Airspaces as charts draw them: blue for what takes a clearance, red-brown for danger, restricted and prohibited, a band of the
 *  colour inside the outline; dashed control zones; thicker what the mission warns of, hatched what it forbids. */
class AirspaceMarks {
public:
  AirspaceMarks(const MapScene& scene, const MapCamera& camera) : scene_(scene), camera_(camera) {}

  void draw(QPainter& painter) const;
  void drawLabels(QPainter& painter, LabelPlacer& labels) const;

private:
  const MapScene& scene_;
  const MapCamera& camera_;
};

}  // namespace vp::map
