#pragma once

#include "core/aircraft/glide_model.h"
#include "core/base/job.h"
#include "core/flight/curve.h"
#include "core/mission/mission.h"
#include "core/safety/glide_rates.h"
#include "core/safety/last_part.h"
#include "core/terrain/elevation_grid.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

namespace vp::safety {

class CellWalk;

/** A glide to be examined, and what is asked of it. */
struct GlideQuery {
  geo::Pose start;
  std::optional<double> altitude;  ///< m MSL at the start; none: only the lowest starts are asked for
  double clearance = 0.0;          ///< m, but for what the last part says
  double arrival = 0.0;            ///< m MSL, at least so high at its end
  std::optional<double> key;       ///< m MSL, at least so high at its gate
  std::vector<double> rollCosts;   ///< m, of rolling up to and on each piece of the glide (roll_cost.h); empty: not asked for
};

/** What rolling may have cost at the end of a piece [m]; 0 where it is not asked for. */
double rollCostOf(const GlideQuery& query, std::size_t piece);

/** What a mission asks of the glide of a decision point to a site, its reaction loss aside: arrival margin, clearance and high key.
 *  @param altitude  m MSL, after that loss */
GlideQuery queryOf(const geo::Pose& start, std::optional<double> altitude, const mission::LandingSite& site, const mission::Mission& mission);

/** What one glide does over the terrain, as integrated by the checker. */
struct GlideExamination {
  geo::Pose end;
  double length = 0.0;  ///< m over ground
  // Lowest start heights [m MSL].
  double arrivalStart = 0.0;            ///< that arrives high enough
  double keyStart = 0.0;                ///< that passes the high key high enough; -infinity without one
  double clearanceStart = 0.0;          ///< that keeps the clearance everywhere; infinity where unknown
  double gateLowest = 0.0;              ///< m MSL, lowest height at the gate from which the rest works, key included; without a gate at the end
  std::optional<geo::Point> unknownAt;  ///< first place over unknown ground
  // From the altitude that the query gives [m MSL]; within the altitude tolerance of a lowest start nothing is missing.
  double arrival = 0.0;        ///< m MSL at its end
  double atGate = 0.0;         ///< m MSL at its gate
  double clearanceLeft = 0.0;  ///< m beyond the clearance asked for, least; where:
  geo::Point clearanceAt;
  double clearanceGround = 0.0;  ///< m MSL, ground there
  double clearanceAsked = 0.0;   ///< m, clearance asked for there
  double aboveGround = 0.0;      ///< m, least height above the ground wherever the whole clearance is asked for
  // Where costs of rolling are given, wherever the whole clearance is asked for.
  double rollingStart = -std::numeric_limits<double>::infinity();  ///< m MSL, lowest start that is above the ground there, having lost these too
  double afterRolling = 0.0;  ///< m, from the altitude given: least height above the ground less what rolling may have cost until there; where:
  geo::Point afterRollingAt;
  double rollCostThere = 0.0;  ///< m

  [[nodiscard]] double lowestStart() const { return std::max({arrivalStart, clearanceStart, keyStart}); }
  /** The same that also has what rolling may cost. */
  [[nodiscard]] double requiredStart() const { return std::max(lowestStart(), rollingStart); }
};

/** Flies a glide piece by piece, losing the most that any wind and air of each altitude make it lose at every place, its last part as the approach
 *  has it. Stops early, with a useless result, when the job is asked to stop.
 *  @pre all pieces are integrable (ground_path.h); the walk is over the terrain of the plan */
GlideExamination examineGlide(const GlideQuery& query, const SplitGlide& pieces, GlideRates& rates, CellWalk& walk, const Job& job);

/** A_w: the lowest height at `start` from which this glide keeps `clearance` above every touched terrain cell and arrives at
 *  or above `arrivalHeight` (site elevation + arrival margin):
 *    max( arrivalHeight + loss(whole glide), max over points p of [ terrain(p) + clearance + loss(start to p) ] )
 *  exactly as the checker uses it; loss: the greatest in any wind and at any airspeed that `rates` has at the altitude where it is lost, going back
 *  from the end or from p (WHY.md section 12); upper bound within 0.1 % in turns, exact in calm air; exact for the
 *  closed cells within 4 um of the path, never below that.
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
