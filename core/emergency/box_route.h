#pragma once

#include "core/emergency/linear_octree.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace vp::emergency {

/** How a box route is sampled. */
struct BoxRouteOptions {
  std::size_t first = 600;   ///< samples in the whole box
  std::size_t second = 100;  ///< of each further sampling, near the turning points of the route so far
  int further = 5;           ///< samplings after the first, each half as wide as the one before: [5] has one, plain FMT* none
  int trees = 2;             ///< first samplings, each with its further ones; the shortest route counts
  double connect = 1.5;      ///< radius of connection of the first sampling, in fmtRadius()
  bool shortens = true;      ///< leaves out points that a free leg can do without, after each sampling
  std::uint64_t seed = 1;

  /** One sampling, nothing else: FMT* as it was published. */
  static BoxRouteOptions plain(std::size_t samples) { return {samples, 0, 0, 1, 1.0, false, 1}; }
};

/** A way of straight legs, and what it took. */
struct BoxRoute {
  std::vector<Point3> points;  ///< from start to end
  double length = 0.0;
  std::int64_t visited = 0;  ///< nodes of all trees
  std::int64_t tested = 0;   ///< legs that were tested
};

/** Whether a straight leg is free. */
using FreeLeg = std::function<bool(const Point3&, const Point3&)>;

/** A short way through a box by FMT*, without courses and descents: the test case of section 5.2 to 5.4 of [5].
 *  @return none if no way was found: more samples may find one   @pre the box is not empty; start and end lie in it
 *  @threads pure, as far as isFree is */
std::optional<BoxRoute> boxRoute(const Cuboid& box, const Point3& start, const Point3& end, const FreeLeg& isFree, const BoxRouteOptions& options);

}  // namespace vp::emergency
