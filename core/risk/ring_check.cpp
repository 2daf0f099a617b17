#include "core/risk/ring_check.h"

#include "core/risk/boost_box.h"

#include <fmt/format.h>

#include <boost/geometry/index/rtree.hpp>
#include <cstddef>
#include <iterator>
#include <utility>

namespace vp::risk {
namespace {

namespace bgi = boost::geometry::index;
using Entry = std::pair<BoostBox, std::size_t>;

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
  std::vector<Entry> entries;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      geo::Box box;
      sides.push_back({ring[i], ring[(i + 1) % ring.size()]});
      box.add(sides.back().a);
      box.add(sides.back().b);
      entries.emplace_back(boostBox(box), sides.size() - 1);
    }
  }
  const bgi::rtree<Entry, bgi::rstar<16>> tree(entries);
  std::vector<Entry> near;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    near.clear();
    tree.query(bgi::intersects(entries[i].first), std::back_inserter(near));
    for (const auto& [box, j] : near) {
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
