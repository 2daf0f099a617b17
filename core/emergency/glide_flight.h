#pragma once

#include "core/flight/dubins.h"
#include "core/landing/approach.h"
#include "core/landing/world.h"
#include "core/mission/landing_path.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace vp::emergency {

/** Flies glides forwards: from where the aircraft is, down, with the altitudes that it has at least in the winds that cost it most.
 *
 *  A leg is as steep as the dearest metre on it: in wind turns are cut at every few degrees of course, and where losses differ by altitude legs
 *  end at the edges of bands. So who is on such a path can stay on it or is above it, whichever wind blows (WHY.md, "Altitudes").
 *  @threads const members are pure; the world outlives it */
class GlideFlight {
public:
  /// Where a glide does not stay clear of the ground [m MSL].
  static constexpr double kTouches = -std::numeric_limits<double>::infinity();

  explicit GlideFlight(const landing::World& world) : world_(&world) {}

  /** Altitude after a Dubins glide that begins at `altitude` [m MSL]; kTouches if it comes closer to the ground than the clearance, or
   *  over ground of unknown height.  @param radius  index of the path's radius in GlideModel::glideRadii() */
  [[nodiscard]] double endOf(const flight::DubinsPath& path, std::size_t radius, double altitude) const;

  /** The same for any pieces of straights and of turns with the radii of glides; appends the legs.
   *  @param legs  null: not wanted   @param pose  becomes the end */
  double fly(geo::Pose& pose, double altitude, const std::vector<flight::Piece>& pieces, std::vector<mission::LandingLeg>* legs) const;

  /** The approach of a site from its gate, by its chosen slope if there is one; appends the legs. Nothing is asked of the ground: who is at the
   *  gate at Approach::altitude or higher has been promised that (landing::approachTo), and the checker looks again.
   *  @return altitude at the touchdown point [m MSL] */
  double flyApproach(const landing::Approach& approach, double altitude, std::vector<mission::LandingLeg>& legs) const;

private:
  template <typename Use>
  double descend(geo::Pose& pose, double altitude, const flight::Piece& piece, Use use) const;
  [[nodiscard]] bool isClear(const geo::Pose& from, const flight::Piece& part, double altitude, double end) const;

  const landing::World* world_;
};

/** The approach of a site, as high as it must begin when flown in legs: as landing::approachTo, raised by what its curve loses more where each leg is
 *  as steep as its dearest metre (decimetres for a circle in wind). All that plans landings or tells height in hand counts from it.
 *  @errors as landing::approachTo   @threads pure */
Result<landing::Approach> approachInLegs(const landing::World& world, std::size_t site);

}  // namespace vp::emergency
