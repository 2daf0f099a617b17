#include "ui/map/render_map.h"

#include "ui/map/map_renderer.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace vp::map {
namespace {

constexpr double kBorder = 0.08;        // of the shorter side, free around what is fitted
constexpr double kLeastShown = 2000.0;  // m: a single target is not zoomed in on further than this

}  // namespace

MapCamera homeCamera(const document::Situation& situation, QSizeF size) {
  geo::Box box = contentBox(situation);
  const MapCamera camera({}, 50.0, size);
  if (box.isEmpty()) {
    return camera;
  }
  const double missing = kLeastShown - std::max(box.maxX - box.minX, box.maxY - box.minY);
  box = missing > 0.0 ? box.grown(0.5 * missing) : box;
  return camera.fittedTo(box, kBorder * std::min(size.width(), size.height()));
}

QImage renderMap(const MapScene& scene, const MapCamera& camera, double devicePixelRatio) {
  const QSizeF pixels = camera.size() * devicePixelRatio;
  QImage image(static_cast<int>(std::lround(pixels.width())), static_cast<int>(std::lround(pixels.height())), QImage::Format_RGB32);
  image.setDevicePixelRatio(devicePixelRatio);
  QPainter painter(&image);
  MapRenderer(scene).drawAll(painter, camera, devicePixelRatio);
  return image;
}

QImage renderMap(const MapScene& scene, QSize size, double devicePixelRatio) {
  return renderMap(scene, homeCamera(scene.situation, size), devicePixelRatio);
}

}  // namespace vp::map
