#pragma once

#include "core/base/result.h"
#include "core/formats/named_fields.h"
#include "core/geo/local_frame.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::formats {

/** A place of a geometry. */
struct GeoPlace {
  geo::LatLon position;
  std::optional<double> height;  ///< third coordinate, as written
};

/** One geometry of a GeoJSON text with the properties of its feature. */
struct GeoFeature {
  enum class Kind { None, Point, Line, Polygon };
  Kind kind = Kind::None;
  std::vector<GeoPlace> places;              ///< of a polygon its outer ring, without the last place that is the first again
  std::vector<std::vector<GeoPlace>> holes;  ///< of a polygon
  FieldValues values;                        ///< properties that `names` knows
  std::size_t line = 1;                      ///< of the file, where the feature begins
  std::string fault;                         ///< why kind is None
};

/** Features of a GeoJSON text (FeatureCollection, Feature, or a bare geometry; multi-geometries and collections come apart
 *  into one feature each). A feature that cannot be used has kind None and its reason.
 *  @errors BadFile; BadFormat - no JSON, no GeoJSON   @source RFC 7946 */
Result<std::vector<GeoFeature>> readGeoFeatures(const std::string& path, const FieldNames& names);

}  // namespace vp::formats
