#pragma once

#include "core/risk/population.h"

#include <functional>
#include <vector>

namespace vp::risk {

/** The polygons of a population with those below an area joined to the neighbour that they share a border with and whose density is most like theirs,
 *  until they are large enough or have no neighbour; the density of what is joined is that of its people on all of it.
 *
 *  Polygons are neighbours if they meet in more than points. Of those below `least` in the end none is returned.
 *  @param least   m^2   @param within  polygons that do not touch this box are left out
 *  @param isOver  asked before each union; true: what is still too small is left out   @cost some 0.1 ms for each that is joined
 *  @source [3] (60) and the paragraph after it   @threads pure */
std::vector<Population::Polygon> joinedAreas(const Population& population, double least, const geo::Box& within,
                                             const std::function<bool()>& isOver = {});

}  // namespace vp::risk
