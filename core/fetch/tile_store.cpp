#include "core/fetch/tile_store.h"

#include "core/fetch/download.h"
#include "core/fetch/note_file.h"
#include "core/fetch/part_file.h"
#include "core/fetch/tile_raster.h"
#include "core/formats/atomic_file.h"
#include "core/terrain/terrain_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

namespace vp::fetch {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kLongestList = 16u << 20;  // bytes; the public one has 26,450 lines, 1.1 MB
constexpr const char* kNameStart = "Copernicus_DSM_COG_10_";

TileState stateWithout(TileId tile) {
  return isWithheld(tile) ? TileState::Withheld : TileState::Ocean;
}

Result<std::set<std::string>> parseList(const std::string& text, const std::string& url) {
  std::set<std::string> names;
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line)) {
    line.erase(line.find_last_not_of(" \r\t") + 1);
    if (line.starts_with(kNameStart)) {
      names.insert(line);
    }
  }
  if (names.empty()) {
    return fail(Errc::BadFile, "the server's list of tiles names none; check the address, and whether the network wants a login first", url);
  }
  return names;
}

std::uint64_t sizeOf(const std::string& path) {
  std::error_code code;
  const std::uintmax_t size = fs::file_size(path, code);
  return code ? 0 : size;
}

}  // namespace

bool TileStore::isHere(TileId tile) const {
  std::error_code code;
  return fs::is_regular_file(pathOf(tile), code) && fs::is_regular_file(pathOf(tile) + ".sha256", code);
}

TileState TileStore::kindOf(TileId tile) const {
  const std::string kind = readNotes(pathOf(tile) + ".source")["kind"];
  return kind == "ocean" ? TileState::Ocean : kind == "unknown" ? TileState::Withheld : TileState::Cached;
}

Result<std::vector<TileOffer>> TileStore::offers(const std::vector<TileId>& tiles, const Job& job) {
  std::vector<TileOffer> offers;
  bool isComplete = true;
  for (const TileId tile : tiles) {
    offers.push_back({tile, isHere(tile) ? TileState::Cached : TileState::OnServer, 0, 0});
    isComplete = isComplete && offers.back().state == TileState::Cached;
  }
  if (!isComplete) {
    if (const Result<void> asked = askServer(offers, job); !asked) {
      return forward(asked);
    }
  }
  return offers;
}

Result<std::optional<std::set<std::string>>> TileStore::readList(const Job& job) {
  const std::string url = base_ + "/tileList.txt";
  std::string text;
  std::string version;
  for (;;) {
    const Result<HttpAnswer> answer = httpGetPart(url, text.size(), 4u << 20, patience_, {}, job);
    if (!answer) {
      return forward(answer);
    }
    if (answer->status == 404 || answer->status == 410) {
      return std::optional<std::set<std::string>>();
    }
    if (answer->status != 206 || !answer->total || answer->body.empty() || *answer->total > kLongestList) {
      const Result<std::optional<RemoteFile>> reason = probe(url, patience_, job);
      return reason ? fail(Errc::BadFile, "the server's list of tiles cannot be read; try again later", url) : forward(reason);
    }
    if (!text.empty() && answer->version != version) {
      return fail(Errc::BadFile, "the server's list of tiles was changed while it was read; try again", url);
    }
    version = answer->version;
    text += answer->body;
    if (text.size() >= *answer->total) {
      break;
    }
  }
  Result<std::set<std::string>> names = parseList(text, url);
  return names ? Result<std::optional<std::set<std::string>>>(std::move(*names)) : forward(names);
}

Result<void> TileStore::askServer(std::vector<TileOffer>& offers, const Job& job) {
  const Result<std::optional<std::set<std::string>>> list = readList(job.part(0.0, 0.3));
  if (!list) {
    return forward(list);
  }
  bool hasAny = list->has_value();
  double done = 0.0;
  for (TileOffer& offer : offers) {
    done += 1.0 / static_cast<double>(offers.size());
    job.progress(0.3 + 0.7 * done, "asking for sizes");
    if (offer.state == TileState::Cached) {
      hasAny = hasAny || kindOf(offer.tile) == TileState::Cached;
      continue;
    }
    const bool isListed = *list && (*list)->contains(nameOf(offer.tile));  // a list may be behind the tiles: they are asked for all the same
    if (const Result<void> asked = askForSize(offer, isListed, job); !asked) {
      return asked;
    }
    hasAny = hasAny || offer.state == TileState::OnServer;
  }
  if (!hasAny) {
    return fail(Errc::BadFile,
                "the server has neither a list of tiles (tileList.txt) nor any tile of this area; it may be sea, or the address is wrong", base_);
  }
  return {};
}

Result<void> TileStore::askForSize(TileOffer& offer, bool isListed, const Job& job) {
  const std::string url = urlOf(base_, offer.tile);
  const Result<std::optional<RemoteFile>> remote = probe(url, patience_, job);
  if (!remote) {
    return forward(remote);
  }
  if (!*remote && isListed) {
    return fail(Errc::BadFile, "the server lists this tile and does not have it; try again later, or choose another server", url);
  }
  if (!*remote) {
    offer.state = stateWithout(offer.tile);
    return {};
  }
  offer.bytes = (*remote)->bytes;
  const Notes part = readNotes(pathOf(offer.tile) + ".part.source");
  const auto version = part.find("version");
  const bool continues = version != part.end() && !version->second.empty() && version->second == (*remote)->version;
  offer.have = continues ? std::min(offer.bytes, sizeOf(pathOf(offer.tile) + ".part")) : 0;
  return {};
}

Result<bool> TileStore::checkSum(TileId tile, const Job& job) const {
  const Result<std::string> sum = terrain::sha256OfFile(pathOf(tile), job);
  if (!sum) {
    return forward(sum);
  }
  std::ifstream file(pathOf(tile) + ".sha256");
  std::string noted;
  file >> noted;
  return noted == *sum;
}

void TileStore::forget(TileId tile) const {
  std::error_code ignored;
  for (const char* ending : {"", ".sha256", ".source"}) {
    fs::remove(pathOf(tile) + ending, ignored);
  }
}

Result<void> TileStore::seal(TileId tile, const std::string& file, const std::string& kind, const std::string& version, const Job& job) const {
  const Result<std::string> sum = terrain::sha256OfFile(file, job);
  if (!sum) {
    return forward(sum);
  }
  const Notes notes{
      {"kind", kind}, {"url", urlOf(base_, tile)}, {"version", version}, {"fetched", timeNow()}, {"bytes", std::to_string(sizeOf(file))}};
  if (Result<void> written = writeNotes(pathOf(tile) + ".source", notes); !written) {
    return written;
  }
  return formats::writeFileAtomically(pathOf(tile) + ".sha256", fmt::format("{}  {}.tif\n", *sum, nameOf(tile)));
}

Result<void> TileStore::make(const TileOffer& offer) {
  const bool isSea = offer.state == TileState::Ocean;
  if (Result<void> made = makeTile(pathOf(offer.tile), offer.tile, isSea ? MadeTile::Ocean : MadeTile::Unknown); !made) {
    return made;
  }
  return seal(offer.tile, pathOf(offer.tile), isSea ? "ocean" : "unknown", "", Job{});
}

Result<void> TileStore::fetch(const TileOffer& offer, const Job& job) {
  Result<PartFile> part = PartFile::acquire(pathOf(offer.tile) + ".part", job);
  if (!part) {
    return forward(part);
  }
  if (isHere(offer.tile)) {
    return {};  // another program fetched it meanwhile
  }
  const std::string url = urlOf(base_, offer.tile);
  DownloadRequest request{url, patience_, 4u << 20, [&url](std::string_view bytes) { return checkTiffStart(bytes, url); }};
  const Result<std::optional<RemoteFile>> remote = download(request, *part, job.part(0.0, 0.9));
  if (!remote) {
    return forward(remote);
  }
  if (!*remote) {
    return fail(Errc::BadFile, "the server does not have this tile any more; try again later", url);
  }
  if (const Result<void> good = checkTile(part->path(), offer.tile, job); !good) {
    if (good.error().code != Errc::Cancelled) {
      part->drop();
      Error error = good.error();
      error.where = url;
      return tl::unexpected<Error>(error);
    }
    return good;
  }
  if (Result<void> sealed = seal(offer.tile, part->path(), "terrain", (*remote)->version, job); !sealed) {
    return sealed;
  }
  return part->finish(pathOf(offer.tile));
}

Result<void> TileStore::bring(const TileOffer& offer, std::vector<std::string>& notes, const Job& job) {
  if (Result<void> made = makeFolder(folder_); !made) {
    return made;
  }
  TileOffer wanted = offer;
  const std::string name = shortNameOf(offer.tile);
  if (offer.state == TileState::Cached) {
    const Result<bool> fits = checkSum(offer.tile, job);
    if (!fits) {
      return forward(fits);
    }
    if (*fits) {
      return {};
    }
    const TileState kind = kindOf(offer.tile);
    notes.push_back(fmt::format("the cached tile {} was damaged (its checksum did not fit) and was made or fetched again", name));
    forget(offer.tile);
    wanted.state = kind == TileState::Cached ? TileState::OnServer : kind;
    if (Result<void> again = bring(wanted, notes, job); !again) {
      Error error = again.error();
      error.what = fmt::format("the cached tile {} is damaged, its checksum does not fit, and it cannot be fetched again: {}", name, error.what);
      return tl::unexpected<Error>(error);
    }
    return {};
  }
  return wanted.state == TileState::OnServer ? fetch(wanted, job) : make(wanted);
}

}  // namespace vp::fetch
