#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace vp::emergency {

/** Weather over one slice of a track: the altitudes that it fills and what a metre in it costs. */
struct SliceLayer {
  double floor = 0.0;  ///< m MSL
  double top = 0.0;    ///< m MSL
  double rate = 0.0;   ///< -log of the probability of coming through, per metre
};

/** A part of a track along which the same weather is met and slopes have one range. */
struct AltitudeSlice {
  double length = 0.0;                                       ///< m over ground
  double least = 0.0;                                        ///< slope of the best glide [-]
  double most = 0.0;                                         ///< of the steepest descent [-], >= least
  double lowest = -std::numeric_limits<double>::infinity();  ///< m MSL: nowhere on it lower
  std::vector<SliceLayer> layers;
};

/** Altitudes at one place that can be had for the same cost. */
struct AltitudeInterval {
  double low = 0.0;  ///< m MSL
  double high = 0.0;
  double cost = 0.0;
  int parent = -1;         ///< the interval before the slice that it comes from, by its index
  double parentLow = 0.0;  ///< altitudes of the parent from which the slice was entered
  double parentHigh = 0.0;
};

/** Altitude intervals through a slice: what HA* of [4] does along an edge of its hybrid roadmap. The result is the cheapest way to each altitude:
 *  disjoint intervals, ascending.
 *
 *  Between floors and tops altitude does not matter, so a slice falls into bands; who stays in one pays for all layers of that band together, who
 *  crosses from one to a lower pays the dearest of those between for the whole slice ([4] section 2.1, assumptions 1 and 2; layers that overlap add
 * up, as core/risk has it).  @cost O(intervals x bands^2)   @threads pure */
std::vector<AltitudeInterval> throughSlice(const std::vector<AltitudeInterval>& from, const AltitudeSlice& slice);

/** The altitudes at the ends of all slices [m MSL] that cost least, flown as high as may be.
 *  @param start  altitude before the first   @param end  after the last at least   @return none: no way */
std::optional<std::vector<double>> cheapestAltitudes(double start, const std::vector<AltitudeSlice>& slices, double end);

}  // namespace vp::emergency
