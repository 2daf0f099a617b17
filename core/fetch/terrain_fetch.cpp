#include "core/fetch/terrain_fetch.h"

#include "core/fetch/cache_folder.h"
#include "core/fetch/download.h"
#include "core/fetch/terrain_area.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace vp::fetch {
namespace {

struct Where {
  std::string server;
  std::string folder;
};

Result<Where> placesOf(const TerrainRequest& request) {
  const std::string asked = request.server.empty() ? fromEnvironment("VOLPLANE_TERRAIN_URL", kTerrainServer) : request.server;
  Result<std::string> server = checkedBase(asked);
  if (!server) {
    return forward(server);
  }
  const Result<std::string> cache = request.cache.empty() ? cacheFolder() : Result<std::string>(request.cache);
  if (!cache) {
    return forward(cache);
  }
  return Where{*server, folderOfServer(*cache, "terrain", *server)};
}

const char* wordOf(TileState state) {
  switch (state) {
    case TileState::Ocean:
      return "ocean";
    case TileState::Withheld:
      return "unknown";
    default:
      return "terrain";
  }
}

/// What the operator should know about tiles that are none.
void noteStandIns(const std::vector<TileFile>& files, std::vector<std::string>& notes) {
  std::string sea;
  std::string unknown;
  for (const TileFile& file : files) {
    std::string& names = file.kind == "ocean" ? sea : unknown;
    if (file.kind != "terrain") {
      names += (names.empty() ? "" : ", ") + shortNameOf(file.tile);
    }
  }
  if (!sea.empty()) {
    notes.push_back(fmt::format("no terrain on the server for {}: taken as sea, flat at 0 m", sea));
  }
  if (!unknown.empty()) {
    notes.push_back(fmt::format("no terrain is published for {}: nothing is known there, so nothing counts as safe there", unknown));
  }
}

}  // namespace

int TerrainEstimate::count(TileState state) const {
  return static_cast<int>(std::count_if(tiles.begin(), tiles.end(), [state](const TileOffer& offer) { return offer.state == state; }));
}

std::string TerrainEstimate::inWords() const {
  const int here = count(TileState::Cached);
  const int there = count(TileState::OnServer);
  std::string words = tiles.size() == 1 ? fmt::format("1 tile: {} on this machine, {} to fetch", here, there)
                                        : fmt::format("{} tiles: {} on this machine, {} to fetch", tiles.size(), here, there);
  if (bytesToFetch > 0) {
    words += fmt::format(" ({})", bytesInWords(bytesToFetch));
  }
  if (const int sea = count(TileState::Ocean); sea > 0) {
    words += fmt::format(", {} sea", sea);
  }
  if (const int unknown = count(TileState::Withheld); unknown > 0) {
    words += fmt::format(", {} not published", unknown);
  }
  return words;
}

Result<TerrainEstimate> estimateTerrain(const TerrainRequest& request, const Job& job) {
  const Result<std::vector<TileId>> tiles = tilesUnder(request.area);
  if (!tiles) {
    return forward(tiles);
  }
  Result<Where> where = placesOf(request);
  if (!where) {
    return forward(where);
  }
  Result<std::vector<TileOffer>> offers = TileStore(where->server, where->folder, request.patience).offers(*tiles, job);
  if (!offers) {
    return forward(offers);
  }
  TerrainEstimate estimate{where->server, where->folder, std::move(*offers), 0, 0};
  for (const TileOffer& offer : estimate.tiles) {
    estimate.bytesToFetch += offer.bytes - offer.have;
    const double width = std::min(request.area.northEast.longitude_deg, offer.tile.west + 1.0) -
                         std::max(request.area.southWest.longitude_deg, static_cast<double>(offer.tile.west));
    const double height = std::min(request.area.northEast.latitude_deg, offer.tile.south + 1.0) -
                          std::max(request.area.southWest.latitude_deg, static_cast<double>(offer.tile.south));
    estimate.posts += static_cast<std::uint64_t>(width * columnsOf(offer.tile) * height * 3600.0);
  }
  return estimate;
}

Result<FetchedTerrain> fetchTerrain(const TerrainRequest& request, const TerrainEstimate& estimate, const std::string& output, const Job& job) {
  FetchedTerrain fetched;
  TileStore store(estimate.server, estimate.folder, request.patience);
  std::vector<TileFile> files;
  double all = 0.0;
  for (const TileOffer& offer : estimate.tiles) {
    all += static_cast<double>(offer.bytes - offer.have) + 1e6;  // a stand-in or a checksum counts as a megabyte
  }
  double done = 0.0;
  for (const TileOffer& offer : estimate.tiles) {
    const double share = (static_cast<double>(offer.bytes - offer.have) + 1e6) / all;
    const std::string name = shortNameOf(offer.tile);
    const Job part = job.part(0.9 * done, 0.9 * (done + share));
    const Job told(job.stopToken(), [&](double fraction, std::string_view text) { part.progress(fraction, fmt::format("{}: {}", name, text)); });
    if (const Result<void> here = store.bring(offer, fetched.notes, told); !here) {
      return forward(here);
    }
    files.push_back({offer.tile, store.pathOf(offer.tile), wordOf(store.kindOf(offer.tile))});
    done += share;
  }
  Result<std::vector<std::string>> cut = cutArea(files, request.area, output, job.part(0.9, 1.0));
  if (!cut) {
    return forward(cut);
  }
  fetched.files = std::move(*cut);
  noteStandIns(files, fetched.notes);
  if (fetched.files.size() > 1) {
    fetched.notes.emplace_back(
        "the area crosses a parallel where the spacing of posts changes, so it is in several files; a mission needs all of them");
  }
  return fetched;
}

}  // namespace vp::fetch
