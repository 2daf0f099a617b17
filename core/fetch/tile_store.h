#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/fetch/http.h"
#include "core/fetch/tile.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace vp::fetch {

enum class TileState {
  Cached,    ///< on this machine
  OnServer,  ///< to be fetched
  Ocean,     ///< the server has none: sea
  Withheld,  ///< the server has none, and that does not mean sea: unknown
};

struct TileOffer {
  TileId tile;
  TileState state = TileState::OnServer;
  std::uint64_t bytes = 0;  ///< of the file on the server; 0 unless OnServer
  std::uint64_t have = 0;   ///< of these here already, from a fetch that broke off
};

/** Tiles of one server with a folder of those that are here. Each tile NAME.tif stands with NAME.tif.sha256 (for `sha256sum -c`) and
 *  NAME.tif.source (address, version, date, kind); what is not whole yet is NAME.tif.part.
 *  @threads one object per thread; several programs may share the folder */
class TileStore {
public:
  TileStore(std::string base, std::string folder, Patience patience) : base_(std::move(base)), folder_(std::move(folder)), patience_(patience) {}

  /** What is here and what would be fetched. Asks the server only about tiles that are not here.
   *  A tile counts as sea if the server has none and its list of tiles (BASE/tileList.txt) lacks it too. A server without a list is
   *  believed only if it has another tile of the area: else the address may as well be wrong.
   *  @errors BadFile - not reachable, no range requests, no tiles there at all;  Cancelled */
  Result<std::vector<TileOffer>> offers(const std::vector<TileId>& tiles, const Job& job);

  /** Brings a tile here and checks it; what is here is checked by its checksum, and fetched again if that does not fit.
   *  @param notes  receives a sentence about whatever the operator should know
   *  @errors BadFile, OutputFailed, Cancelled */
  Result<void> bring(const TileOffer& offer, std::vector<std::string>& notes, const Job& job);

  [[nodiscard]] std::string pathOf(TileId tile) const { return folder_ + "/" + nameOf(tile) + ".tif"; }
  /** What a cached tile is by its notes. */
  [[nodiscard]] TileState kindOf(TileId tile) const;

private:
  [[nodiscard]] bool isHere(TileId tile) const;
  Result<std::optional<std::set<std::string>>> readList(const Job& job);
  Result<void> askServer(std::vector<TileOffer>& offers, const Job& job);
  Result<void> askForSize(TileOffer& offer, bool isListed, const Job& job);
  Result<void> fetch(const TileOffer& offer, const Job& job);
  Result<void> make(const TileOffer& offer);
  Result<bool> checkSum(TileId tile, const Job& job) const;
  Result<void> seal(TileId tile, const std::string& file, const std::string& kind, const std::string& version, const Job& job) const;
  void forget(TileId tile) const;

  std::string base_;
  std::string folder_;
  Patience patience_;
};

}  // namespace vp::fetch
