#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/fetch/tile.h"

#include <string>
#include <string_view>

namespace vp::fetch {

/** Whether bytes begin a TIFF file. @errors BadFile saying what they look like instead */
Result<void> checkTiffStart(std::string_view bytes, const std::string& url);

/** Reads a fetched file to its last post and checks that it is one band of heights over the degrees that its name says.
 *  @errors BadFile, Cancelled */
Result<void> checkTile(const std::string& path, TileId tile, const Job& job);

enum class MadeTile {
  Ocean,    ///< sea: zero everywhere
  Unknown,  ///< no data anywhere
};

/** Writes the stand-in for a tile that the server does not have, in the lattice that it would have; band and file say what it is.
 *  @errors OutputFailed */
Result<void> makeTile(const std::string& path, TileId tile, MadeTile kind);

}  // namespace vp::fetch
