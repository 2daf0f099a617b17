#pragma once

#include "core/flight/curve.h"
#include "core/geo/pose.h"

#include <vector>

namespace vp::safety {

/** A stretch of a piece inside an outline, metres along the piece. */
struct InsideStretch {
  double from = 0.0;
  double to = 0.0;
};

/** An airspace's outline in the frame: a closed chain of straight sides, even-odd. */
class Outline {
public:
  explicit Outline(std::vector<geo::Point> corners);

  [[nodiscard]] const geo::Box& box() const { return box_; }
  [[nodiscard]] bool contains(geo::Point point) const;

  /** Where a straight or a turn runs inside, exactly: its crossings with every side are solved for, not sampled, and between two
   *  neighbouring crossings one point tells for all. Stretches shorter than 1 mm, which only touch, are left out.
   *  @pre isIntegrable(piece)   @cost O(corners + c log c) for c crossings   @threads pure */
  [[nodiscard]] std::vector<InsideStretch> stretchesInside(const geo::Pose& start, const flight::Piece& piece) const;

private:
  void addLineCrossings(const geo::Pose& start, const flight::Piece& piece, std::vector<double>& at) const;
  void addArcCrossings(const geo::Pose& start, const flight::Piece& piece, std::vector<double>& at) const;

  std::vector<geo::Point> corners_;
  geo::Box box_;
};

}  // namespace vp::safety
