#pragma once

#include "core/landing/glide_primitives.h"
#include "core/landing/world.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace vp::landing {

/// Half the spacing of single precision between 8 and 16 km [m]: what adding two heights in it may lose.
inline constexpr double kRoundingOfSum = 0.5e-3;

/** A height in single precision, never below the one given. */
inline float roundedUp(double height) {
  return std::nextafter(static_cast<float>(height), std::numeric_limits<float>::infinity());
}

/** Landing glides from the poses of a state lattice: for each pose how high, and where its glide leads first.
 *  Plain data, filled by buildLatticeRoadmap; local frame, metres, m MSL.
 *
 *  Nodes are numbered: lattice poses ("states") first, then the landing sites ("roots"), where the approaches to them begin. Altitudes are stored in
 * single precision, rounded up, so that they stay upper bounds. */
struct LatticeGlides {
  /// Where the approach to a landing site begins, as a node.
  struct Root {
    geo::Pose pose;
    flight::Direction direction;
    double altitude = 0.0;  ///< m MSL there
    int site = -1;          ///< index into World::sites
  };

  double originX = 0.0;  ///< of the lattice point with column and row 0
  double originY = 0.0;
  int columns = 0;
  int rows = 0;
  aircraft::GlideModel glide;  ///< of the world that they were found in; owns what `radii` point to
  std::vector<RadiusLoss> radii;
  GlidePrimitives primitives;
  std::vector<Root> roots;
  std::vector<float> altitude;     ///< by state; infinity: no glide known
  std::vector<std::int32_t> via;   ///< by state: the node that the first leg leads to, -1 for none
  std::vector<std::uint16_t> leg;  ///< by state: radius * 8 + word of the first leg

  [[nodiscard]] int headings() const { return static_cast<int>(primitives.headings.size()); }
  [[nodiscard]] int states() const { return columns * rows * headings(); }
  [[nodiscard]] int stateAt(int column, int row, int heading) const { return (row * columns + column) * headings() + heading; }
  [[nodiscard]] bool isInside(int column, int row) const { return column >= 0 && row >= 0 && column < columns && row < rows; }
  [[nodiscard]] bool isRoot(int node) const { return node >= states(); }
  [[nodiscard]] const Root& rootOf(int node) const { return roots[static_cast<std::size_t>(node - states())]; }

  [[nodiscard]] geo::Pose poseOf(int node) const;
  [[nodiscard]] flight::Direction directionOf(int node) const;
  [[nodiscard]] double altitudeOf(int node) const {
    return isRoot(node) ? rootOf(node).altitude : static_cast<double>(altitude[static_cast<std::size_t>(node)]);
  }
  /** The node that a node glides to next, -1 for a root. */
  [[nodiscard]] int nextOf(int node) const { return isRoot(node) ? -1 : via[static_cast<std::size_t>(node)]; }
  /** Index into World::sites that the glide from a node ends at. */
  [[nodiscard]] int siteOf(int node) const;
  /** First leg of a state's glide. @pre the state has one */
  [[nodiscard]] flight::DubinsPath legOf(int state) const;
};

/** A glide from a pose straight to a node, and the height needed at its start. */
struct LatticeLeg {
  flight::DubinsPath path;
  std::size_t radius = 0;
  double altitude = std::numeric_limits<double>::infinity();
  bool isHeldUp = false;  ///< whether the ground asks for more height than the glide loses
};

/** The lowest glide by a single Dubins path to a node, if one needs less than `below`, over two radii: the one that loses
 *  least, and where the ground asks for more than that, the tightest, which stays farthest from the slopes ahead. (All
 *  four of the source paper's aircraft take twice as long and find altitudes 0.3 m lower; mountain, 5,000 queries.)
 *  @param tried  counts paths that met the ground
 *  @return altitude infinite if there is none */
LatticeLeg lowestLeg(const World& world, const LatticeGlides& glides, const geo::Pose& from, flight::Direction direction, int node, double below,
                     std::int64_t& tried);

}  // namespace vp::landing
