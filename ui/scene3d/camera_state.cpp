#include "ui/scene3d/camera_state.h"

#include <cmath>

namespace vp::scene3d {

std::optional<ScreenPoint> CameraState::project(Vec3 p) const {
  const Vec3 offset = p - eye;
  const double depth = dot(offset, forward);
  if (depth < nearPlane) {
    return std::nullopt;
  }
  const double scale = pixelsPerMetre(depth);
  return ScreenPoint{0.5 * width + scale * dot(offset, right()), 0.5 * height - scale * dot(offset, up), depth};
}

Vec3 CameraState::rayThrough(double x, double y) const {
  const double perPixel = 2.0 * std::tan(0.5 * fieldOfView) / height;
  return normalized(forward + ((x - 0.5 * width) * perPixel) * right() + ((0.5 * height - y) * perPixel) * up);
}

double CameraState::pixelsPerMetre(double depth) const {
  return 0.5 * height / (std::tan(0.5 * fieldOfView) * std::fmax(depth, 1e-3));
}

bool CameraState::maySee(const Bounds& box) const {
  const double tanV = std::tan(0.5 * fieldOfView);
  const double tanH = tanV * aspect();
  // Inward normals of the planes through the eye; a box is outside if its most inward corner is outside one of them.
  const Vec3 side = right();
  const std::array planes{forward, tanH * forward + side, tanH * forward - side, tanV * forward + up, tanV * forward - up};
  for (const Vec3& plane : planes) {
    const Vec3 corner{plane.x > 0.0 ? box.high.x : box.low.x, plane.y > 0.0 ? box.high.y : box.low.y, plane.z > 0.0 ? box.high.z : box.low.z};
    if (dot(corner - eye, plane) < 0.0) {
      return false;
    }
  }
  return true;
}

std::array<double, 16> CameraState::viewMatrix() const {
  const Vec3 r = right();
  return {r.x, up.x, -forward.x, 0.0, r.y, up.y, -forward.y, 0.0, r.z, up.z, -forward.z, 0.0, -dot(r, eye), -dot(up, eye), dot(forward, eye), 1.0};
}

std::array<double, 16> CameraState::projectionMatrix() const {
  const double f = 1.0 / std::tan(0.5 * fieldOfView);
  const double range = nearPlane - farPlane;
  return {f / aspect(), 0.0, 0.0, 0.0, 0.0, f, 0.0, 0.0, 0.0, 0.0, (farPlane + nearPlane) / range, -1.0, 0.0, 0.0, 2.0 * farPlane * nearPlane / range,
          0.0};
}

}  // namespace vp::scene3d
