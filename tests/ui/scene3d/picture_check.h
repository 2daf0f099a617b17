#pragma once

// What the render tests ask of a picture.

#include "ui/scene3d/camera_state.h"
#include "ui/scene3d/scene_data.h"
#include "ui/scene3d/terrain_model.h"

#include <QColor>
#include <QImage>

#include <cmath>

namespace vp::test {

/// Red and blue well above green: the route's magenta, blended with its outline or not.
inline bool isMagenta(QColor c) {
  return c.red() > c.green() + 60 && c.blue() > c.green() + 35;
}

/// True if a pixel near a place passes.
template <typename Test>
bool isNear(const QImage& image, double x, double y, int radius, Test test) {
  const double ratio = image.devicePixelRatio();
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) {
      const QPoint p(static_cast<int>(std::lround(x * ratio)) + dx, static_cast<int>(std::lround(y * ratio)) + dy);
      if (image.rect().contains(p) && test(image.pixelColor(p))) {
        return true;
      }
    }
  }
  return false;
}

/// Part of the visible points of the tour at which the picture is magenta; negative if too few are in view.
inline double tourShown(const QImage& image, const document::PlanView& plan, const scene3d::TerrainModel& terrain, const scene3d::CameraState& camera,
                        double exaggeration) {
  int seen = 0;
  int magenta = 0;
  for (const document::TourSample& sample : plan.samples()) {
    const scene3d::Vec3 place{sample.state.pose.x, sample.state.pose.y, sample.state.altitude * exaggeration};
    const auto at = camera.project(place);
    if (!at || at->x < 4 || at->y < 4 || at->x > camera.width - 4 || at->y > camera.height - 4 || !terrain.isClear(camera.eye, place, exaggeration)) {
      continue;
    }
    ++seen;
    magenta += isNear(image, at->x, at->y, 1, isMagenta) ? 1 : 0;
  }
  return seen < 20 ? -1.0 : static_cast<double>(magenta) / seen;
}

}  // namespace vp::test
