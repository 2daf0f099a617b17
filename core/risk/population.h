#pragma once

#include "core/base/result.h"
#include "core/flight/curve.h"
#include "core/geo/local_frame.h"
#include "core/mission/population.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace vp::risk {

/** A part of a leg over ground of one density: [from, to] in metres along it. Where areas overlap, so do their stretches. */
struct Stretch {
  double from = 0.0;
  double to = 0.0;
  double density = 0.0;  ///< people per m^2
};

/** What is done with areas that are far denser than all others. */
enum class Outliers {
  Keep,
  /** Densities above Q3 + 1.5 (Q3 - Q1) become Q3, Q1 and Q3 the quartiles over the areas, interpolated linearly.
   *  @source [3] section 7: "an interquartile rule for outlier detection was applied. These values were then adjusted to the third-quartile" */
  ThirdQuartile,
};

/** How many people live where: polygons of constant density in the local frame, in an R*-tree.
 *
 *  Overlapping areas add up; ground that no area covers has nobody on it, known or not. A side belongs half to the area on either side of it, so
 *  a leg along a border counts the mean of both, and one along the outer border half.
 *  @threads const members are pure
 *  @source [3] section 4.5.4; Beckmann et al. 1990 (R*-tree, Boost.Geometry's) */
class Population {
public:
  Population();
  ~Population();
  Population(Population&&) noexcept;
  Population& operator=(Population&&) noexcept;
  Population(const Population&) = delete;
  Population& operator=(const Population&) = delete;

  /** @param frame  that all else is asked in
   *  @errors BadFormat - a number of people that is negative or none, sides that cross, a hole outside its outline, less than three corners, no
   *  area to spread people over; the sentence names file, feature, place and remedy */
  static Result<Population> from(const std::vector<mission::PopulationArea>& areas, const geo::LocalFrame& frame, Outliers outliers = Outliers::Keep);

  /** People per m^2 at a place; on a border the mean of both sides. */
  [[nodiscard]] double densityAt(geo::Point place) const;

  /** The parts of a leg over people, exact: the leg is clipped at every side that it crosses.
   *  @param out  is emptied first   @cost O(log areas + sides near the leg), some microseconds   @accuracy rounding, 1e-6 m */
  void along(const geo::Pose& from, const flight::Piece& piece, std::vector<Stretch>& out) const;

  /** Density along a leg, summed over its length [people / m]. */
  [[nodiscard]] double integralAlong(const geo::Pose& from, const flight::Piece& piece) const;

  /** The greatest density of an area [people / m^2]; 0 without any. What [3] (46) calls kappa_eta. */
  [[nodiscard]] double greatestDensity() const;
  /** Polygons, each part of an area counted. */
  [[nodiscard]] std::size_t size() const;

  /** A polygon as it lies in the frame, for those who merge or draw them. */
  struct Polygon {
    std::vector<std::vector<geo::Point>> rings;  ///< the outline, then the holes; not closed
    double density = 0.0;                        ///< people per m^2
    double area = 0.0;                           ///< m^2
  };
  [[nodiscard]] const Polygon& polygon(std::size_t i) const;

private:
  struct Index;
  std::unique_ptr<const Index> index_;
};

}  // namespace vp::risk
