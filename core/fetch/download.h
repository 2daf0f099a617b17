#pragma once

#include "core/fetch/http.h"
#include "core/fetch/part_file.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace vp::fetch {

/** A file on a server. */
struct RemoteFile {
  std::uint64_t bytes = 0;
  std::string version;  ///< changes when the file does (ETag or date); empty if the server tells none
};

/** Asks for the first byte, and so learns size and version, and that parts can be asked for.
 *  @return nothing if the server has no such file (404, 410)
 *  @errors BadFile - not reachable, access refused, no range requests;  Cancelled */
Result<std::optional<RemoteFile>> probe(const std::string& url, const Patience& patience, const Job& job);

struct DownloadRequest {
  std::string url;
  Patience patience;
  std::uint64_t block = 4u << 20;                            ///< bytes asked for at a time
  std::function<Result<void>(std::string_view)> checkStart;  ///< looks at the first block before the rest is fetched
};

/** Fetches a file in parts, going on where an earlier try ended if the file on the server is still the same (its version is noted
 *  beside the part, in PART.source). A broken connection is taken up again where it broke, twice in a row without a byte gives up.
 *  On return without error the part holds the whole file.
 *  @return nothing if the server has no such file
 *  @errors BadFile - not reachable, no range requests, changed while it was fetched (the part is emptied);  OutputFailed;  Cancelled.
 *  What came stays in the part. */
Result<std::optional<RemoteFile>> download(const DownloadRequest& request, PartFile& part, const Job& job);

/** "37.4 MB" */
std::string bytesInWords(std::uint64_t bytes);

}  // namespace vp::fetch
