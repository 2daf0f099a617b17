#pragma once

#include "core/flight/piece_loss.h"
#include "core/flight/pose_pair.h"
#include "core/landing/world.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace vp::landing {

/** Lowest height at the start of a piece of glide from which it clears the ground and ends at `endHeight` or higher:
 *  max( endHeight + loss(piece), max over its points p of terrain(p) + clearance + loss(start to p) ).
 *
 *  An upper bound for the whole curve, not for samples of it: the piece is halved until the box around a part is
 *  under the bound found so far, or half a cell long and asked cell by cell; the loss to the end of the part is charged
 *  for all of it. Every cell that comes within a millimetre of the curve counts, so rounding cannot step over a grid line.
 *  @param lossPerMetre  height lost per metre of the piece; 0 gives terrain clearance alone
 *  @param giveUpAbove   returns infinity as soon as the result must exceed this
 *  @return m MSL; infinity over unknown ground
 *  @source DESIGN section 2, "Safe altitude"; [1] Algorithm 1 line 11 has max[T_alt, A + H], which charges no loss up
 *  to the highest point and is not safe over rising ground */
double requiredStartHeight(const terrain::TerrainPyramid& terrain, const geo::Pose& start, const flight::Piece& piece, double lossPerMetre,
                           double clearance, double endHeight, double giveUpAbove = std::numeric_limits<double>::infinity());

/** The same where a metre of the piece need not lose as much as another. @param loss  of this piece */
double requiredStartHeight(const terrain::TerrainPyramid& terrain, const geo::Pose& start, const flight::Piece& piece, const flight::PieceLoss& loss,
                           double clearance, double endHeight, double giveUpAbove = std::numeric_limits<double>::infinity());

/** The same for a whole Dubins glide; `losses` are the aircraft's at the path's radius. */
double requiredStartHeight(const World& world, const flight::DubinsPath& path, flight::TurnLoss losses, double endHeight,
                           double giveUpAbove = std::numeric_limits<double>::infinity());

/** The same where the direction of the path's start is known already. */
double requiredStartHeight(const World& world, const flight::DubinsPath& path, flight::Direction direction, flight::TurnLoss losses, double endHeight,
                           double giveUpAbove);

/** The same by the losses at the altitudes of the glide. @param radius  index of the path's radius in GlideModel::glideRadii() */
double requiredStartHeight(const World& world, const flight::DubinsPath& path, flight::Direction direction, std::size_t radius, double endHeight,
                           double giveUpAbove);

/** The same on a straight piece; without giving up. */
double requiredOverStraight(const World& world, const geo::Pose& start, double length, double endHeight);

/** Upper bound of the terrain under the whole piece [m MSL]; infinity over unknown ground. */
double maxTerrainAlong(const terrain::TerrainPyramid& terrain, const geo::Pose& start, const flight::Piece& piece);

}  // namespace vp::landing
