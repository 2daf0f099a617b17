#pragma once

#include "core/base/job.h"
#include "core/base/result.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vp::emergency {

/** A place in three dimensions: x east, y north in the local frame, z up (m MSL); or any other unit, if all that meets has it. */
struct Point3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  bool operator==(const Point3&) const = default;
};

/** An axis-parallel closed box. */
struct Cuboid {
  Point3 low;
  Point3 high;
};

/** How space is cut into equal cells: cell (i, j, k) is the closed box from low + (i, j, k) * cell on. */
struct CellBox {
  Point3 low;
  Point3 cell{1.0, 1.0, 1.0};         ///< lengths of a cell's edges, > 0; not needed to be the same
  std::array<int, 3> count{1, 1, 1};  ///< cells along x, y and z, each in [1, LinearOctree::kMostCells]

  [[nodiscard]] Point3 high() const { return {low.x + cell.x * count[0], low.y + cell.y * count[1], low.z + cell.z * count[2]}; }
};

/** Free space as a linear octree: the largest cubes of 2^n cells a side in which nothing is blocked, by ascending Morton code.
 *
 *  A cell is blocked if it touches an obstacle, and one that comes nearer than 1e-9 of a cell counts as touched; so what lies in free cells, on
 *  their faces too, is apart from every obstacle by more than any rounding here. Outside the box nothing is known, and nothing is free.
 *  @threads const members are pure
 *  @source Gargantini 1982 (linear quadtrees); the octree of free space and the search by Morton code: section 4.2 of [5]. What differs: README.md */
class LinearOctree {
public:
  static constexpr int kMostCells = 32768;  ///< along one axis

  LinearOctree() = default;

  /** @param ground     the height up to which each column of cells is blocked, by what touches its sides too (blockedHeights), rows from the
   *  south-west; infinity: all of it. Empty: no ground
   *  @param obstacles  blocked beside that
   *  @errors Cancelled   @cost O(leaves + columns)
   *  @pre ground is empty or has one value for each column; no coordinate is not a number */
  static Result<LinearOctree> build(const CellBox& box, const std::vector<float>& ground, const std::vector<Cuboid>& obstacles, const Job& job);

  /** Whether a place lies in a free cell. @cost one search in the sorted leaves */
  [[nodiscard]] bool isFree(const Point3& p) const;
  /** Whether all of a segment lies in free cells; a segment that only touches a blocked cell may be called free or not. @cost a search for each leaf
   *  that it crosses */
  [[nodiscard]] bool isFree(const Point3& from, const Point3& to) const;
  /** Whether all of a closed box lies in free cells. @cost a search for each leaf in it, until one is missing */
  [[nodiscard]] bool isBoxFree(const Cuboid& part) const;

  [[nodiscard]] const CellBox& box() const { return box_; }
  [[nodiscard]] std::size_t leaves() const { return leaves_.size(); }
  /** Memory of the leaves and of the table that shortens searches [bytes]. */
  [[nodiscard]] std::size_t bytes() const { return leaves_.size() * sizeof(leaves_[0]) + first_.size() * sizeof(first_[0]); }
  /** Cells that are free; of all box().count. */
  [[nodiscard]] std::int64_t freeCells() const;

  /** The bits of three numbers below 2^21 in turn, those of x lowest. */
  static std::uint64_t mortonOf(std::uint32_t x, std::uint32_t y, std::uint32_t z);

private:
  friend class OctreeBuilder;
  using Cell = std::array<int, 3>;
  struct CellRange {
    Cell low{};
    Cell high{};  ///< the last that belongs to it
  };

  [[nodiscard]] std::array<double, 3> inCells(const Point3& p) const;
  /// @return 2^n of the leaf that a cell lies in; 0: it is blocked
  [[nodiscard]] int leafSide(const Cell& cell) const;
  [[nodiscard]] bool areFree(CellRange range) const;

  CellBox box_;
  int levels_ = 0;                     ///< the whole is 2^levels_ cells a side
  int tableLevel_ = 0;                 ///< first_ has one entry for each cube of 2^tableLevel_ cells
  std::vector<std::uint64_t> leaves_;  ///< Morton code of the first cell * 16 + n
  std::vector<std::uint32_t> first_;   ///< of the leaves whose code is in the cube or behind it
};

}  // namespace vp::emergency
