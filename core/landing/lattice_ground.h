#pragma once

#include "core/landing/lattice_glides.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace vp::landing {

/** The ground under the primitives of a lattice, as the search meets it: the step of the lattice is a whole number of
 *  terrain cells, so what a primitive touches is a list of cell offsets that serves wherever it starts.
 *
 *  Every cell that comes within a millimetre of the curve counts, with the loss up to where the curve has left it; so a
 *  test is an upper bound for the whole curve, as requiredStartHeight is (tst_lattice_ground compares them).
 *  Heights are kept in single precision with the clearance added, rounded up. */
class LatticeGround {
public:
  /** Copies the part of the terrain that primitives can touch; what lies outside the terrain is unknown.
   *  @pre glides has its geometry, primitives and radii; lattice points lie at centres of terrain cells */
  LatticeGround(const World& world, const LatticeGlides& glides);

  /** Height needed at the start of primitive `i` of arrivals[heading] for the ground alone, when it ends at lattice point
   *  (column, row): the highest of ground + clearance + loss to there [m MSL]; infinity over unknown ground.
   *  @param giveUpAt  may return less than the highest as soon as it is at least this */
  [[nodiscard]] float required(int heading, std::size_t i, int column, int row, float giveUpAt = std::numeric_limits<float>::infinity()) const {
    const Stencil& stencil = stencils_[static_cast<std::size_t>(heading)][i];
    const float* ground = &ground_[cellAt(column, row)];
    float highest = -1e9F;
    for (std::uint32_t c = stencil.first; c < stencil.end && highest < giveUpAt;) {
      const std::uint32_t end = std::min(c + 8U, stencil.end);  // asked every few cells: cheaper than at each
      for (; c < end; ++c) {
        const float needed = ground[offsets_[c]] + losses_[c];
        highest = needed > highest ? needed : highest;
      }
    }
    return highest;
  }

  /** Upper bound of ground + clearance wherever a primitive that ends at a lattice point can be [m MSL]. */
  [[nodiscard]] float highestAround(int column, int row) const {
    return around_[static_cast<std::size_t>(row) * static_cast<std::size_t>(latticeColumns_) + static_cast<std::size_t>(column)];
  }

private:
  struct Stencil {
    std::uint32_t first = 0;
    std::uint32_t end = 0;
  };
  [[nodiscard]] std::size_t cellAt(int column, int row) const {
    return static_cast<std::size_t>(row * perStep_ + margin_) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column * perStep_ + margin_);
  }
  void copyGround(const World& world, const LatticeGlides& glides);
  void boundSurroundings(const World& world, const LatticeGlides& glides);
  void makeStencils(const LatticeGlides& glides, double cell);

  int perStep_ = 1;  ///< terrain cells per step of the lattice
  int margin_ = 0;   ///< cells around the outermost lattice points
  int columns_ = 0;  ///< of the copy
  int latticeColumns_ = 0;
  std::vector<float> ground_;
  std::vector<float> around_;
  std::vector<std::vector<Stencil>> stencils_;  ///< as GlidePrimitives::arrivals
  std::vector<std::int32_t> offsets_;           ///< of cells, from the cell of the primitive's end
  std::vector<float> losses_;                   ///< from the primitive's start to where it has left the cell
};

}  // namespace vp::landing
