#pragma once

#include <algorithm>
#include <cmath>

namespace vp::geo {

/** A point of the local metric frame (see LocalFrame). @param x metres east  @param y metres north */
struct Point {
  double x = 0.0;
  double y = 0.0;
  bool operator==(const Point&) const = default;
};

inline double distance(Point a, Point b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/** A place and a direction in the local metric frame.
 *  heading: mathematical angle of the track, radians from East, counter-clockwise. True course (clockwise from
 *  North) appears only in files and on screen; LocalFrame converts. */
struct Pose {
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;
  [[nodiscard]] Point point() const { return {x, y}; }
  bool operator==(const Pose&) const = default;
};

/** An axis-parallel closed box of the local metric frame, metres. Empty until something is added. */
struct Box {
  double minX = 1e300;
  double minY = 1e300;
  double maxX = -1e300;
  double maxY = -1e300;

  void add(Point p) {
    minX = std::min(minX, p.x);
    minY = std::min(minY, p.y);
    maxX = std::max(maxX, p.x);
    maxY = std::max(maxY, p.y);
  }
  [[nodiscard]] bool isEmpty() const { return minX > maxX || minY > maxY; }
  [[nodiscard]] bool contains(Point p) const { return p.x >= minX && p.x <= maxX && p.y >= minY && p.y <= maxY; }
  [[nodiscard]] Box grown(double by) const { return {minX - by, minY - by, maxX + by, maxY + by}; }
};

}  // namespace vp::geo
