#include "core/fetch/cache_folder.h"

#include <cctype>
#include <cstdlib>

namespace vp::fetch {

std::string fromEnvironment(const char* variable, const std::string& otherwise) {
  const char* value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): nobody sets the environment while jobs run
  return value != nullptr && *value != '\0' ? std::string(value) : otherwise;
}

Result<std::string> cacheFolder() {
  const std::string cache = fromEnvironment("XDG_CACHE_HOME", "");
  if (!cache.empty() && cache.front() == '/') {  // the specification wants relative ones ignored
    return cache + "/volplane";
  }
  const std::string home = fromEnvironment("HOME", "");
  if (home.empty()) {
    return fail(Errc::OutputFailed, "neither XDG_CACHE_HOME nor HOME is set, so there is no place for the cache; name a folder");
  }
  return home + "/.cache/volplane";
}

std::string folderOfServer(const std::string& cache, const std::string& what, const std::string& base) {
  std::string name;
  for (const char c : base.substr(base.find("://") + 3)) {
    name += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' ? c : '_';
  }
  return cache + "/" + what + "/" + name;
}

Result<std::string> checkedBase(const std::string& base) {
  std::string address = base;
  while (!address.empty() && address.back() == '/') {
    address.pop_back();
  }
  const bool good = address.starts_with("https://") || address.starts_with("http://");
  const bool odd = address.find_first_of(" \t\r\n\"<>?#") != std::string::npos;
  if (!good || odd || address.size() <= std::string("https://").size()) {
    return fail(Errc::OutOfRange, "this is no address of a server; it begins with https:// and has neither spaces nor ?", base);
  }
  return address;
}

}  // namespace vp::fetch
