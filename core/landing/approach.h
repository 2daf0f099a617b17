#pragma once

#include "core/base/result.h"
#include "core/landing/world.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace vp::landing {

/** The last part of every glide to a site, as World::approach asks: what roadmaps and bounds of the safe altitude begin with. */
struct Approach {
  int site = -1;                      ///< index into World::sites
  geo::Pose gate;                     ///< where it begins; the touchdown point with ApproachKind::Threshold
  double altitude = 0.0;              ///< m MSL: lowest at the gate from which it clears the ground and arrives
  std::vector<flight::Piece> pieces;  ///< from the gate to the touchdown point
  std::optional<mission::Hold> hold;  ///< over the gate, the lowest there is; if World::approach asks for one
};

/** Where the approach of a site begins: on the landing course before the touchdown point, or at it. */
geo::Pose gateOf(const mission::ApproachSettings& settings, const mission::SiteInFrame& site);

/** The approach of a site.
 *
 *  Straight: on the landing course, as steep as was chosen or as the glide is in the wind that costs it most. Overhead: the circle, left or
 *  right and of one of the glide's radii, that needs the least height. The ground under it is bounded in steps of two metres (ten where it is 20 km
 * long), each with the clearance at its beginning and the loss at its end, so the altitude is an upper bound, some 0.3 m above the exact one.
 *  @errors NoLandingSite - the site cannot have this approach: ground of unknown height, a slope that the aircraft cannot hold, no known
 *  ground for a hold; the sentence names the site and why, without a final stop   @threads pure   @cost some 0.1 ms
 *  @param number  index into World::sites */
Result<Approach> approachTo(const World& world, std::size_t number);

/** The approaches of all sites that can have one, in their order. */
std::vector<Approach> approachesOf(const World& world);

/** Why the sites without an approach have none, a sentence for each (see approachTo). */
std::vector<std::string> approachFaults(const World& world);

/** What to say where no site has an approach. @errors always: NoLandingSite */
Error noApproach(const World& world);

/** A glide behind a way to its beginning, pieces that are one turn joined; not with an overhead circle, which stays a piece of its own. */
std::vector<flight::Piece> joinedGlide(const World& world, std::vector<flight::Piece> way, const std::vector<flight::Piece>& glide);

/** Plan::holds: that of each site which a glide of the plan ends at; none where no hold is asked for.
 *  @pre the glides of the plan end at sites that have their approach in this world */
void setHolds(const World& world, mission::Plan& plan);

}  // namespace vp::landing
