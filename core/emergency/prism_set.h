#pragma once

#include "core/geo/pose.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace vp::emergency {

/** States that a search has been at: each a hexagonal prism around its place, with a range of altitudes and of courses ([3] section 5.1, Fig. 9).
 *
 *  A state is known if its place lies in the hexagon around a known place of the same layer of altitude and the same range of course. Hexagons are
 *  centred on the states themselves, not on a grid, and have two sides parallel to the y axis.
 *  @cost some few places looked at: they lie in square buckets */
class PrismSet {
public:
  /** @param layer  height of a prism [m]: what a full circle loses, (71)   @param courseStep  rad   @param widest  greatest circumradius [m] */
  PrismSet(double layer, double courseStep, double widest);

  /** Adds a state.  @param circumradius  of its hexagon [m]: half of the segment that led there
   *  @param risk  on the way to it; one that was known at a higher risk is new again (in the paper whoever came first stays)
   *  @return false if it was known already */
  bool add(const geo::Pose& pose, double altitude, double circumradius, double risk);

  [[nodiscard]] std::size_t size() const { return places_.size(); }

private:
  struct Place {
    geo::Point centre;
    double circumradius = 0.0;
    double risk = 0.0;
    std::int32_t next = -1;  ///< in the same bucket
  };

  double layer_;
  double courseStep_;
  double bucket_;
  std::vector<Place> places_;
  std::unordered_map<std::uint64_t, std::int32_t> first_;
};

/** Whether a place lies in a hexagon with two sides parallel to the y axis. */
bool isInHexagon(geo::Point place, geo::Point centre, double circumradius);

}  // namespace vp::emergency
