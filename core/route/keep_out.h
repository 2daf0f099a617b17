#pragma once

#include "core/mission/plan.h"
#include "core/route/track.h"

#include <vector>

namespace vp::route {

/** The forbidden airspaces of a mission that a path keeps beside. Heights do not count here: an airspace that the path passes
 *  over or under is left out, and whether its waypoints do so is the checker's to say. */
class KeepOut {
public:
  /** @param path  the tour, or a way from or to home */
  KeepOut(const mission::Plan& plan, const Track& path);

  /** Whether a path comes nearer to one of them than the chords of a track may deceive.   @cost O(chords near them * corners) */
  [[nodiscard]] bool isEnteredBy(const Track& flown) const;

private:
  struct Outline {
    std::vector<geo::Point> corners;
    geo::Box box;
    [[nodiscard]] bool contains(geo::Point point) const;
    [[nodiscard]] bool isTouchedBy(geo::Point a, geo::Point b) const;
    [[nodiscard]] bool isTouchedBy(const Track& track) const;
  };
  std::vector<Outline> outlines_;
};

}  // namespace vp::route
