#pragma once

#include "core/aircraft/glide_model.h"
#include "core/base/job.h"
#include "core/flight/curve.h"
#include "core/mission/mission.h"
#include "core/safety/glide_rates.h"
#include "core/safety/last_part.h"
#include "core/terrain/elevation_grid.h"

#include <optional>
#include <vector>

namespace vp::safety {

class CellWalk;

/** What one glide does over the terrain, as integrated by the checker. */
struct GlideExamination {
  geo::Pose end;
  double length = 0.0;                  ///< m over ground
  double loss = 0.0;                    ///< m of height, whole glide
  double clearanceStart = 0.0;          ///< m MSL, lowest start height that keeps the clearance everywhere; infinity where unknown
  geo::Point clearanceAt;               ///< where clearanceStart is decided
  double clearanceGround = 0.0;         ///< m MSL, ground there
  double clearanceAsked = 0.0;          ///< m, clearance asked for there
  double lossToGate = 0.0;              ///< m of height, up to the last part
  double gateStart = 0.0;               ///< m MSL, lowest height at the gate that keeps the clearance on the last part; -infinity without one
  std::optional<geo::Point> unknownAt;  ///< first place over unknown ground
};

/** Flies a glide piece by piece, in the worst of all winds at every place of it, its last part as the approach has it. Stops early, with a useless
 *  result, when the job is asked to stop.
 *  @pre all pieces are integrable (ground_path.h); the walk is over the terrain of the plan */
GlideExamination examineGlide(const geo::Pose& start, const SplitGlide& pieces, double clearance, GlideRates& rates, CellWalk& walk, const Job& job);

/** The same without a last part: the whole clearance everywhere. */
GlideExamination examineGlide(const geo::Pose& start, const std::vector<flight::Piece>& pieces, double clearance, GlideRates& rates, CellWalk& walk,
                              const Job& job);

/** A_w: the lowest height at `start` from which this glide keeps `clearance` above every touched terrain cell and arrives at
 *  or above `arrivalHeight` (site elevation + arrival margin):
 *    max( arrivalHeight + loss(whole glide), max over points p of [ terrain(p) + clearance + loss(start to p) ] )
 *  exactly as the checker uses it; loss: the greatest in any wind of `rates`, upper bound within 0.1 % in turns, exact in calm air; exact for the
 * closed cells within 4 um of the path, never below that.
 *  @return m MSL; infinity if the glide touches unknown ground, no glide exists in one of its turns, or a piece is not
 *  integrable. Does not ask where the glide ends or which radii the aircraft may use: check() does.
 *  @pre terrain cell size >= 0.1 m   @threads one GlideRates per thread   @cost O(c log c) for c crossed grid lines
 *  @source DESIGN section 2, "Safe altitude" */
double requiredStartHeight(const geo::Pose& start, const std::vector<flight::Piece>& pieces, double arrivalHeight,
                           const terrain::ElevationGrid& terrain, double clearance, GlideRates& rates);

/** The lowest height at a decision point whose glide this is, as the mission has it: the above with its clearance, its arrival margin and its
 *  approach, and its reaction loss on top. @return the same; infinity also if the glide does not end in such an approach   @pre the settings of the
 * mission are sound (README.md) */
double requiredStartHeight(const geo::Pose& start, const std::vector<flight::Piece>& pieces, const mission::LandingSite& site,
                           const mission::Mission& mission, const terrain::ElevationGrid& terrain, GlideRates& rates);

/** The same in still air. @pre model.isCalm() */
double requiredStartHeight(const geo::Pose& start, const std::vector<flight::Piece>& pieces, double arrivalHeight,
                           const terrain::ElevationGrid& terrain, double clearance, const aircraft::GlideModel& model);

}  // namespace vp::safety
