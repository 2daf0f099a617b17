#pragma once

#include "ui/scene3d/scene_math.h"

#include <array>
#include <optional>

namespace vp::scene3d {

/** A place on the picture, pixels from its upper left corner, and how far it is from the eye along the line of sight. */
struct ScreenPoint {
  double x = 0.0;
  double y = 0.0;
  double depth = 0.0;  ///< m
};

/** Where the camera is, how it looks and onto how large a picture: a value, the same for all hosts and for picking.
 *  Scene space (see scene_math.h); forward and up are unit vectors at right angles. @threads pure */
struct CameraState {
  Vec3 eye{0.0, -1000.0, 1000.0};
  Vec3 forward{0.0, 1.0, 0.0};
  Vec3 up{0.0, 0.0, 1.0};
  double fieldOfView = 0.7;  ///< rad, vertical
  double nearPlane = 1.0;    ///< m
  double farPlane = 1e6;     ///< m
  double width = 1280.0;     ///< px
  double height = 720.0;     ///< px

  bool operator==(const CameraState&) const = default;

  [[nodiscard]] Vec3 right() const { return cross(forward, up); }
  [[nodiscard]] double aspect() const { return width / height; }

  /** Where a point appears; nothing if it is behind the near plane. It may lie outside the picture. */
  [[nodiscard]] std::optional<ScreenPoint> project(Vec3 p) const;
  /** Unit direction of the line of sight through a pixel. */
  [[nodiscard]] Vec3 rayThrough(double x, double y) const;
  /** Pixels that a metre across the line of sight takes at a depth. */
  [[nodiscard]] double pixelsPerMetre(double depth) const;
  /** False only if a box is certainly outside the picture. */
  [[nodiscard]] bool maySee(const Bounds& box) const;

  /** Column-major matrices as OpenGL takes them. */
  [[nodiscard]] std::array<double, 16> viewMatrix() const;
  [[nodiscard]] std::array<double, 16> projectionMatrix() const;
};

}  // namespace vp::scene3d
