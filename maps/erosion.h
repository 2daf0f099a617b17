// Landscapes by the work of rivers: uplift, incision by the stream power law, and slopes no steeper than rock stands.
#pragma once

#include "maps/height_field.h"

#include <functional>
#include <vector>

namespace vp::maps {

/** How fast the ground rises and how hard it is, by place (metres in the frame of the field). */
struct Tectonics {
  std::function<double(double x, double y)> uplift;    ///< relative, 0..1 and somewhat above
  std::function<double(double x, double y)> hardness;  ///< relative resistance of the rock, about 1
  double steepness = 0.0;                              ///< slope times square root of drained area [m] where uplift and hardness are 1
  double talus = 1.0;                                  ///< steepest slope that rock of hardness 1 stands at [-]
  double diffusion = 0.0;                              ///< share of the mean difference to the neighbours levelled per step [-]
};

/** Which way the water runs on a field. */
struct Drainage {
  std::vector<std::size_t> order;     ///< all posts, each after the one it drains to
  std::vector<std::size_t> receiver;  ///< post that each drains to; itself at the border
  std::vector<double> area;           ///< drained area [m^2]
};

/** Drainage of a field to its border; pits are filled up on the way so that all water gets out. */
Drainage drain(HeightField& field);

/** Lets a landscape come near its steady state: coarse fields first, each refined to twice the posts.
 *  The border stays at height 0.
 *  @param steps  for each level, coarse to fine; the last has `size` posts, the one before (size + 1) / 2 and so on
 *  @source implicit stream power scheme: Braun and Willett 2013, Geomorphology 180-181, with m = 1/2, n = 1;
 *  filling of pits by priority flood: Barnes, Lehman, Mulla 2014, Computers & Geosciences 62 */
HeightField erode(int size, double spacing, const Tectonics& tectonics, const std::vector<int>& steps, std::uint64_t seed);

/** Bends the lines of a landscape by up to `amplitude` metres sideways, so that the eight directions of the flow do not show. */
void bend(HeightField& field, double amplitude, double wavelength, std::uint64_t seed);

}  // namespace vp::maps
