#pragma once

#include "core/mission/landing_path.h"
#include "core/mission/mission.h"
#include "core/mission/plan.h"
#include "core/safety/checker.h"
#include "core/terrain/elevation_grid.h"

#include <memory>
#include <vector>

namespace vp::safety {

/** What a landing path is judged against. */
struct LandingInput {
  const mission::Mission& mission;
  const std::vector<mission::SiteInFrame>& sites;  ///< that LandingPath::site counts in
  geo::LatLon frameOrigin;                         ///< of the frame of path, sites and terrain
  const terrain::ElevationGrid& terrain;           ///< as check() takes it
};

/** What was found about one landing path. */
struct LandingReport {
  std::vector<Finding> findings;
  std::vector<mission::Margin> margins;  ///< glide.clearance and glide.arrival, as far as they were reached
  bool reachesRunway = false;            ///< the path names a site

  /** It can be flown as it is planned, clear of the ground: no finding is Violated or Unknown. */
  [[nodiscard]] bool isFlyable() const;
  /** The same, down to a runway that may be landed on. Never of a path without a site. */
  [[nodiscard]] bool isSafe() const { return reachesRunway && isFlyable(); }
};

/** Judges one path down to a runway, or to where it ends, by the checker's own integration, losses and terrain walk: WHY.md section 15.
 *
 *  - glide.radius: every turn is one that a glide may fly in the strongest wind.
 *  - landing.slope: no part of a leg is flatter than the greatest loss there, of all winds and airspeeds of its altitudes: who is on the path can
 * stay on it. No leg is steeper than the steepest descent of the profile with the wind behind, or, where that is more, than the greatest
 *    loss on the leg times 1.001; where the profile names none, times 1.5.
 *  - glide.clearance, terrain.unknown: the altitudes of the path keep the clearance above every touched cell; on the last part of an approach
 *    with an obstacle surface, what that asks for.
 *  - With a site: glide.site, glide.heading, glide.arrival (5 cm, 1e-3 rad, elevation + arrival margin), approach.straight, .circle and .key,
 *    site.position, .data, .excluded, site.length, all as for the glides of a plan (README.md).
 *  - plan.number, plan.index, plan.piece, aircraft.profile, settings, wind.data, terrain.grid: what cannot be judged is violated or unknown.
 *  Nothing is asked about reaction: the engine has stopped before the path begins, whose first leg may turn at once.
 *  @threads pure   @cost O(c log c) for c crossed grid lines; in wind 0.3 to 3 us for each eighth of a degree turned, in each band of altitudes that
 *  it is turned in */
LandingReport checkLanding(const LandingInput& input, const mission::LandingPath& path);

/** The same for many paths of one mission: what losses on circles were worked out for one path serves the others, and the mission is looked at once.
 * Every report is that of checkLanding, but that numbers of a mission found sound are not looked at again.
 *  @threads check: many at once, each with what it works out to itself until it is done */
class LandingChecker {
public:
  /** @pre what the input refers to outlives this, unchanged */
  explicit LandingChecker(const LandingInput& input);
  ~LandingChecker();
  LandingChecker(const LandingChecker&) = delete;
  LandingChecker& operator=(const LandingChecker&) = delete;

  [[nodiscard]] LandingReport check(const mission::LandingPath& path) const;

private:
  struct Shelf;
  LandingInput input_;
  std::unique_ptr<Shelf> shelf_;
};

}  // namespace vp::safety
