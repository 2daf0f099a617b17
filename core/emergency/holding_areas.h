#pragma once

#include "core/emergency/gradient_options.h"
#include "core/risk/population.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace vp::emergency {

/** Ground of one density with room for a circle. */
struct HoldingArea {
  geo::Point centre;     ///< c(s_h): farthest from all sides
  double room = 0.0;     ///< r_h: radius of the largest circle around it, (63) [m]
  double density = 0.0;  ///< people per m^2
};

/** Where circles may be flown to lose height: the offline part of [3] section 4.7.
 *
 *  Areas of the population that are smaller than the circle are joined with the neighbour that they are most like; in each polygon that is large
 *  enough the place farthest from its sides is found with NLopt (a search over a grid, then BOBYQA around its best; (62) as printed asks for the
 *  greatest sum of distances, which is no place inside: WHY-gradient.md). Made once for a population and a radius, it serves every request.
 *  @threads const members are pure */
class HoldingAreas {
public:
  HoldingAreas() = default;
  /** @param radius  of the circles [m]; areas without room for one are left out   @param within  only those that touch this box
   *  @param isOver  true ends it early, with the areas found so far   @cost 50 to 100 ms for 320 polygons of 100 sides */
  HoldingAreas(const risk::Population& population, double radius, const geo::Box& within = kEverywhere, const std::function<bool()>& isOver = {});

  static constexpr geo::Box kEverywhere{-1e300, -1e300, 1e300, 1e300};

  [[nodiscard]] const std::vector<HoldingArea>& all() const { return areas_; }

private:
  std::vector<HoldingArea> areas_;
};

/** The place in a polygon that is farthest from its sides, and how far that is. @param rings  outline and holes, not closed; at least a triangle
 *  @accuracy a thousandth of the polygon's extent, tested on shapes with known circles   @cost some 0.1 ms for 100 sides */
HoldingArea roomiestPlace(const std::vector<std::vector<geo::Point>>& rings);

/** A holding area and what speaks for it. */
struct RankedHold {
  HoldingArea area;
  double utility = 0.0;  ///< (61), in [0, 4]
};

/** Candidates by falling utility, (61) and (64): few people, near the goal, much room, little population risk straight on to the goal.
 *  @param riskToGoal  g_p(s_h) of each area, in the order of `areas` */
std::vector<RankedHold> rankHolds(const std::vector<HoldingArea>& areas, geo::Point goal, const std::vector<double>& riskToGoal);

}  // namespace vp::emergency
