#pragma once

#include "core/geo/pose.h"
#include "core/terrain/terrain_pyramid.h"

namespace vp::landing {

/// A cell this close to a curve counts as touched [m]; far above rounding, far below anything flown.
inline constexpr double kTouch = 1e-3;

/** The highest of `required` and, over all cells that a line touches, ground + `above` + the loss up to where the line has
 *  left the cell [m MSL]. Walks the cells of a coarse level of the pyramid and looks closer only where one asks for more.
 *
 *  Cells count with a millimetre around them, so the answer is an upper bound for the line itself.
 *  @param above        clearance, and whatever was lost before the line begins [m]
 *  @param giveUpAbove  above this the answer may be any number above it
 *  @return infinity over unknown ground
 *  @cost O(cells) at worst, where the ground leaves room O(log cells)   @threads pure */
double requiredAlongLine(const terrain::TerrainPyramid& terrain, geo::Point from, geo::Point to, double lossPerMetre, double above, double required,
                         double giveUpAbove);

}  // namespace vp::landing
