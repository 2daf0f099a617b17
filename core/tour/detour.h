#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/landing/altitude_floor.h"
#include "core/landing/world.h"
#include "core/tour/forbidden_airspace.h"

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

  /** Looks for ways around forbidden airspace as well: a way of its own for each pair whose straight line meets one that it can not
   *  pass below with room. Going through stays cheaper than no way: the way out for targets inside. @errors Cancelled */
  Result<void> findAround(const ForbiddenAirspace& forbidden, const landing::AltitudeFloor& floor, const landing::World& world,
                          const std::vector<geo::Point>& targets, double ceiling, const Job& job);

  /** Poses to pass between two targets if the direct leg is barred; nothing if the straight line is free or no way exists. */
  [[nodiscard]] const std::vector<geo::Pose>& between(int from, int to) const;

  /** Poses to pass around forbidden airspace; nothing if the straight line is free of it or no way exists. */
  [[nodiscard]] const std::vector<geo::Pose>& aroundAirspace(int from, int to) const;
  [[nodiscard]] bool hasAny(int from, int to) const { return !between(from, to).empty() || !aroundAirspace(from, to).empty(); }

private:
  using Ways = std::vector<std::vector<geo::Pose>>;

  [[nodiscard]] const std::vector<geo::Pose>& wayOf(const Ways& ways, int from, int to) const;

  std::size_t count_ = 0;
  Ways poses_;   ///< count_ * count_, empty if nothing is barred
  Ways around_;  ///< the same of airspace
};

}  // namespace vp::tour
