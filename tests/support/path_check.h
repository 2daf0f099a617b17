#pragma once

// An oracle for paths over terrain that shares no code with the planner or the checker: it flies a path in small steps by
// turning the direction of flight a little at each, and looks at every terrain cell near each position by plain comparison.

#include "core/flight/curve.h"
#include "core/terrain/elevation_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace vp::test {

struct FlownPoint {
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;
  double distance = 0.0;  ///< along the whole path
  std::size_t piece = 0;
};

/** Positions at most `step` metres apart along a path, both ends of every piece included. Chords of each small arc, exact for
 *  their end points; the direction is kept as a vector and turned by multiplication, in long double. */
inline std::vector<FlownPoint> fly(const geo::Pose& start, const std::vector<flight::Piece>& pieces, double step) {
  std::vector<FlownPoint> points;
  long double x = start.x;
  long double y = start.y;
  long double heading = start.heading;
  long double flown = 0.0L;
  points.push_back({start.x, start.y, start.heading, 0.0, 0});
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const flight::Piece& piece = pieces[i];
    const auto parts = static_cast<long>(std::ceil(piece.length / step));
    const long double part = parts > 0 ? static_cast<long double>(piece.length) / static_cast<long double>(parts) : 0.0L;
    long double turned = 0.0L;  // per part
    long double chord = part;
    if (piece.turn != flight::Turn::Straight) {
      const long double radius = piece.radius;
      turned = (piece.turn == flight::Turn::Left ? 1.0L : -1.0L) * part / radius;
      chord = 2.0L * radius * std::sin(part / (2.0L * radius));
    }
    long double east = std::cos(heading + turned / 2.0L);
    long double north = std::sin(heading + turned / 2.0L);
    const long double c = std::cos(turned);
    const long double s = std::sin(turned);
    for (long k = 0; k < parts; ++k) {
      x += chord * east;
      y += chord * north;
      flown += part;
      heading += turned;
      const long double e = east * c - north * s;
      north = north * c + east * s;
      east = e;
      points.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(heading), static_cast<double>(flown), i});
    }
  }
  return points;
}

/** Highest ground of all cells whose closed square comes within `near` metres of a point (in x and in y); infinity if one is
 *  unknown or outside the grid. near = 0: the cells that contain the point. */
inline double groundNear(const terrain::ElevationGrid& grid, double x, double y, double near) {
  const double cell = grid.cellSize();
  const int column = static_cast<int>(std::floor((x - grid.originX()) / cell));
  const int row = static_cast<int>(std::floor((y - grid.originY()) / cell));
  const int reach = 1 + static_cast<int>(std::ceil(near / cell));
  double highest = -std::numeric_limits<double>::infinity();
  for (int j = row - reach; j <= row + reach; ++j) {
    for (int i = column - reach; i <= column + reach; ++i) {
      const double west = grid.originX() + i * cell;
      const double east = grid.originX() + (i + 1) * cell;
      const double south = grid.originY() + j * cell;
      const double north = grid.originY() + (j + 1) * cell;
      if (x + near >= west && x - near <= east && y + near >= south && y - near <= north) {
        const bool inside = i >= 0 && j >= 0 && i < grid.columns() && j < grid.rows();
        highest = std::max(highest, inside ? static_cast<double>(grid.upperInCell(i, j)) : std::numeric_limits<double>::infinity());
      }
    }
  }
  return highest;
}

}  // namespace vp::test
