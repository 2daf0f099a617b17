#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/landing/world.h"

#include <vector>

namespace vp::tour {

/** Ways around ground that no tour may cross: unknown, or too high to clear under the ceiling.
 *
 *  The source papers fly one Dubins path between two targets, which fails where that path meets a void of the terrain
 *  file, however easily one flies around it. Here a pair of targets whose straight line is barred gets poses to pass
 *  on the way: shortest path over a coarse grid (Dijkstra, eight neighbours; ground nearer to a bar than a turn is
 *  wide costs more), pulled straight where nothing is in between. A heuristic: whether a leg over these poses is
 *  possible and safe is decided by the segment like for any other leg.
 *  @threads const members are pure */
class Detours {
public:
  Detours() = default;

  /** Looks at all pairs of `targets`. Nothing to do, and no time spent, where no ground is barred.
   *  @param ceiling  highest altitude of the tour [m MSL], may be infinite   @errors Cancelled */
  static Result<Detours> find(const landing::World& world, const std::vector<geo::Point>& targets, double ceiling, const Job& job);

  /** Poses to pass between two targets if the direct leg is barred; nothing if the straight line is free or no way exists. */
  [[nodiscard]] const std::vector<geo::Pose>& between(int from, int to) const;

private:
  std::size_t count_ = 0;
  std::vector<std::vector<geo::Pose>> poses_;  ///< count_ * count_, empty if nothing is barred
};

}  // namespace vp::tour
