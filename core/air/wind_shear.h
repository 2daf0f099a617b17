#pragma once

#include "core/air/wind_layer.h"

#include <vector>

namespace vp::air {

/** Greatest change of the wind with height [1/s] where every layer has any wind of its sector and between neighbours it is linear in height:
 *  the largest distance between a wind of the lower and one of the upper, over the height between them. Zero with fewer than two layers;
 *  infinite for different winds at one altitude.  @threads pure */
double mostShear(std::vector<WindLayer> layers);

}  // namespace vp::air
