#pragma once

#include "core/mission/plan.h"

#include <string>
#include <vector>

namespace vp::formats::exports {

/** Landing sites that the glides of a plan lead to, those that more points need first. */
std::vector<const mission::SiteInFrame*> diversionSites(const mission::Plan& plan);

/** The same, one site for each airfield. */
std::vector<const mission::SiteInFrame*> diversionAirfields(const mission::Plan& plan);

/** A point of a glide. */
struct GlidePoint {
  geo::LatLon place;
  double altitude = 0.0;  ///< m MSL
};

/** The glide after an engine failure at a decision point. */
struct DrawnGlide {
  std::vector<GlidePoint> points;
  int site = -1;
  double margin = 0.0;   ///< m of altitude over the least from which it arrives
  double arrival = 0.0;  ///< m MSL over the touchdown point
};

/** Empty if the point has no glide. @param index  into Plan::tour   @param error  m that chords may be beside arcs */
DrawnGlide drawnGlide(const mission::Plan& plan, std::size_t index, double error);

}  // namespace vp::formats::exports
