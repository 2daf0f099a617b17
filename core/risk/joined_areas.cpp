#include "core/risk/joined_areas.h"

#include <queue>

#include <algorithm>
#include <boost/geometry/algorithms/area.hpp>
#include <boost/geometry/algorithms/correct.hpp>
#include <boost/geometry/algorithms/union.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace vp::risk {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint>;

constexpr double kTouch = 1e-3;  // m: boxes this near may share a border

BoostPolygon toBoost(const Population::Polygon& polygon) {
  BoostPolygon result;
  for (std::size_t ring = 0; ring < polygon.rings.size(); ++ring) {
    if (ring > 0) {
      result.inners().emplace_back();
    }
    auto& corners = ring == 0 ? result.outer() : result.inners().back();
    for (const geo::Point& corner : polygon.rings[ring]) {
      corners.emplace_back(corner.x, corner.y);
    }
  }
  bg::correct(result);
  return result;
}

std::vector<geo::Point> fromBoost(const BoostPolygon::ring_type& ring) {
  std::vector<geo::Point> corners;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
    corners.push_back({ring[i].x(), ring[i].y()});
  }
  return corners;
}

geo::Box boxOf(const Population::Polygon& polygon) {
  geo::Box box;
  for (const geo::Point& corner : polygon.rings.front()) {
    box.add(corner);
  }
  return box;
}

bool mayTouch(const geo::Box& a, const geo::Box& b) {
  return a.minX <= b.maxX + kTouch && b.minX <= a.maxX + kTouch && a.minY <= b.maxY + kTouch && b.minY <= a.maxY + kTouch;
}

/// Both as one polygon; none if they do not share a border.
std::optional<Population::Polygon> joined(const Population::Polygon& a, const Population::Polygon& b) {
  bg::model::multi_polygon<BoostPolygon> both;
  bg::union_(toBoost(a), toBoost(b), both);
  if (both.size() != 1) {
    return std::nullopt;
  }
  Population::Polygon result;
  result.rings.push_back(fromBoost(both.front().outer()));
  for (const BoostPolygon::ring_type& hole : both.front().inners()) {
    result.rings.push_back(fromBoost(hole));
  }
  result.area = std::abs(bg::area(both.front()));
  result.density = result.area > 0.0 ? (a.density * a.area + b.density * b.area) / result.area : 0.0;
  return result;
}

}  // namespace

std::vector<Population::Polygon> joinedAreas(const Population& population, double least, const geo::Box& within,
                                             const std::function<bool()>& isOver) {
  std::vector<Population::Polygon> polygons;
  std::vector<geo::Box> boxes;
  std::vector<bool> isGone;
  using Waiting = std::pair<double, std::size_t>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> small;  // the smallest first
  const auto add = [&](Population::Polygon polygon) {
    boxes.push_back(boxOf(polygon));
    isGone.push_back(false);
    if (polygon.area < least) {
      small.emplace(polygon.area, polygons.size());
    }
    polygons.push_back(std::move(polygon));
  };
  for (std::size_t i = 0; i < population.size(); ++i) {
    if (mayTouch(boxOf(population.polygon(i)), within)) {
      add(population.polygon(i));
    }
  }
  while (!small.empty() && !(isOver && isOver())) {
    const std::size_t i = small.top().second;
    small.pop();
    if (isGone[i]) {
      continue;
    }
    std::vector<std::size_t> near;
    for (std::size_t j = 0; j < polygons.size(); ++j) {
      if (j != i && !isGone[j] && mayTouch(boxes[i], boxes[j])) {
        near.push_back(j);
      }
    }
    const auto difference = [&](std::size_t j) { return std::abs(polygons[j].density - polygons[i].density); };
    std::stable_sort(near.begin(), near.end(), [&](std::size_t a, std::size_t b) { return difference(a) < difference(b); });
    for (const std::size_t j : near) {
      if (std::optional<Population::Polygon> both = joined(polygons[i], polygons[j])) {
        isGone[i] = isGone[j] = true;
        add(std::move(*both));
        break;
      }
    }
  }
  std::vector<Population::Polygon> result;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (!isGone[i] && polygons[i].area >= least) {
      result.push_back(std::move(polygons[i]));
    }
  }
  return result;
}

}  // namespace vp::risk
