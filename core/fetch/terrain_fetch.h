#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/fetch/http.h"
#include "core/fetch/tile_store.h"
#include "core/geo/geo_box.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vp::fetch {

/** Which terrain is wanted, from where. */
struct TerrainRequest {
  geo::GeoBox area;
  std::string server;  ///< empty: environment VOLPLANE_TERRAIN_URL, else the public bucket (kTerrainServer)
  std::string cache;   ///< empty: cacheFolder()
  Patience patience;
};

/** What fetching an area would take. */
struct TerrainEstimate {
  std::string server;
  std::string folder;            ///< where its tiles lie on this machine
  std::vector<TileOffer> tiles;  ///< north to south, west to east
  std::uint64_t bytesToFetch = 0;
  std::uint64_t posts = 0;  ///< of the area, about

  [[nodiscard]] int count(TileState state) const;
  /** "4 tiles: 2 on this machine, 1 to fetch (38.2 MB), 1 sea" */
  [[nodiscard]] std::string inWords() const;
};

/** Looks what is on this machine and asks the server about the rest; fetches nothing but sizes. Without network it works
 *  when all is on this machine.
 *  @errors OutOfRange - no box, or too large;  BadFile - not reachable, no range requests, ...;  Cancelled */
Result<TerrainEstimate> estimateTerrain(const TerrainRequest& request, const Job& job);

struct FetchedTerrain {
  std::vector<std::string> files;  ///< one, or one per spacing of posts; all of them belong into the mission
  std::vector<std::string> notes;  ///< for the operator; one sentence each
};

/** Brings the tiles of an estimate to this machine and cuts the area out of them.
 *  Whole tiles are fetched, not only the area: so that each has a checksum, serves the next area too, and can be taken up where it
 *  broke off.
 *  @param output  GeoTIFF to write   @errors BadFile, OutputFailed, Cancelled; tiles that have come stay, the output is whole or absent */
Result<FetchedTerrain> fetchTerrain(const TerrainRequest& request, const TerrainEstimate& estimate, const std::string& output, const Job& job);

}  // namespace vp::fetch
