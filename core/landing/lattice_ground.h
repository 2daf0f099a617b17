#pragma once

#include "core/landing/lattice_glides.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
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
  struct Cell {
    std::int32_t offset = 0;  ///< from the cell of the primitive's end
    float loss = 0.0F;        ///< from the primitive's start to where it has left the cell
  };
  struct Stencil {
    std::uint32_t first = 0;
    std::uint32_t end = 0;
  };
  /// Cells that are looked at between two questions whether that is enough; stencils are filled up to it.
  static constexpr std::size_t kTogether = 4;

public:
  /** Copies the part of the terrain that primitives can touch; what lies outside the terrain is unknown.
   *  @pre glides has its geometry, primitives and radii; lattice points lie at centres of terrain cells */
  LatticeGround(const World& world, const LatticeGlides& glides);

  /// What the primitives that end at one pose meet.
  class Arrivals {
  public:
    /** Height needed at the start of a primitive of GlidePrimitives::arrivals for the ground alone: the highest of
     *  ground + clearance + loss to there [m MSL]; infinity over unknown ground.
     *  @param giveUpAt  may return less than the highest as soon as it is at least this */
    [[nodiscard]] float required(std::size_t primitive, float giveUpAt = std::numeric_limits<float>::infinity()) const {
      const Stencil& stencil = stencils_[primitive];
      float highest = -1e9F;
      // from the start on, where most hopeless ones fail
      for (const Cell* cell = cells_ + stencil.first; cell < cells_ + stencil.end && highest < giveUpAt; cell += kTogether) {
        std::array<float, kTogether> needed{};  // each on its own: a running maximum would wait for the one before
        for (std::size_t c = 0; c < kTogether; ++c) {
          needed[c] = ground_[cell[c].offset] + cell[c].loss;
        }
        highest = std::max(highest, std::max(std::max(needed[0], needed[1]), std::max(needed[2], needed[3])));
      }
      return highest;
    }

  private:
    friend class LatticeGround;
    const Stencil* stencils_ = nullptr;
    const Cell* cells_ = nullptr;
    const float* ground_ = nullptr;  ///< at the pose
  };

  /** Adds the same lists with the losses of some bands. @return its number; the one of all altitudes is 0 */
  std::size_t addCover(const LatticeGlides& glides, const aircraft::GlideModel& glide);

  /** Height that a primitive of arrivals[heading] loses by a cover [m]. */
  [[nodiscard]] double lossOf(std::size_t cover, std::size_t heading, std::size_t primitive) const {
    return covers_[cover].losses[heading][primitive];
  }

  /** The primitives of arrivals[heading], ending at lattice point (column, row). Valid as long as this object.
   *  @param cover  number of the losses */
  [[nodiscard]] Arrivals arrivalsAt(int heading, int column, int row, std::size_t cover = 0) const {
    Arrivals arrivals;
    arrivals.stencils_ = covers_[cover].stencils[static_cast<std::size_t>(heading)].data();
    arrivals.cells_ = covers_[cover].cells.data();
    arrivals.ground_ = &ground_[cellAt(column, row)];
    return arrivals;
  }

  /** Upper bound of ground + clearance wherever a primitive that ends at a lattice point can be [m MSL]. */
  [[nodiscard]] float highestAround(int column, int row) const {
    return around_[static_cast<std::size_t>(row) * static_cast<std::size_t>(latticeColumns_) + static_cast<std::size_t>(column)];
  }

private:
  [[nodiscard]] std::size_t cellAt(int column, int row) const {
    return static_cast<std::size_t>(row * perStep_ + margin_) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column * perStep_ + margin_);
  }
  void copyGround(const World& world, const LatticeGlides& glides);
  void boundSurroundings(const World& world, const LatticeGlides& glides);
  struct Cover {
    std::vector<std::vector<Stencil>> stencils;  ///< as GlidePrimitives::arrivals
    std::vector<std::vector<double>> losses;     ///< of whole primitives, m
    std::vector<Cell> cells;
  };

  int perStep_ = 1;  ///< terrain cells per step of the lattice
  int margin_ = 0;   ///< cells around the outermost lattice points
  int reach_ = 0;    ///< cells to the side that primitives touch at most
  int columns_ = 0;  ///< of the copy
  int latticeColumns_ = 0;
  std::vector<float> ground_;
  std::vector<float> around_;
  double cell_ = 1.0;  ///< m, of the terrain
  std::deque<Cover> covers_;
};

}  // namespace vp::landing
