#include "core/emergency/holding_areas.h"

#include "core/risk/joined_areas.h"
#include "core/risk/ring_clip.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlopt.hpp>

namespace vp::emergency {
namespace {

using Rings = std::vector<std::vector<geo::Point>>;

constexpr int kGrid = 12;            // places along the longer side of the box that the search begins from
constexpr double kPrecision = 1e-3;  // of the extent
constexpr int kEvaluations = 120;

/// How far a place is from the nearest side; below zero outside.
class Depth {
public:
  explicit Depth(const Rings& rings) : rings_(&rings), sides_(rings) {}

  [[nodiscard]] double at(geo::Point place) const {
    double square = std::numeric_limits<double>::infinity();
    for (const std::vector<geo::Point>& ring : *rings_) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const geo::Point a = ring[i];
        const geo::Point b = ring[i + 1 < ring.size() ? i + 1 : 0];
        const double dx = b.x - a.x;
        const double dy = b.y - a.y;
        const double length = dx * dx + dy * dy;
        const double t = length > 0.0 ? std::clamp(((place.x - a.x) * dx + (place.y - a.y) * dy) / length, 0.0, 1.0) : 0.0;
        const double ex = a.x + t * dx - place.x;
        const double ey = a.y + t * dy - place.y;
        square = std::min(square, ex * ex + ey * ey);
      }
    }
    return (sides_.shareAt(place) == 1.0 ? 1.0 : -1.0) * std::sqrt(square);
  }
  [[nodiscard]] const geo::Box& box() const { return sides_.box(); }

private:
  const Rings* rings_;
  risk::PolygonSides sides_;
};

double depthForNlopt(unsigned /*count*/, const double* x, double* /*gradient*/, void* depth) {
  return static_cast<const Depth*>(depth)->at({x[0], x[1]});
}

}  // namespace

HoldingArea roomiestPlace(const std::vector<std::vector<geo::Point>>& rings) {
  Depth depth(rings);
  const geo::Box& box = depth.box();
  const double width = box.maxX - box.minX;
  const double height = box.maxY - box.minY;
  const double extent = std::max(width, height);
  const double step = extent / kGrid;
  HoldingArea best;
  best.centre = {0.5 * (box.minX + box.maxX), 0.5 * (box.minY + box.maxY)};
  best.room = depth.at(best.centre);
  for (double x = box.minX + 0.5 * step; x < box.maxX; x += step) {
    for (double y = box.minY + 0.5 * step; y < box.maxY; y += step) {
      const double room = depth.at({x, y});
      if (room > best.room) {
        best = {{x, y}, room, 0.0};
      }
    }
  }
  // the depth is continuous, with ridges where two sides are equally near: BOBYQA, which needs no gradient, climbs along them
  nlopt::opt optimizer(nlopt::LN_BOBYQA, 2);
  optimizer.set_max_objective(depthForNlopt, &depth);
  optimizer.set_lower_bounds({box.minX, box.minY});
  optimizer.set_upper_bounds({box.maxX, box.maxY});
  optimizer.set_initial_step(0.5 * step);
  optimizer.set_xtol_abs(kPrecision * extent);
  optimizer.set_maxeval(kEvaluations);
  std::vector<double> place{best.centre.x, best.centre.y};
  double room = best.room;
  try {
    optimizer.optimize(place, room);
    if (room > best.room) {
      best = {{place[0], place[1]}, room, 0.0};
    }
  } catch (const std::exception&) {
    // rounding left it nothing to do: the best of the grid stands
  }
  return best;
}

HoldingAreas::HoldingAreas(const risk::Population& population, double radius, const geo::Box& within, const std::function<bool()>& isOver) {
  for (const risk::Population::Polygon& polygon : risk::joinedAreas(population, Angle::kPi * radius * radius, within, isOver)) {
    if (isOver && isOver()) {
      return;
    }
    HoldingArea area = roomiestPlace(polygon.rings);
    area.density = polygon.density;
    if (area.room >= radius) {
      areas_.push_back(area);
    }
  }
}

std::vector<RankedHold> rankHolds(const std::vector<HoldingArea>& areas, geo::Point goal, const std::vector<double>& riskToGoal) {
  double density = 0.0;
  double distance = 0.0;
  double room = 0.0;
  double risk = 0.0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    density = std::max(density, areas[i].density);
    distance = std::max(distance, geo::distance(areas[i].centre, goal));
    room = std::max(room, areas[i].room);
    risk = std::max(risk, riskToGoal[i]);
  }
  const auto saved = [](double value, double most) { return most > 0.0 ? (most - value) / most : 1.0; };
  std::vector<RankedHold> ranked;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const double utility = saved(areas[i].density, density) + saved(geo::distance(areas[i].centre, goal), distance) +
                           (room > 0.0 ? areas[i].room / room : 0.0) + saved(riskToGoal[i], risk);
    ranked.push_back({areas[i], utility});
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const RankedHold& a, const RankedHold& b) { return a.utility > b.utility; });
  return ranked;
}

}  // namespace vp::emergency
