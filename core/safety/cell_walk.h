#pragma once

#include "core/flight/curve.h"
#include "core/safety/ground_path.h"
#include "core/terrain/elevation_grid.h"

#include <vector>

namespace vp::safety {

/** A stretch of a path over the same cells, and the highest ground of all cells it touches. */
struct Span {
  double from = 0.0;  ///< m along the piece
  double to = 0.0;
  double ground = 0.0;  ///< m MSL, upper bound; infinity if any touched cell is unknown
  [[nodiscard]] bool isKnown() const;
};

/** Walks all terrain cells under a straight or a turn, in order, without sampling.
 *
 *  The spans of a piece join without a gap from 0 to its length (one span of length 0 for a piece of length 0). The ground
 *  of a span is at least the value of every closed cell that the path touches inside it: a path along a grid line
 *  counts the cells on both sides, one through a corner all four. Cells up to 4 um beside the path may be counted too,
 *  no others (proof: WHY.md section 2). Unknown, outside the map, not finite or below kLowestGround: infinity.
 *  Reusable for many pieces: keeps its buffer.
 *  @cost O(c log c) for c crossed grid lines   @threads one walk per thread */
class CellWalk {
public:
  /** @pre terrain has a cell size of kSmallestCell or more and outlives the walk */
  explicit CellWalk(const terrain::ElevationGrid& terrain);

  /** Begins a piece. @pre isIntegrable(piece), |start| <= kFarthest */
  void start(const geo::Pose& start, const flight::Piece& piece);

  /** The next span, in order of distance; false when the piece is done. */
  bool next(Span& span);

private:
  void collectLine();
  void collectArc();
  [[nodiscard]] geo::Point pointAt(double distance) const;
  [[nodiscard]] double groundIn(geo::Point a, geo::Point b) const;

  const terrain::ElevationGrid& terrain_;
  geo::Pose start_;
  bool isArc_ = false;
  Circle circle_;
  double cosHeading_ = 1.0;
  double sinHeading_ = 0.0;
  double length_ = 0.0;
  double lap_ = 0.0;            // length after which breaks_ repeat; > length_ if they do not
  std::vector<double> breaks_;  // distances at which the touched cells may change, ascending, of the first lap
  std::size_t index_ = 0;
  double lapStart_ = 0.0;
  double at_ = 0.0;
  geo::Point pointAt_;
  bool done_ = true;
};

}  // namespace vp::safety
