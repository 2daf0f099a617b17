#pragma once

#include "core/geo/local_frame.h"
#include "ui/map/map_camera.h"
#include "ui/map/map_scene.h"

#include <QPainter>
#include <QPointF>
#include <QPolygonF>

#include <optional>
#include <vector>

namespace vp::map {

/** Circles of equal distance about places that the operator has marked: 1, 2, 5, 10, 20 and 50 NM or km along the geodesic, as
 *  the measuring line counts. They say nothing about gliding: what is in reach is an overlay of its own. */
class RangeRings {
public:
  /** Marks a place, or takes away the mark that has exactly this place. */
  void toggle(geo::LatLon place);
  void clear() { rings_.clear(); }
  [[nodiscard]] std::size_t count() const { return rings_.size(); }
  /** The mark whose middle is under a point of the screen; nothing if there is none. */
  [[nodiscard]] std::optional<std::size_t> markAt(const MapCamera& camera, QPointF at) const;
  [[nodiscard]] geo::LatLon placeOf(std::size_t mark) const { return rings_[mark].place; }

  /** Lays the circles out for another frame or other units; does nothing where neither has changed. */
  void layOut(const MapScene& scene);
  void draw(QPainter& painter, const MapScene& scene, const MapCamera& camera) const;

private:
  struct Circle {
    double radius = 0.0;  ///< m
    std::vector<geo::Point> outline;
    QString label;
  };
  struct Ring {
    geo::LatLon place;
    geo::Point middle;
    std::vector<Circle> circles;  ///< smallest first; empty: to be laid out
  };
  void layOut(Ring& ring) const;
  static std::optional<QPointF> labelPlace(const QPolygonF& outline, QSizeF size, const MapScene& scene, const MapCamera& camera);

  std::vector<Ring> rings_;
  std::optional<geo::LocalFrame> frame_;
  style::Units units_;
};

}  // namespace vp::map
