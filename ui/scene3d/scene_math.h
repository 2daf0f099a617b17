#pragma once

#include "core/geo/pose.h"

#include <cmath>

namespace vp::scene3d {

/** A point or direction of scene space: metres east, north and up; up is height MSL times the vertical exaggeration. */
struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  [[nodiscard]] geo::Point ground() const { return {x, y}; }
  bool operator==(const Vec3&) const = default;
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vec3 operator*(double s, Vec3 a) {
  return {s * a.x, s * a.y, s * a.z};
}
constexpr double dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3 a) {
  return std::sqrt(dot(a, a));
}
/** @pre a is not zero */
inline Vec3 normalized(Vec3 a) {
  return (1.0 / length(a)) * a;
}

/** Horizontal and vertical extent of something in scene space. */
struct Bounds {
  Vec3 low{1e300, 1e300, 1e300};
  Vec3 high{-1e300, -1e300, -1e300};

  void add(Vec3 p) {
    low = {std::fmin(low.x, p.x), std::fmin(low.y, p.y), std::fmin(low.z, p.z)};
    high = {std::fmax(high.x, p.x), std::fmax(high.y, p.y), std::fmax(high.z, p.z)};
  }
  void join(const Bounds& other) {
    if (!other.isEmpty()) {
      add(other.low);
      add(other.high);
    }
  }
  [[nodiscard]] bool isEmpty() const { return low.x > high.x; }
  [[nodiscard]] Vec3 centre() const { return 0.5 * (low + high); }
  [[nodiscard]] double diagonal() const { return length(high - low); }
};

}  // namespace vp::scene3d
