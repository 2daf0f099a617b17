#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/geo/pose.h"
#include "core/landing/roadmap.h"
#include "core/landing/world.h"

#include <vector>

namespace vp::landing {

/** Lowest safe altitude over an area: A(q) at the centres of square cells for evenly spread headings, for maps.
 *  A picture and no proof: between centres and headings nothing is claimed. [1] Figs. 3 and 4. */
struct SafeAltitudeField {
  double originX = 0.0;  ///< m, south-west corner
  double originY = 0.0;
  double cell = 0.0;  ///< m
  int columns = 0;
  int rows = 0;
  int headings = 0;             ///< heading h is 2 pi h / headings, mathematical
  std::vector<float> altitude;  ///< m MSL, [(row * columns + column) * headings + h]; infinity: no glide or unknown ground

  [[nodiscard]] float at(int column, int row, int heading) const;
  [[nodiscard]] float worst(int column, int row) const;  ///< highest over the headings
  [[nodiscard]] float best(int column, int row) const;   ///< lowest over the headings
};

/** Computes the field over `area` with at most `cells` cells along its longer side.
 *  @errors Cancelled   @threads pure   @cost columns * rows * headings queries of some 40 us */
Result<SafeAltitudeField> safeAltitudeField(const World& world, const Roadmap& roadmap, const geo::Box& area, int cells, int headings,
                                            const Job& job);

}  // namespace vp::landing
