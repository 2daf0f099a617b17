#pragma once

#include "core/geo/local_frame.h"

namespace vp::geo {

/** A closed box of latitude and longitude, degrees. southWest.longitude_deg > northEast.longitude_deg means that it
 *  crosses the 180th meridian. */
struct GeoBox {
  LatLon southWest;
  LatLon northEast;

  [[nodiscard]] bool contains(LatLon place) const {
    if (place.latitude_deg < southWest.latitude_deg || place.latitude_deg > northEast.latitude_deg) {
      return false;
    }
    const bool eastOfWest = place.longitude_deg >= southWest.longitude_deg;
    const bool westOfEast = place.longitude_deg <= northEast.longitude_deg;
    return southWest.longitude_deg <= northEast.longitude_deg ? eastOfWest && westOfEast : eastOfWest || westOfEast;
  }
  bool operator==(const GeoBox&) const = default;
};

}  // namespace vp::geo
