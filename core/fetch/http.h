#pragma once

#include "core/base/job.h"
#include "core/base/result.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace vp::fetch {

/** How long a server may keep us waiting. */
struct Patience {
  int connect_s = 5;  ///< until it takes the connection
  int stall_s = 10;   ///< without a byte
};

/** What a server says to a request for a part of a file. */
struct HttpAnswer {
  int status = 0;                      ///< 206 for a part, 200 if it sent the whole instead, 400 and more if it refused
  std::optional<std::uint64_t> total;  ///< size of the whole file, where it was told
  std::string version;                 ///< its ETag, else its date; empty if the server tells neither
  std::string body;                    ///< of a part, as much of it as came; nothing with another status
  bool brokeOff = false;               ///< the connection ended before all bytes asked for had come
};

/// Hears how many bytes of the part are here.
using ByteCount = std::function<void(std::uint64_t bytes)>;

/** Asks for bytes [first, first + count) of a file.
 *  Goes through GDAL's HTTP client, the one below /vsicurl/, so that its settings (GDAL_HTTP_PROXY, CURL_CA_BUNDLE, ...) and the proxies
 *  of the environment count; not through /vsicurl/ itself, which hides status and ETag and keeps caches of its own.
 *  @errors BadFile - no such server, no connection, no answer in time, a certificate that does not fit; Cancelled (at once while
 *  bytes arrive, else within Patience)   @threads pure */
Result<HttpAnswer> httpGetPart(const std::string& url, std::uint64_t first, std::uint64_t count, const Patience& patience, const ByteCount& arrived,
                               const Job& job);

}  // namespace vp::fetch
