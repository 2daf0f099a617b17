#include "ui/map/map_camera.h"

#include <algorithm>
#include <cmath>

namespace vp::map {
namespace {

/// The scale of the lattice nearest to one; `round` decides which way.
double onLattice(double metresPerPixel, double (*round)(double)) {
  const double clamped = std::clamp(metresPerPixel, MapCamera::kFinest, MapCamera::kCoarsest);
  return std::exp2(round(std::log2(clamped) * MapCamera::kStepsPerOctave) / MapCamera::kStepsPerOctave);
}

double nearest(double value) {
  return std::round(value);
}
double coarser(double value) {
  return std::ceil(value - 1e-9);
}

}  // namespace

geo::Box MapCamera::visible(double grownBy) const {
  const geo::Point southWest = toGround({-grownBy, size_.height() + grownBy});
  const geo::Point northEast = toGround({size_.width() + grownBy, -grownBy});
  return {southWest.x, southWest.y, northEast.x, northEast.y};
}

MapCamera MapCamera::zoomedAt(QPointF anchor, double factor) const {
  const geo::Point held = toGround(anchor);
  const MapCamera zoomed = withScale(metresPerPixel_ / factor);
  const geo::Point now = zoomed.toGround(anchor);
  return zoomed.centredOn({centre_.x + held.x - now.x, centre_.y + held.y - now.y});
}

MapCamera MapCamera::panned(QPointF pixels) const {
  return centredOn({centre_.x - pixels.x() * metresPerPixel_, centre_.y + pixels.y() * metresPerPixel_});
}

MapCamera MapCamera::withScale(double metresPerPixel) const {
  return {centre_, onLattice(metresPerPixel, nearest), size_};
}

MapCamera MapCamera::fittedTo(const geo::Box& box, double border) const {
  if (box.isEmpty()) {
    return *this;
  }
  const double width = std::max(1.0, size_.width() - 2.0 * border);
  const double height = std::max(1.0, size_.height() - 2.0 * border);
  const double scale = std::max((box.maxX - box.minX) / width, (box.maxY - box.minY) / height);
  return {{0.5 * (box.minX + box.maxX), 0.5 * (box.minY + box.maxY)}, onLattice(scale, coarser), size_};
}

}  // namespace vp::map
