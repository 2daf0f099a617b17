#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/fetch/tile.h"

#include <string>
#include <vector>

namespace vp::fetch {

/** What is to be said wherever the terrain is shown or handed on. Source: licence of the Copernicus DEM. */
inline constexpr const char* kTerrainCredit =
    "(c) DLR e.V. 2010-2014 and (c) Airbus Defence and Space GmbH 2014-2018 provided under COPERNICUS by the European Union and ESA; all rights "
    "reserved";

/** A tile's file, as the area is cut from. */
struct TileFile {
  TileId tile;
  std::string path;
  std::string kind;  ///< "terrain", "ocean" or "unknown"
};

/** Cuts an area out of tiles and joins it into one GeoTIFF per spacing of posts: heights are copied post by post and never
 *  resampled. The area is grown to the posts around it, where the tiles reach so far. Where tiles of different spacing meet (at 50,
 *  60, 70, 80, 85 degrees), the coarser file is continued by a kilometre over the finer one, each post there the highest of the finer
 *  posts within one step, so that no gap of unknown ground is left and no height between is lost.
 *  @param output  file to write; further ones for other spacings are called NAME-2.tif, NAME-3.tif
 *  @return the files written, the one nearest to the first tile first
 *  @errors BadFile, OutputFailed, Cancelled   @cost 13 million posts in about 2 s */
Result<std::vector<std::string>> cutArea(const std::vector<TileFile>& tiles, const geo::GeoBox& area, const std::string& output, const Job& job);

}  // namespace vp::fetch
