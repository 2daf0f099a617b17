#pragma once

#include "core/flight/curve.h"
#include "core/geo/pose.h"

#include <vector>

namespace vp::risk {

/** The sides of a polygon, sorted into horizontal slabs so that those near a place or a leg are found at once.
 *  @threads const members are pure */
class PolygonSides {
public:
  PolygonSides() = default;
  /** @param rings  outline and holes, not closed */
  explicit PolygonSides(const std::vector<std::vector<geo::Point>>& rings);

  /** 1 inside, 0 outside, 0.5 within a micrometre of a side. Crossing number (even-odd), Hormann and Agathos 2001. */
  [[nodiscard]] double shareAt(geo::Point place) const;

  /** Appends where a leg meets sides [m along it, in 0..length]; more places than it really meets are possible, fewer are not.
   *  @param within  box of the leg */
  void crossings(const geo::Pose& from, const flight::Piece& piece, const geo::Box& within, std::vector<double>& out) const;

  /** A part of a leg inside the polygon: [from, to] in metres along it; share as of shareAt. */
  struct Inside {
    double from = 0.0;
    double to = 0.0;
    double share = 1.0;
  };
  /** The parts of a leg inside, in order, those along a side included; between two crossings the middle of the part decides.
   *  @param within  box of the leg   @param out  is emptied first */
  void insideAlong(const geo::Pose& from, const flight::Piece& piece, const geo::Box& within, std::vector<Inside>& out) const;

  [[nodiscard]] const geo::Box& box() const { return box_; }

private:
  struct Side {
    geo::Point a;
    geo::Point b;
  };
  [[nodiscard]] std::size_t slabOf(double y) const;

  geo::Box box_;
  double slabsPerMetre_ = 0.0;
  std::vector<std::size_t> first_;  ///< of each slab in sides_, and the end
  std::vector<Side> sides_;         ///< slab by slab; a side stands in each slab that it touches
};

}  // namespace vp::risk
