#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/landing/rrt_star.h"
#include "core/landing/tree_roadmap.h"
#include "core/landing/world.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace vp::landing {

/// A margin that is negative only by so much is none at all [m]: rounding, as the checker allows it.
inline constexpr double kMarginTolerance = 1e-3;

/** What it takes to reach one runway from a pose, if no other counted. Heights m MSL, lengths m. */
struct SiteAnswer {
  int site = -1;                                                    ///< index into World::sites: the end of the runway that needs the least height
  double altitude = 0.0;                                            ///< lowest height from which `pieces` clears the ground and arrives
  double margin = 0.0;                                              ///< height asked about minus `altitude`; negative: so much is missing
  double directAltitude = std::numeric_limits<double>::infinity();  ///< the same for the best single curve to this runway
  std::vector<flight::Piece> pieces;
  double length = 0.0;   ///< over ground
  double seconds = 0.0;  ///< to the touchdown point at best glide speed, surplus height not counted
  [[nodiscard]] bool isReachable() const { return margin >= -kMarginTolerance; }
  /** True if only a detour keeps the glide clear of the ground from the height asked about. */
  [[nodiscard]] bool isAroundTerrain() const { return isReachable() && directAltitude > altitude + margin + kMarginTolerance; }
};

/** Landing glides to each runway by itself: the next-best runways of a pose, and what would be missing if one were closed.
 *
 *  A runway here is the physical strip: both of its ends, paired by airport, opposite course and least distance between
 *  their centre lines; closing it closes both. Each runway gets a roadmap of its own when it is first needed, and keeps it.
 *  @threads every member may be called from many threads; one at a time builds and answers, the others wait */
class SiteRoadmaps {
public:
  /** @param world  never null; its sites are the ones that answers refer to
   *  @param options  area, samples and seed of each runway's roadmap */
  SiteRoadmaps(std::shared_ptr<const World> world, RrtStarOptions options);

  [[nodiscard]] const World& world() const { return *world_; }
  /** Sites of each runway, indices into World::sites. */
  [[nodiscard]] const std::vector<std::vector<int>>& runways() const { return runways_; }
  /** Index into runways() of a site. */
  [[nodiscard]] int runwayOf(int site) const { return runwayOfSite_[static_cast<std::size_t>(site)]; }

  /** The runways that need the least height from a pose, one answer each, in ascending order of that height.
   *  Runways are built nearest first, and only while elevation + distance * straight glide, which no glide can beat,
   *  leaves them a chance to be among the answers; so nothing that is left out would have come before the last answer.
   *  @param altitude  height of the aircraft [m MSL]   @param most  number of answers wanted
   *  @errors Cancelled (what was built whole stays)   @cost one roadmap per runway met for the first time, then some 0.1 ms each */
  Result<std::vector<SiteAnswer>> alternatives(const geo::Pose& from, double altitude, int most, const Job& job);

  /** Number of runways that have a roadmap by now. */
  [[nodiscard]] std::size_t builtCount() const;

private:
  struct Built {
    World world;
    TreeRoadmap roadmap;
    bool hasGlides = false;
  };
  [[nodiscard]] double boundTo(std::size_t runway, const geo::Pose& from) const;
  Result<const Built*> built(std::size_t runway, const Job& job);
  [[nodiscard]] std::optional<SiteAnswer> answerOf(std::size_t runway, const Built& built, const geo::Pose& from, double altitude);
  void pairEnds();

  std::shared_ptr<const World> world_;
  RrtStarOptions options_;
  std::vector<std::vector<int>> runways_;
  std::vector<int> runwayOfSite_;
  mutable std::mutex mutex_;
  std::vector<std::unique_ptr<const Built>> built_;  ///< by runway; null: not needed yet
  QueryScratch scratch_;
};

}  // namespace vp::landing
