#pragma once

#include "core/mission/plan.h"

#include <string>

namespace vp::formats {

/** The plan as a GeoJSON FeatureCollection for GIS programs: tour, spirals, decision points, the glide from each of
 *  them, targets and landing sites (property "kind" tells which). Positions are [longitude, latitude, metres above
 *  MEAN SEA LEVEL]; RFC 7946 means heights above the ellipsoid, so every feature repeats its height as alt_msl_m and
 *  alt_msl_ft and the collection says so.
 *  @accuracy 7 decimals (1 cm); arcs are drawn as chords at most 0.5 m off.  @source RFC 7946 */
std::string toGeoJson(const mission::Plan& plan);

}  // namespace vp::formats
