#pragma once

#include "core/base/result.h"
#include "core/mission/route.h"
#include "core/route/altitudes.h"
#include "core/route/build_route.h"
#include "core/route/corners.h"
#include "core/route/fly_by.h"
#include "core/route/track.h"

#include <vector>

namespace vp::route {

/** Distances of corners along the path, ascending from the first that is passed. */
struct Knots {
  std::vector<std::size_t> corner;
  std::vector<double> distance;
};

/** Both ways between tour and path: what the path must not be below, and how far it is aside. */
struct Comparison {
  std::vector<Required> required;
  double lateral = 0.0;
};

/** Waypoints of the closed tour where they will be and the path that they give, before altitudes. */
struct Layout {
  std::vector<Corner> corners;
  std::vector<geo::LatLon> places;
  FlownPath path;
  Track track;
  Knots knots;
  std::vector<double> visits;  ///< m along the path at which each corner's target is passed; -1 for corners without one
  Comparison comparison;
  mission::Route route;  ///< figures of the layout alone
};

/// Waypoints closer than this are one place [m]. Where places are coarse, a short leg between two of them points anywhere, so longer ones are tried,
/// too.
inline constexpr double kLeastLegs[] = {0.5, 6.0, 15.0, 30.0};
/// Shares of the limits that are tried, one after the other.
inline constexpr double kLiberties[] = {1.0, 0.9, 0.8, 0.65, 0.5, 0.35, 0.2, 0.1, 0.05};
inline constexpr double kMatchError = 0.05;  // m of altitude, for the chords that two paths are compared on

/// Steps that places are moved before they are rounded.
struct Shift {
  double north = 0.0;
  double east = 0.0;
};
/// To the nearest, and where that leads into forbidden airspace or over unknown ground to one side: another rounding gives short legs another
/// direction.
inline constexpr Shift kShifts[] = {{0.0, 0.0}, {0.4, 0.4}, {0.4, -0.4}, {-0.4, 0.4}, {-0.4, -0.4}, {0.4, 0.0}, {-0.4, 0.0}, {0.0, 0.4}, {0.0, -0.4}};

/** Moves corners to where the file will say that they are; those nearer than `leastLeg` to the one before are left out. */
void roundPlaces(const geo::LocalFrame& frame, double steps, double leastLeg, std::vector<Corner>& corners, std::vector<geo::LatLon>& places,
                 Shift shift = {});

/** @param start  m along the flown path at which the tour begins */
Comparison compare(const Track& tour, const Track& flown, const std::vector<double>& marks, double start);

/** The same for open ways that begin and end together. @param marks  ascending */
Comparison compareWays(const Track& way, const Track& flown, const std::vector<double>& marks);

/** Few corners are better, but not where turns then follow each other so closely that the path leaves the tour: fewer liberties
 *  are tried until it stays within what the options allow, out of every forbidden airspace that the tour keeps beside, and off ground of unknown
 *  height; else the nearest path counts, one that stays out before all others. @param world  null: nothing is known of the ground
 *  @errors as flyAround */
Result<Layout> bestLayout(const mission::Plan& plan, const geo::LocalFrame& frame, const Track& tour, const landing::World* world,
                          const RouteOptions& options);

}  // namespace vp::route
