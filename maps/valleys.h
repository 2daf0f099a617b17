// Glacier-shaped main valleys and the airfields on their floors.
#pragma once

#include "maps/airstrip.h"
#include "maps/erosion.h"
#include "maps/height_field.h"

#include <string>
#include <vector>

namespace vp::maps {

/** The shape of a main valley across its river. */
struct ValleyShape {
  double leastArea = 0.0;         ///< drained area from which a river has a flat floor [m^2]
  double floorPerRootArea = 0.0;  ///< half width of the floor over the square root of the drained area [-]
  double widestFloor = 0.0;       ///< largest half width of the floor [m]
  double curvature = 0.0;         ///< sides rise by curvature * d^2 beyond the floor [1/m]
  double steepestSide = 0.0;      ///< up to this slope [-]
};

/** Widens the valleys of all rivers of enough drained area: a flat floor, then a parabola up to the steepest side. */
void carveValleys(HeightField& field, const Drainage& drainage, const ValleyShape& shape);

/** The middle of a field: `size` posts each way. The size of both must be odd or both even. */
HeightField cropped(const HeightField& field, int size);

/** Where an airfield is wanted; the strip is laid along the river on the valley floor. */
struct AirstripWish {
  std::string ident;
  std::string name;
  double length = 0.0;  ///< m
  double width = 0.0;   ///< m
  std::string surface;  ///< as OurAirports writes it
};

/** Finds places for airstrips on valley floors, each as far from the others as it goes: level along the strip and free to
 *  both sides. Thresholds are whole metres. Fewer strips than wishes come back if there is no room.
 *  @param drainage  of a field `offset` posts larger on every side */
std::vector<Airstrip> placeAirstrips(const HeightField& field, const Drainage& drainage, int drainageSize, double leastArea,
                                     const std::vector<AirstripWish>& wishes);

}  // namespace vp::maps
