#include "core/fetch/download.h"

#include "core/fetch/note_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace vp::fetch {
namespace {

constexpr int kTries = 3;  // in a row without a byte

std::string notesOf(const PartFile& part) {
  return part.path() + ".source";
}

bool isMissing(int status) {
  return status == 404 || status == 410;
}

bool isPassing(int status) {
  return status == 0 || status == 429 || status == 500 || status == 502 || status == 503 || status == 504;
}

tl::unexpected<Error> refusal(int status, const std::string& url) {
  if (status == 200) {
    return fail(Errc::BadFile,
                "the server does not send parts of files (HTTP range requests), so a broken download could not be continued; choose another server",
                url);
  }
  if (status == 401 || status == 403 || status == 407) {
    return fail(Errc::BadFile, fmt::format("the server refuses access (HTTP {}); check the address, or the proxy's settings", status), url);
  }
  if (status == 0) {
    return fail(Errc::BadFile, "the connection breaks off again and again; try again later, what came so far is kept", url);
  }
  return fail(Errc::BadFile, fmt::format("the server answers with HTTP {}; try again later, or check the address", status), url);
}

/// Asks until a part comes, or a refusal that will not pass.
Result<HttpAnswer> ask(const DownloadRequest& request, std::uint64_t first, std::uint64_t count, const ByteCount& arrived, const Job& job) {
  Result<HttpAnswer> answer = httpGetPart(request.url, first, count, request.patience, arrived, job);
  for (int tries = 1; tries < kTries && answer && (isPassing(answer->status) || (answer->brokeOff && answer->body.empty())); ++tries) {
    answer = httpGetPart(request.url, first, count, request.patience, arrived, job);
  }
  if (answer && answer->status == 206 && answer->body.empty()) {
    return refusal(0, request.url);
  }
  return answer;
}

/// How much of an earlier try can be kept.
std::uint64_t keptBytes(const DownloadRequest& request, const PartFile& part) {
  const Notes notes = readNotes(notesOf(part));
  const auto url = notes.find("url");
  return url != notes.end() && url->second == request.url ? part.size() : 0;
}

/// Whether the part was begun from the file that is on the server now.
bool isSame(const PartFile& part, const RemoteFile& remote) {
  Notes notes = readNotes(notesOf(part));
  return !remote.version.empty() && notes["version"] == remote.version && notes["bytes"] == std::to_string(remote.bytes);
}

Result<void> begin(const DownloadRequest& request, PartFile& part, const RemoteFile& remote) {
  if (Result<void> cleared = part.clear(); !cleared) {
    return cleared;
  }
  return writeNotes(notesOf(part), {{"url", request.url}, {"version", remote.version}, {"bytes", std::to_string(remote.bytes)}});
}

tl::unexpected<Error> changed(const std::string& url, PartFile& part) {
  if (const Result<void> cleared = part.clear(); !cleared) {
    return forward(cleared);
  }
  return fail(Errc::BadFile, "the file on the server was changed while it was fetched; fetch it again", url);
}

Result<void> fetchRest(const DownloadRequest& request, PartFile& part, const RemoteFile& remote, const Job& job) {
  while (part.size() < remote.bytes) {
    const std::uint64_t have = part.size();
    const auto tell = [&](std::uint64_t bytes) {
      job.progress(static_cast<double>(have + bytes) / static_cast<double>(remote.bytes),
                   fmt::format("{} of {}", bytesInWords(have + bytes), bytesInWords(remote.bytes)));
    };
    const Result<HttpAnswer> answer = ask(request, have, std::min(request.block, remote.bytes - have), tell, job);
    if (!answer) {
      return forward(answer);
    }
    if (isMissing(answer->status) || (answer->status == 206 && (answer->version != remote.version || answer->total != remote.bytes))) {
      return changed(request.url, part);
    }
    if (answer->status != 206) {
      return refusal(answer->status, request.url);
    }
    if (have == 0 && request.checkStart) {
      if (const Result<void> good = request.checkStart(answer->body); !good) {
        return forward(good);
      }
    }
    if (const Result<void> written = part.append(answer->body); !written) {
      return forward(written);
    }
  }
  return {};
}

}  // namespace

std::string bytesInWords(std::uint64_t bytes) {
  const auto value = static_cast<double>(bytes);
  return bytes < 1000 ? fmt::format("{} bytes", bytes) : value < 1e6 ? fmt::format("{:.0f} kB", value / 1e3) : fmt::format("{:.1f} MB", value / 1e6);
}

Result<std::optional<RemoteFile>> probe(const std::string& url, const Patience& patience, const Job& job) {
  const DownloadRequest request{url, patience, 1, {}};
  const Result<HttpAnswer> answer = ask(request, 0, 1, {}, job);
  if (!answer) {
    return forward(answer);
  }
  if (isMissing(answer->status)) {
    return std::optional<RemoteFile>();
  }
  if (answer->status == 416) {
    return fail(Errc::BadFile, "the file on the server is empty; try again later, or choose another server", url);
  }
  if (answer->status != 206 || !answer->total) {
    return refusal(answer->status == 206 ? 200 : answer->status, url);
  }
  return std::optional(RemoteFile{*answer->total, answer->version});
}

Result<std::optional<RemoteFile>> download(const DownloadRequest& request, PartFile& part, const Job& job) {
  Result<std::optional<RemoteFile>> remote = probe(request.url, request.patience, job);
  if (!remote || !*remote) {
    return remote;
  }
  const bool goesOn = keptBytes(request, part) > 0 && part.size() <= (*remote)->bytes && isSame(part, **remote);
  if (!goesOn) {
    if (const Result<void> begun = begin(request, part, **remote); !begun) {
      return forward(begun);
    }
  }
  if (const Result<void> fetched = fetchRest(request, part, **remote, job); !fetched) {
    return forward(fetched);
  }
  return remote;
}

}  // namespace vp::fetch
