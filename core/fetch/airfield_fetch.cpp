#include "core/fetch/airfield_fetch.h"

#include "core/fetch/cache_folder.h"
#include "core/fetch/download.h"
#include "core/fetch/note_file.h"
#include "core/fetch/part_file.h"
#include "core/formats/airfields.h"

#include <array>
#include <filesystem>
#include <system_error>

namespace vp::fetch {
namespace {

namespace fs = std::filesystem;

struct Where {
  std::string server;
  std::string folder;
  [[nodiscard]] std::string file(const char* name) const { return folder + "/" + name; }
  [[nodiscard]] std::string url(const char* name) const { return server + "/" + name; }
};

constexpr std::array<const char*, 2> kFiles{"airports.csv", "runways.csv"};

Result<Where> placesOf(const AirfieldRequest& request) {
  Result<std::string> server = checkedBase(request.server.empty() ? fromEnvironment("VOLPLANE_AIRFIELDS_URL", kAirfieldServer) : request.server);
  if (!server) {
    return forward(server);
  }
  const Result<std::string> cache = request.cache.empty() ? cacheFolder() : Result<std::string>(request.cache);
  if (!cache) {
    return forward(cache);
  }
  return Where{*server, folderOfServer(*cache, "airfields", *server)};
}

bool isHere(const Where& where) {
  std::error_code code;
  return fs::is_regular_file(where.file(kFiles[0]), code) && fs::is_regular_file(where.file(kFiles[1]), code);
}

/// A web page in place of a table is recognised before all of it is fetched.
Result<void> checkStart(std::string_view bytes, const std::string& url) {
  const std::string_view line = bytes.substr(0, bytes.find('\n'));
  if (line.find("ident") == std::string_view::npos || line.find(',') == std::string_view::npos) {
    return fail(Errc::BadFile, "the server sends no table of OurAirports; check the address, and whether the network wants a login first", url);
  }
  return {};
}

Result<RemoteFile> probed(const Where& where, const char* name, const Patience& patience, const Job& job) {
  const Result<std::optional<RemoteFile>> remote = probe(where.url(name), patience, job);
  if (!remote) {
    return forward(remote);
  }
  if (!*remote) {
    return fail(Errc::BadFile, "the server has no such file; check the address", where.url(name));
  }
  return **remote;
}

bool isNoted(const Where& where, const char* name, const RemoteFile& remote) {
  Notes notes = readNotes(where.file(name) + ".source");
  return !remote.version.empty() && notes["version"] == remote.version && notes["bytes"] == std::to_string(remote.bytes);
}

Result<void> fetchTable(const Where& where, const char* name, const AirfieldRequest& request, PartFile& part, const Job& job) {
  const std::string url = where.url(name);
  const DownloadRequest asked{url, request.patience, 4u << 20, [&url](std::string_view bytes) { return checkStart(bytes, url); }};
  const Result<std::optional<RemoteFile>> remote = download(asked, part, job);
  if (!remote) {
    return forward(remote);
  }
  return *remote ? Result<void>() : fail(Errc::BadFile, "the server has no such file; check the address", url);
}

Result<void> putInPlace(const Where& where, const char* name, const std::string& version, PartFile& part) {
  const Notes notes{{"url", where.url(name)}, {"version", version}, {"bytes", std::to_string(part.size())}, {"fetched", timeNow()}};
  if (Result<void> placed = part.finish(where.file(name)); !placed) {
    return placed;
  }
  return writeNotes(where.file(name) + ".source", notes);
}

/// Fetches both into parts, reads them as a whole, and only then gives them their names.
Result<std::size_t> replaceTables(const Where& where, const AirfieldRequest& request, const std::array<RemoteFile, 2>& remote, const Job& job) {
  Result<PartFile> airports = PartFile::acquire(where.file(kFiles[0]) + ".part", job);
  if (!airports) {
    return forward(airports);
  }
  Result<PartFile> runways = PartFile::acquire(where.file(kFiles[1]) + ".part", job);
  if (!runways) {
    return forward(runways);
  }
  const double share = static_cast<double>(remote[0].bytes) / static_cast<double>(remote[0].bytes + remote[1].bytes);
  if (const Result<void> fetched = fetchTable(where, kFiles[0], request, *airports, job.part(0.0, 0.9 * share)); !fetched) {
    return forward(fetched);
  }
  if (const Result<void> fetched = fetchTable(where, kFiles[1], request, *runways, job.part(0.9 * share, 0.9)); !fetched) {
    return forward(fetched);
  }
  job.progress(0.9, "reading the airfields");
  const Result<formats::AirfieldReport> report = formats::readOurAirports(airports->path(), runways->path(), {}, std::nullopt);
  if (!report || report->sites.empty()) {
    airports->drop();
    runways->drop();
    return report ? fail(Errc::BadFile, "what the server sent holds no landing site; the files from before stay", where.server)
                  : tl::unexpected<Error>(Error{report.error().code,
                                                "what the server sent is no table of OurAirports, the files from before stay: " + report.error().what,
                                                report.error().where});
  }
  for (const auto& [name, part, version] :
       {std::tuple{kFiles[1], &*runways, remote[1].version}, std::tuple{kFiles[0], &*airports, remote[0].version}}) {
    if (const Result<void> placed = putInPlace(where, name, version, *part); !placed) {
      return forward(placed);
    }
  }
  return report->sites.size();
}

AirfieldFiles filesOf(const Where& where) {
  return {where.file(kFiles[0]), where.file(kFiles[1]), readNotes(where.file(kFiles[0]) + ".source")["fetched"], 0, 0, false};
}

}  // namespace

Result<std::optional<AirfieldFiles>> cachedAirfields(const AirfieldRequest& request) {
  const Result<Where> where = placesOf(request);
  if (!where) {
    return forward(where);
  }
  return isHere(*where) ? std::optional(filesOf(*where)) : std::nullopt;
}

Result<std::uint64_t> airfieldBytes(const AirfieldRequest& request, const Job& job) {
  const Result<Where> where = placesOf(request);
  if (!where) {
    return forward(where);
  }
  std::uint64_t bytes = 0;
  bool isUpToDate = isHere(*where);
  for (const char* name : kFiles) {
    const Result<RemoteFile> remote = probed(*where, name, request.patience, job);
    if (!remote) {
      return forward(remote);
    }
    bytes += remote->bytes;
    isUpToDate = isUpToDate && isNoted(*where, name, *remote);
  }
  return isUpToDate ? 0 : bytes;
}

Result<AirfieldFiles> updateAirfields(const AirfieldRequest& request, const Job& job) {
  const Result<Where> where = placesOf(request);
  if (!where) {
    return forward(where);
  }
  if (const Result<void> made = makeFolder(where->folder); !made) {
    return forward(made);
  }
  std::array<RemoteFile, 2> remote;
  bool isUpToDate = isHere(*where);
  for (std::size_t i = 0; i < kFiles.size(); ++i) {
    const Result<RemoteFile> one = probed(*where, kFiles[i], request.patience, job);
    if (!one) {
      return forward(one);
    }
    remote[i] = *one;
    isUpToDate = isUpToDate && isNoted(*where, kFiles[i], *one);
  }
  if (isUpToDate) {
    AirfieldFiles files = filesOf(*where);
    files.wasUpToDate = true;
    return files;
  }
  const Result<std::size_t> sites = replaceTables(*where, request, remote, job);
  if (!sites) {
    return forward(sites);
  }
  AirfieldFiles files = filesOf(*where);
  files.sites = *sites;
  files.bytes = remote[0].bytes + remote[1].bytes;
  return files;
}

}  // namespace vp::fetch
