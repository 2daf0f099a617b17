#pragma once

#include "core/landing/approach.h"
#include "core/landing/rolling.h"
#include "core/landing/world.h"

#include <optional>
#include <vector>

namespace vp::landing {

/** What a glide asks for at its start. m MSL, E (World::reactionLoss) included; infinite over unknown ground. */
struct GlideNeed {
  double altitude = 0.0;  ///< lowest from which it clears the ground and arrives: what a roadmap calls A
  /** Lowest from which it is still above the ground, wherever the whole clearance is asked for, when it has lost what rolling may cost until there;
   * minus infinity where rolling is not counted. Rolling so comes out of the clearance, and asks for more height only where it is more. */
  double withRolling = 0.0;

  [[nodiscard]] double lowest() const { return altitude > withRolling ? altitude : withRolling; }
};

/** A glide in three parts: what is flown until the pilot has reacted, the way, the approach. */
struct GlideParts {
  std::vector<flight::Piece> reaction;
  std::vector<flight::Piece> way;
  Approach approach;
};

/** Says what glides ask for that are given as pieces, whatever found them, and what rolling costs them.
 *  @threads const members are pure */
class GlideNeeds {
public:
  /** @param world     outlives this
   *  @param onlySite  that will be asked about, by its index in World::sites; none: all
   *  @cost some 0.1 ms for each site */
  explicit GlideNeeds(const World& world, std::optional<int> onlySite = {});

  /** The parts of a glide to a site. @return nothing if it is shorter than reaction and approach, or the site has no approach */
  [[nodiscard]] std::optional<GlideParts> partsOf(const std::vector<flight::Piece>& glide, int site) const;

  /** Heights needed at the beginnings of pieces flown one after the other from a pose, and at their end [m MSL], without E; one more than pieces.
   *  @param end  m MSL, at their end   @pre every radius is one of the glide's or the tour's, else infinity */
  [[nodiscard]] std::vector<double> heightsAlong(const geo::Pose& from, const std::vector<flight::Piece>& pieces, double end) const;

  /** @param tour  the piece that the tour comes to the pose on: rolling begins in its bank */
  [[nodiscard]] GlideNeed of(const geo::Pose& from, const GlideParts& glide, const flight::Piece& tour) const;

  [[nodiscard]] const Rolling& rolling() const { return rolling_; }

  /** Index of a radius as flight::turnLossAt wants it; any for straight pieces; none if no glide has that radius. */
  [[nodiscard]] std::optional<std::size_t> indexOf(const flight::Piece& piece) const;

private:
  [[nodiscard]] double before(const geo::Pose& from, const flight::Piece& piece, double clearance, double end) const;

  const World& world_;
  Rolling rolling_;
  std::vector<double> radii_;                        ///< of the glides, then the tour's
  std::vector<std::optional<Approach>> approaches_;  ///< by site
};

}  // namespace vp::landing
