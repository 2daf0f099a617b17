#pragma once

#include "core/geo/pose.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace vp::terrain {

/// Upper bound of the terrain where nothing is known: no data, or outside the map. Unknown is never safe.
inline constexpr float kUnknownUpper = std::numeric_limits<float>::infinity();

/** Terrain in the local metric frame as square cells, each holding an upper bound of the ground inside it.
 *
 *  Cell (i, j) covers the closed square [originX + i*cell, originX + (i+1)*cell] x [originY + j*cell, ...], j to the
 *  north; its value is at least the highest of all posts of the source that surround any of its points (DESIGN
 *  section 2: between posts the terrain is the highest surrounding post). A cell that touches unknown ground is
 *  unknown (infinity).
 *  @threads const members are pure */
class ElevationGrid {
public:
  ElevationGrid() = default;
  /** A value that is no number or minus infinity becomes unknown.
   *  @pre cell > 0, values.size() == columns * rows, row-major from south-west */
  ElevationGrid(double originX, double originY, double cell, int columns, int rows, std::vector<float> values);

  [[nodiscard]] double originX() const { return originX_; }
  [[nodiscard]] double originY() const { return originY_; }
  [[nodiscard]] double cellSize() const { return cell_; }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] const std::vector<float>& values() const { return values_; }
  [[nodiscard]] geo::Box extent() const;

  /** Upper bound of the terrain in a cell, m MSL; infinity for unknown and outside. */
  [[nodiscard]] float upperInCell(int column, int row) const {
    if (column < 0 || row < 0 || column >= columns_ || row >= rows_) {
      return kUnknownUpper;
    }
    return values_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
  }

  /** The column or row that a coordinate lies in. Anything west or south of the grid gives -1, anything east or north
   *  of it columns() or rows(), and what is no number -1: always an index for upperInCell. */
  [[nodiscard]] int columnOf(double x) const;
  [[nodiscard]] int rowOf(double y) const;

  /** Upper bound at a point: of all cells that contain it (up to four on a corner). */
  [[nodiscard]] double upperAt(geo::Point p) const;
  [[nodiscard]] bool isKnownAt(geo::Point p) const { return upperAt(p) < std::numeric_limits<double>::infinity(); }

private:
  double originX_ = 0.0;
  double originY_ = 0.0;
  double cell_ = 1.0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> values_;
};

}  // namespace vp::terrain
