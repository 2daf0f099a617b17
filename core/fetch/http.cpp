#include "core/fetch/http.h"

#include "core/terrain/gdal_support.h"

#include <cpl_conv.h>
#include <cpl_http.h>
#include <cpl_string.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <memory>

namespace vp::fetch {
namespace {

/// Sets one of GDAL's settings for this thread while it lives.
class ThreadSetting {
public:
  ThreadSetting(const char* key, const char* value) : key_(key) {
    if (const char* old = CPLGetThreadLocalConfigOption(key, nullptr); old != nullptr) {
      old_ = old;
    }
    CPLSetThreadLocalConfigOption(key, value);
  }
  ~ThreadSetting() { CPLSetThreadLocalConfigOption(key_, old_ ? old_->c_str() : nullptr); }
  ThreadSetting(const ThreadSetting&) = delete;
  ThreadSetting& operator=(const ThreadSetting&) = delete;

private:
  const char* key_;
  std::optional<std::string> old_;
};

/// Words of a refusal may be longer than the part that was asked for; a body longer than that is the whole file.
constexpr std::uint64_t kSlack = 64u << 10;

/// One running request; GDAL's callbacks get a pointer to it.
struct Transfer {
  const ByteCount& arrived;
  const Job& job;
  std::uint64_t wanted = 0;
  bool isTooMuch = false;  ///< more than was asked for: the server sends the whole file
  std::string body;
};

std::size_t onBytes(void* bytes, std::size_t size, std::size_t count, void* argument) {
  auto& transfer = *static_cast<Transfer*>(argument);
  const std::size_t length = size * count;
  if (transfer.job.stopRequested()) {
    return 0;
  }
  if (transfer.body.size() + length > transfer.wanted + kSlack) {
    transfer.isTooMuch = true;
    return 0;
  }
  transfer.body.append(static_cast<const char*>(bytes), length);
  if (transfer.arrived) {
    transfer.arrived(transfer.body.size());
  }
  return length;
}

int CPL_STDCALL onProgress(double /*done*/, const char* /*text*/, void* argument) {
  return static_cast<Transfer*>(argument)->job.stopRequested() ? FALSE : TRUE;
}

/// The last header of this name: after a redirection the ones before belong to other answers.
std::string headerOf(char** headers, const char* name) {
  std::string value;
  const std::size_t length = std::strlen(name);
  for (char** header = headers; header != nullptr && *header != nullptr; ++header) {
    if (EQUALN(*header, name, length) && ((*header)[length] == '=' || (*header)[length] == ':')) {
      value = *header + length + 1;
    }
  }
  const std::size_t first = value.find_first_not_of(' ');
  return first == std::string::npos ? std::string() : value.substr(first);
}

/// The number behind a text in "bytes 0-99/12345".
std::optional<std::uint64_t> numberBehind(const std::string& contentRange, std::string_view before) {
  const std::size_t at = contentRange.find(before);
  std::uint64_t number = 0;
  if (at == std::string::npos) {
    return std::nullopt;
  }
  const char* end = contentRange.data() + contentRange.size();
  return std::from_chars(contentRange.data() + at + before.size(), end, number).ec == std::errc() ? std::optional(number) : std::nullopt;
}

/// GDAL tells a refusal in words only: "HTTP error code : 404".
int refusalIn(const char* words) {
  constexpr std::string_view kBefore = "HTTP error code : ";
  const char* place = words != nullptr ? std::strstr(words, kBefore.data()) : nullptr;
  int status = 0;
  if (place != nullptr) {
    std::from_chars(place + kBefore.size(), words + std::strlen(words), status);
  }
  return status;
}

/// Numbers of libcurl, curl.se/libcurl/c/libcurl-errors.html.
enum CurlCode {
  kNoProxyName = 5,
  kNoServerName = 6,
  kNoConnection = 7,
  kPartial = 18,
  kTimedOut = 28,
  kTls = 35,
  kEmpty = 52,
  kSend = 55,
  kReceive = 56,
  kBadCertificate = 60
};

Error connectionError(int code, const char* words, const std::string& url) {
  const std::string said = words != nullptr && *words != '\0' ? fmt::format(" ({})", words) : std::string();
  switch (code) {
    case kNoProxyName:
      return {Errc::BadFile, "the proxy that the environment names cannot be found; correct http_proxy or https_proxy" + said, url};
    case kNoServerName:
      return {Errc::BadFile, "the server's name cannot be found; check the network and the address, what was fetched before works without" + said,
              url};
    case kNoConnection:
      return {Errc::BadFile, "no server answers there; check the network and the address, what was fetched before works without" + said, url};
    case kTimedOut:
      return {Errc::BadFile, "the server does not answer in time; try again later, what came so far is kept" + said, url};
    case kTls:
    case kBadCertificate:
      return {Errc::BadFile, "no secure connection to the server could be made; check the system's date and certificates" + said, url};
    default:
      return {Errc::BadFile, "the connection failed; check the network and the address" + said, url};
  }
}

bool isBreak(int code) {
  return code == kPartial || code == kEmpty || code == kSend || code == kReceive || code == kTimedOut;
}

CPLStringList optionsFor(std::uint64_t first, std::uint64_t count, const Patience& patience) {
  CPLStringList options;
  options.SetNameValue("HEADERS", fmt::format("Range: bytes={}-{}", first, first + count - 1).c_str());
  options.SetNameValue("CONNECTTIMEOUT", std::to_string(patience.connect_s).c_str());
  options.SetNameValue("LOW_SPEED_TIME", std::to_string(patience.stall_s).c_str());
  options.SetNameValue("LOW_SPEED_LIMIT", "1");  // bytes per second
  options.SetNameValue("MAX_RETRY", "0");
  return options;
}

}  // namespace

Result<HttpAnswer> httpGetPart(const std::string& url, std::uint64_t first, std::uint64_t count, const Patience& patience, const ByteCount& arrived,
                               const Job& job) {
  const terrain::detail::GdalMessages silence;
  const terrain::detail::NetworkAllowed allowed;
  const ThreadSetting plain("CPL_CURL_GZIP", "NO");  // parts of a packed answer could not be joined
  Transfer transfer{arrived, job, count, false, {}};
  const std::unique_ptr<CPLHTTPResult, decltype(&CPLHTTPDestroyResult)> result(
      CPLHTTPFetchEx(url.c_str(), optionsFor(first, count, patience).List(), &onProgress, &transfer, &onBytes, &transfer), &CPLHTTPDestroyResult);
  if (job.stopRequested()) {
    return fail(Errc::Cancelled, "fetching was stopped; what came so far is kept and will be continued");
  }
  if (result == nullptr) {
    return fail(Errc::Unsupported, "the GDAL library of this system was built without network access", url);
  }
  HttpAnswer answer;
  answer.status = refusalIn(result->pszErrBuf);
  if (answer.status != 0) {
    return answer;
  }
  const std::string range = headerOf(result->papszHeaders, "Content-Range");
  const bool hasFailed = result->nStatus != 0 && !transfer.isTooMuch;
  if (hasFailed && range.empty() && transfer.body.empty() && (!isBreak(result->nStatus) || result->nStatus == kTimedOut)) {
    return tl::unexpected<Error>(connectionError(result->nStatus, result->pszErrBuf, url));
  }
  answer.total = numberBehind(range, "/");
  const bool isThePart = numberBehind(range, "bytes ") == first;
  answer.version = headerOf(result->papszHeaders, "ETag");
  answer.version = answer.version.empty() ? headerOf(result->papszHeaders, "Last-Modified") : answer.version;
  answer.brokeOff = hasFailed;
  answer.status = isThePart ? 206 : hasFailed && transfer.body.empty() && range.empty() ? 0 : 200;
  if (answer.status == 206) {
    answer.body = std::move(transfer.body);
    answer.body.resize(std::min<std::uint64_t>(answer.body.size(), count));
  }
  return answer;
}

}  // namespace vp::fetch
