#pragma once

#include "core/base/result.h"
#include "core/geo/geo_box.h"

#include <string>
#include <vector>

namespace vp::fetch {

/** A tile of Copernicus GLO-30: one degree by one, named by its south-west corner. */
struct TileId {
  int south = 0;  ///< degrees, -90 to 89
  int west = 0;   ///< degrees, -180 to 179
  bool operator==(const TileId&) const = default;
};

/** Where the public bucket is. @source registry.opendata.aws/copernicus-dem (bucket and names of the tiles) */
inline constexpr const char* kTerrainServer = "https://copernicus-dem-30m.s3.amazonaws.com";

/// Most tiles in one request: together they stay below the 300 million posts that the terrain reader joins.
inline constexpr int kMostTiles = 20;

/** "Copernicus_DSM_COG_10_N46_00_E008_00_DEM" */
std::string nameOf(TileId tile);

/** "N46E008" */
std::string shortNameOf(TileId tile);

/** BASE/NAME/NAME.tif */
std::string urlOf(const std::string& base, TileId tile);

/** Posts along a parallel: 3600 up to 50 degrees of latitude, fewer towards the poles; along a meridian always 3600.
 *  @source Copernicus DEM Product Handbook, GEO1988-CopernicusDEM-SPE-002, table of longitudinal spacings */
int columnsOf(TileId tile);

/** Whether the absence of this tile says nothing about the sea: Armenia and Azerbaijan were left out of the public edition.
 *  @source Copernicus DEM Product Handbook, GLO-30 Public; the box is theirs, generously */
bool isWithheld(TileId tile);

/** Tiles under a box, north to south and west to east; a box that ends on a full degree does not reach into the next tile.
 *  @errors OutOfRange - the box is no box, crosses the 180th meridian, or covers more than kMostTiles */
Result<std::vector<TileId>> tilesUnder(const geo::GeoBox& box);

/** Box around a place that holds a circle. @errors OutOfRange - radius not in 0.1 to 300 km, or a pole inside */
Result<geo::GeoBox> boxAround(geo::LatLon place, double radius_m);

}  // namespace vp::fetch
