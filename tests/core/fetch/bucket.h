#pragma once
// A bucket of small terrain tiles for tests.

#include "core/fetch/terrain_fetch.h"
#include "core/fetch/tile.h"
#include "tests/support/file_server.h"

#include <QTemporaryDir>

#include <functional>
#include <string>
#include <vector>

namespace vp::fetch::test {

/** Bytes of a GeoTIFF in the lattice that a tile has, thinned: post (c, r) at west + c / columns, south + 1 - r / rows.
 *  @param isNoise  uncompressed and long, for tests of broken downloads */
std::string tileBytes(TileId tile, int columns, int rows, const std::function<float(double latitude, double longitude)>& height);

/** Heights that differ from post to post, whole metres. */
float wavyHeight(double latitude, double longitude);

/** Puts tiles and the list of them on a server. */
void stock(vp::test::FileServer& server, const std::vector<TileId>& tiles, int columns = 60, int rows = 60);

/** Reads one post of a raster at a place; throws if there is none. */
float postAt(const std::string& path, double latitude, double longitude);

struct RasterFacts {
  int columns = 0;
  int rows = 0;
  double stepX = 0.0;
  double stepY = 0.0;
  double west = 0.0;   ///< of the first post
  double north = 0.0;  ///< of the first post
  std::string kind;    ///< VOLPLANE_KIND of the band
  std::string sea;     ///< VOLPLANE_OCEAN_TILES
};
RasterFacts factsOf(const std::string& path);

/** A request to a server with short patience and a cache in a folder. */
TerrainRequest requestFor(const vp::test::FileServer& server, const QTemporaryDir& folder, const geo::GeoBox& area);

/** Estimate and fetch in one. */
Result<FetchedTerrain> fetchAll(const TerrainRequest& request, const std::string& output, const Job& job = Job{});

/** Names of the files below a folder, sorted. */
std::vector<std::string> filesUnder(const std::string& folder);

}  // namespace vp::fetch::test
