#include "core/risk/ring_check.h"

#include "core/risk/box_tree.h"

#include <fmt/format.h>

#include <cstddef>

namespace vp::risk {
namespace {

/// On which side of the line through a and b: > 0 left, 0 on it as far as doubles tell.
double sideOf(geo::Point a, geo::Point b, geo::Point p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// Whether two sides truly cross: not where they only touch.
bool cross(geo::Point a, geo::Point b, geo::Point c, geo::Point d) {
  return sideOf(a, b, c) * sideOf(a, b, d) < 0.0 && sideOf(c, d, a) * sideOf(c, d, b) < 0.0;
}

geo::Point crossingOf(geo::Point a, geo::Point b, geo::Point c, geo::Point d) {
  const double t = sideOf(c, d, a) / (sideOf(c, d, a) - sideOf(c, d, b));
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

}  // namespace

std::optional<geo::Point> selfCrossing(const std::vector<Ring>& rings) {
  struct Side {
    geo::Point a;
    geo::Point b;
  };
  std::vector<Side> sides;
  std::vector<geo::Box> boxes;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      geo::Box& box = boxes.emplace_back();
      sides.push_back({ring[i], ring[(i + 1) % ring.size()]});
      box.add(sides.back().a);
      box.add(sides.back().b);
    }
  }
  const BoxTree tree(boxes);
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    tree.meeting(boxes[i], near);
    for (const std::size_t j : near) {
      if (j > i && cross(sides[i].a, sides[i].b, sides[j].a, sides[j].b)) {
        return crossingOf(sides[i].a, sides[i].b, sides[j].a, sides[j].b);
      }
    }
  }
  return std::nullopt;
}

Ring ringOf(const std::vector<geo::LatLon>& corners, const geo::LocalFrame& frame) {
  Ring ring;
  for (const geo::LatLon& corner : corners) {
    const geo::Point point = frame.toPoint(corner);
    if (ring.empty() || !(point == ring.back())) {
      ring.push_back(point);
    }
  }
  while (ring.size() > 1 && ring.front() == ring.back()) {
    ring.pop_back();
  }
  return ring;
}

std::string placeText(const geo::LocalFrame& frame, geo::Point point) {
  const geo::LatLon place = frame.toLatLon(point);
  return fmt::format("{:.6f}, {:.6f}", place.latitude_deg, place.longitude_deg);
}

}  // namespace vp::risk
