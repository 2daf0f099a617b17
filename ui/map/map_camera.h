#pragma once

#include "core/geo/pose.h"

#include <QPointF>
#include <QRectF>
#include <QSizeF>

namespace vp::map {

/** What part of the ground a map shows: centre, scale and size. North is up, nothing is turned. A value.
 *  Ground: metres of the local frame (geo::LocalFrame). Screen: device-independent pixels from the upper left corner.
 *  Zooming keeps to a lattice of scales (kStepsPerOctave to a factor of two), so that coming back finds the same tiles.
 *  @threads pure */
class MapCamera {
public:
  static constexpr int kStepsPerOctave = 24;
  static constexpr double kFinest = 0.05;      ///< m per pixel
  static constexpr double kCoarsest = 5000.0;  ///< m per pixel

  MapCamera() = default;
  /** @pre metresPerPixel > 0; it is kept as it is, off the lattice too */
  MapCamera(geo::Point centre, double metresPerPixel, QSizeF size) : centre_(centre), metresPerPixel_(metresPerPixel), size_(size) {}

  [[nodiscard]] geo::Point centre() const { return centre_; }
  [[nodiscard]] double metresPerPixel() const { return metresPerPixel_; }
  [[nodiscard]] QSizeF size() const { return size_; }
  [[nodiscard]] QRectF screen() const { return {QPointF(), size_}; }

  [[nodiscard]] QPointF toScreen(geo::Point ground) const {
    return {size_.width() / 2.0 + (ground.x - centre_.x) / metresPerPixel_, size_.height() / 2.0 - (ground.y - centre_.y) / metresPerPixel_};
  }
  [[nodiscard]] geo::Point toGround(QPointF screen) const {
    return {centre_.x + (screen.x() - size_.width() / 2.0) * metresPerPixel_, centre_.y - (screen.y() - size_.height() / 2.0) * metresPerPixel_};
  }
  /** Ground in view, grown by some pixels on every side. */
  [[nodiscard]] geo::Box visible(double grownBy = 0.0) const;

  /** Zoomed by about `factor` (> 1: closer, 2 shows half as much); the ground under `anchor` stays there. */
  [[nodiscard]] MapCamera zoomedAt(QPointF anchor, double factor) const;
  /** The picture moved by some pixels, as if dragged. */
  [[nodiscard]] MapCamera panned(QPointF pixels) const;
  [[nodiscard]] MapCamera centredOn(geo::Point centre) const { return {centre, metresPerPixel_, size_}; }
  /** Scale set to about `metresPerPixel`, on the lattice; same centre. */
  [[nodiscard]] MapCamera withScale(double metresPerPixel) const;
  /** The same centre and scale in another window. */
  [[nodiscard]] MapCamera resized(QSizeF size) const { return {centre_, metresPerPixel_, size}; }
  /** Shows a box as large as it gets with `border` pixels around it. An empty box changes nothing. */
  [[nodiscard]] MapCamera fittedTo(const geo::Box& box, double border) const;

  bool operator==(const MapCamera&) const = default;

private:
  geo::Point centre_;
  double metresPerPixel_ = 50.0;
  QSizeF size_{1.0, 1.0};
};

}  // namespace vp::map
